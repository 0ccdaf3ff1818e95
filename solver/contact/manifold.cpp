#include "solver/contact/manifold.hpp"

#include <algorithm>

namespace byhand {
namespace {

/// A difference of positions shorter than this [m] is rounding and has no direction.
constexpr double no_distance = 1e-14;

template <class M>
Manifold<M> one_point(const Linear<M>& normal, const Linear<M>& p1, const Linear<M>& p2, double separation) {
  Manifold<M> manifold;
  manifold.normal = normal;
  manifold.add({p1, p2, separation});
  return manifold;
}

// Points of two shapes at any separation: each pair of kinds in one order.

template <class M>
Manifold<M> collide_kinds(const Ball<M>& ball1, const Pose<M>& pose1, const Ball<M>& ball2, const Pose<M>& pose2) {
  const Linear<M> between = pose2.position - pose1.position;
  const double distance = between.norm();
  Linear<M> n = Linear<M>::Unit(M::linear - 1);
  if (distance > no_distance) n = between / distance;
  return one_point<M>(n, pose1.position + ball1.radius * n, pose2.position - ball2.radius * n,
                      distance - ball1.radius - ball2.radius);
}

template <class M>
Manifold<M> collide_kinds(const Box<M>& box, const Pose<M>& pose1, const Ball<M>& ball, const Pose<M>& pose2) {
  const Linear<M> centre = arm_to<M>(pose1, pose2.position), half = box.half();  // in the axes of the box
  Linear<M> nearest = centre.cwiseMin(half).cwiseMax(-half), n = centre - nearest;
  double height = n.norm();  // of the ball's centre above the box
  if (height > no_distance) {
    n /= height;
  } else {  // the centre is inside: leave through the nearest side
    int axis;
    height = -(half - centre.cwiseAbs()).minCoeff(&axis);
    n = Linear<M>::Unit(axis) * (centre[axis] < 0 ? -1 : 1);
    nearest[axis] = n[axis] * half[axis];
  }
  const Linear<M> normal = rotate(pose1.rotation, n);
  return one_point<M>(normal, pose1.position + rotate(pose1.rotation, nearest),
                      pose2.position - ball.radius * normal, height - ball.radius);
}

template <class M>
Manifold<M> collide_kinds(const HalfSpace<M>& half_space, const Pose<M>& pose1, const Ball<M>& ball,
                          const Pose<M>& pose2) {
  const Linear<M> n = detail::turned<M>(pose1, half_space.normal);
  const double height = n.dot(pose2.position - pose1.position);
  return one_point<M>(n, pose2.position - height * n, pose2.position - ball.radius * n, height - ball.radius);
}

/// The corners of the face that is most nearly parallel to the plane, on the box's lower side.
template <class M>
Manifold<M> collide_kinds(const HalfSpace<M>& half_space, const Pose<M>& pose1, const Box<M>& box,
                          const Pose<M>& pose2) {
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
    const Linear<M> p2 = pose2.position + axes * box.half().cwiseProduct(side);
    manifold.add({p2 - separation * manifold.normal, p2, separation, corner});
  }
  return manifold;
}

}  // namespace

template <class M>
Manifold<M> collide(const Shape<M>& shape1, const Pose<M>& pose1, const Shape<M>& shape2, const Pose<M>& pose2,
                    double margin, std::uint32_t hint) {
  Manifold<M> manifold = std::visit(
      [&](const auto& kind1, const auto& kind2) -> Manifold<M> {
        if constexpr (requires { collide_boxes(kind1, pose1, kind2, pose2, margin, hint); })
          return collide_boxes(kind1, pose1, kind2, pose2, margin, hint);
        else if constexpr (requires { collide_kinds<M>(kind1, pose1, kind2, pose2); })
          return collide_kinds<M>(kind1, pose1, kind2, pose2);
        else if constexpr (requires { collide_kinds<M>(kind2, pose2, kind1, pose1); })
          return mirrored<M>(collide_kinds<M>(kind2, pose2, kind1, pose1));
        else
          return {};
      },
      shape1, shape2);
  const auto too_far = [&](const ContactPoint<M>& point) { return !(point.separation <= margin); };
  ContactPoint<M>* const points = manifold.points.data();
  manifold.size = static_cast<int>(std::remove_if(points, points + manifold.size, too_far) - points);
  return manifold;
}

#define BYHAND_INSTANTIATE(M)                                                                               \
  template Manifold<M> collide<M>(const Shape<M>&, const Pose<M>&, const Shape<M>&, const Pose<M>&, double, \
                                  std::uint32_t)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
