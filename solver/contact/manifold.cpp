#include "solver/contact/manifold.hpp"

#include "solver/contact/boxes_in_plane.hpp"
#include "solver/contact/boxes_in_space.hpp"

namespace byhand {
namespace {

/// Nearer than this [m], a difference of positions is rounding and has no direction.
constexpr double no_distance = 1e-14;

/// The manifold of one touch, or of none beyond `margin`.
template <class M>
Manifold<M> one_point(const Linear<M>& normal, const TouchPoint<M>& point, double margin) {
  Manifold<M> manifold;
  if (!(point.separation <= margin)) return manifold;
  manifold.normal = normal;
  manifold.add(point);
  return manifold;
}

template <class M>
Manifold<M> touch_kinds(const Ball<M>& ball1, const Pose<M>& pose1, const Ball<M>& ball2, const Pose<M>& pose2,
                        double margin, std::uint32_t) {
  const Linear<M> between = pose2.position - pose1.position;
  const double distance = between.norm();
  const Linear<M> n =
      distance > no_distance ? Linear<M>(between / distance) : Linear<M>(Linear<M>::Unit(M::linear - 1));
  const Linear<M> p1 = pose1.position + ball1.radius * n, p2 = pose2.position - ball2.radius * n;
  return one_point<M>(n, {p1, p2, distance - ball1.radius - ball2.radius}, margin);
}

template <class M>
Manifold<M> touch_kinds(const Box<M>& box, const Pose<M>& pose1, const Ball<M>& ball, const Pose<M>& pose2,
                        double margin, std::uint32_t) {
  const Linear<M> centre = rotate(inverse(pose1.rotation), Linear<M>(pose2.position - pose1.position));
  const Linear<M> half = box.half();
  Linear<M> nearest = centre.cwiseMin(half).cwiseMax(-half), n = centre - nearest;
  double height = n.norm();  // of the ball's centre over the box
  if (height > no_distance) {
    n /= height;
  } else {  // the centre is inside: the nearest side is the way out
    int axis;
    height = -(half - centre.cwiseAbs()).minCoeff(&axis);
    n = Linear<M>::Unit(axis) * (centre[axis] < 0 ? -1 : 1);
    nearest[axis] = n[axis] * half[axis];
  }
  const Linear<M> normal = rotate(pose1.rotation, n);
  const Linear<M> p1 = pose1.position + rotate(pose1.rotation, nearest),
                  p2 = pose2.position - ball.radius * normal;
  return one_point<M>(normal, {p1, p2, height - ball.radius}, margin);
}

template <class M>
Manifold<M> touch_kinds(const HalfSpace<M>& half_space, const Pose<M>& pose1, const Ball<M>& ball,
                        const Pose<M>& pose2, double margin, std::uint32_t) {
  const Linear<M> n = detail::turned<M>(pose1, half_space.normal);
  const double height = n.dot(pose2.position - pose1.position);
  return one_point<M>(n, {pose2.position - height * n, pose2.position - ball.radius * n, height - ball.radius},
                      margin);
}

/// The corners of one face, the one that holds the deepest corner and reaches least high above it.
template <class M>
Manifold<M> touch_kinds(const HalfSpace<M>& half_space, const Pose<M>& pose1, const Box<M>& box,
                        const Pose<M>& pose2, double margin, std::uint32_t) {
  Manifold<M> manifold;
  manifold.normal = detail::turned<M>(pose1, half_space.normal);
  const auto axes = detail::axes<M>(pose2);
  const Linear<M> rise = (axes.transpose() * manifold.normal).cwiseProduct(box.half());  // of a corner, by axis
  const double height = manifold.normal.dot(pose2.position - pose1.position);
  int steepest;
  rise.cwiseAbs().maxCoeff(&steepest);
  for (std::uint32_t corner = 0; corner < 1u << M::linear; ++corner) {
    Linear<M> side;
    for (int i = 0; i < M::linear; ++i) side[i] = corner >> i & 1 ? 1 : -1;
    if ((rise[steepest] > 0) == (side[steepest] > 0)) continue;
    const double separation = height + rise.dot(side);
    if (!(separation <= margin)) continue;
    const Linear<M> p2 = pose2.position + axes * box.half().cwiseProduct(side);
    manifold.add({p2 - separation * manifold.normal, p2, separation, corner});
  }
  return manifold;
}

template <class M>
Manifold<M> touch_kinds(const Box<M>& box1, const Pose<M>& pose1, const Box<M>& box2, const Pose<M>& pose2,
                        double margin, std::uint32_t hint) {
  return touch_boxes(box1, pose1, box2, pose2, margin, hint);
}

/// Each pair of kinds is written one way round above; half-spaces and bodies without a shape meet nobody.
template <class M, class A, class B>
Manifold<M> touch_either_way(const A& shape1, const Pose<M>& pose1, const B& shape2, const Pose<M>& pose2,
                             double margin, std::uint32_t hint) {
  if constexpr (requires { touch_kinds<M>(shape1, pose1, shape2, pose2, margin, hint); })
    return touch_kinds<M>(shape1, pose1, shape2, pose2, margin, hint);
  else if constexpr (requires { touch_kinds<M>(shape2, pose2, shape1, pose1, margin, hint); })
    return mirrored<M>(touch_kinds<M>(shape2, pose2, shape1, pose1, margin, hint));
  else
    return {};
}

}  // namespace

template <class M>
Manifold<M> touch(const Shape<M>& shape1, const Pose<M>& pose1, const Shape<M>& shape2, const Pose<M>& pose2,
                  double margin, std::uint32_t hint) {
  return std::visit(
      [&](const auto& kind1, const auto& kind2) {
        return touch_either_way<M>(kind1, pose1, kind2, pose2, margin, hint);
      },
      shape1, shape2);
}

#define BYHAND_TOUCH(M)                                                                                          \
  template Manifold<M> touch<M>(const Shape<M>&, const Pose<M>&, const Shape<M>&, const Pose<M>&, double margin, \
                                std::uint32_t hint);
BYHAND_TOUCH(PlaneParticle)
BYHAND_TOUCH(PlaneBody)
BYHAND_TOUCH(SpaceParticle)
BYHAND_TOUCH(SpaceBody)

}  // namespace byhand
