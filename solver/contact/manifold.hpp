#pragma once

#include <array>
#include <cstdint>

#include "solver/contact/shape.hpp"

// Narrow phase: n, P1 and P2 of (23) at each contact point of two shapes, from shapes and poses alone.
namespace byhand {

/// One point on each surface, in the world [m].
template <class M>
struct ContactPoint {
  Linear<M> p1 = Linear<M>::Zero(), p2 = Linear<M>::Zero();
  double separation = 0;      // C of (23): (p2 - p1) · n [m], negative in overlap
  std::uint32_t feature = 0;  // the corners or edges that meet; unique in its manifold, the same from step to step
};

template <class M>
struct Manifold {
  static constexpr int capacity = M::linear == 2 ? 2 : 4;

  Linear<M> normal = Linear<M>::Zero();  // n, a unit vector in the world, from shape 1 to shape 2
  std::array<ContactPoint<M>, capacity> points;
  int size = 0;                 // number of points; without any, the normal has no meaning
  std::uint32_t reference = 0;  // of two boxes: the separating axis that gave n; a hint for the next step

  const ContactPoint<M>* begin() const { return points.data(); }
  const ContactPoint<M>* end() const { return points.data() + size; }
  bool empty() const { return size == 0; }
  double gap() const {  // the least separation [m]
    double least = std::numeric_limits<double>::infinity();
    for (const ContactPoint<M>& point : *this) least = std::min(least, point.separation);
    return least;
  }
  void add(const ContactPoint<M>& point) { points[size++] = point; }
};

/// The reference of two boxes changes only where another one's separation is larger by this share of the shortest
/// side.
inline constexpr double reference_hysteresis = 0.002;
template <class M>
double hysteresis(const Box<M>& box1, const Box<M>& box2) {
  return reference_hysteresis * std::min(box1.sides.minCoeff(), box2.sides.minCoeff());
}

/// The contact points of two shapes whose separation is at most `margin` [m] >= 0.
///
/// The normal is the direction of least penetration, or of the least distance between separate shapes. Balls with
/// the same centre get the last axis of the world, boxes with the same centre a positive axis of the first. `hint`
/// is the `reference` of the last step's manifold, 0 without one. Half-spaces do not collide with each other.
template <class M>
Manifold<M> collide(const Shape<M>& shape1, const Pose<M>& pose1, const Shape<M>& shape2, const Pose<M>& pose2,
                    double margin, std::uint32_t hint = 0);

/// `collide` of two boxes, by separating axes and clipping.
Manifold<PlaneBody> collide_boxes(const Box<PlaneBody>& box1, const Pose<PlaneBody>& pose1,
                                  const Box<PlaneBody>& box2, const Pose<PlaneBody>& pose2, double margin,
                                  std::uint32_t hint);
Manifold<SpaceBody> collide_boxes(const Box<SpaceBody>& box1, const Pose<SpaceBody>& pose1,
                                  const Box<SpaceBody>& box2, const Pose<SpaceBody>& pose2, double margin,
                                  std::uint32_t hint);

/// The same manifold with the two shapes swapped.
template <class M>
Manifold<M> mirrored(Manifold<M> manifold) {
  manifold.normal = -manifold.normal;
  for (ContactPoint<M>& point : manifold.points) std::swap(point.p1, point.p2);
  return manifold;
}

}  // namespace byhand
