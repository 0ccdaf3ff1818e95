#pragma once

#include <array>
#include <cstdint>

#include "solver/contact/shape.hpp"

// Where two shapes touch, or are about to: (23)'s n, P1 and P2 at every point, found from shapes and poses alone.
namespace byhand {

/// Two points that are to stay apart: one on each surface, in the world [m].
template <class M>
struct TouchPoint {
  Linear<M> p1 = Linear<M>::Zero(), p2 = Linear<M>::Zero();
  double separation = 0;      // C of (23): (p2 - p1) · n [m], negative in overlap
  std::uint32_t feature = 0;  // which corners or edges meet here; unique in its manifold, and kept while they do
};

template <class M>
struct Manifold {
  static constexpr int capacity = M::linear == 2 ? 2 : 4;

  Linear<M> normal = Linear<M>::Zero();  // n, a unit vector in the world, from shape 1 to shape 2
  std::array<TouchPoint<M>, capacity> points;
  int size = 0;                 // how many of them there are; without any, the normal has no meaning
  std::uint32_t reference = 0;  // between boxes: what gave n; a hint for the next step

  const TouchPoint<M>* begin() const { return points.data(); }
  const TouchPoint<M>* end() const { return points.data() + size; }
  bool empty() const { return size == 0; }
  void add(const TouchPoint<M>& point) { points[size++] = point; }
};

/// How much better [m] another face must be before boxes change the one that gives the normal.
inline constexpr double reference_hysteresis = 0.002;

/// The points of two shapes whose separation is at most `margin` [m] >= 0.
///
/// The normal is the direction of the least translation that parts the shapes, or of the least distance between
/// them. It is the last axis of the world between balls with one centre, and the positive axis of the first shape
/// between boxes with one centre. `hint` is the `reference` of the manifold that these two had a step ago, 0 if
/// they had none: within `reference_hysteresis` the normal stays with what gave it then.
///
/// Half-spaces do not touch each other.
template <class M>
Manifold<M> touch(const Shape<M>& shape1, const Pose<M>& pose1, const Shape<M>& shape2, const Pose<M>& pose2,
                  double margin, std::uint32_t hint = 0);

/// The same manifold seen from the other shape.
template <class M>
Manifold<M> mirrored(Manifold<M> manifold) {
  manifold.normal = -manifold.normal;
  for (TouchPoint<M>& point : manifold.points) std::swap(point.p1, point.p2);
  return manifold;
}

}  // namespace byhand
