#include "solver/contact/manifold.hpp"

#include "solver/support/each_model.hpp"

namespace byhand {
namespace {

/// A difference of positions shorter than this share of a body's size is rounding and has no direction.
constexpr double no_distance = 1e-14;

/// The point of a shape's surface that is nearest to some point, the outward normal there, and the height of that
/// point above it [m], negative inside the shape.
template <class M>
struct Nearest {
  Linear<M> normal, point;
  double height;
};

template <class M>
Nearest<M> nearest(const Ball<M>& ball, const Pose<M>& pose, const Linear<M>& point) {
  const Linear<M> between = point - pose.position;
  const double distance = between.norm();
  Linear<M> n = Linear<M>::Unit(M::linear - 1);
  if (distance > no_distance * ball.radius) n = between / distance;
  return {n, pose.position + ball.radius * n, distance - ball.radius};
}

template <class M>
Nearest<M> nearest(const Box<M>& box, const Pose<M>& pose, const Linear<M>& point) {
  const Linear<M> own = arm_to<M>(pose, point), half = box.half();  // in the axes of the box
  Linear<M> nearest = own.cwiseMin(half).cwiseMax(-half), n = own - nearest;
  double height = n.norm();
  if (height > no_distance * half.maxCoeff()) {
    n /= height;
  } else {  // inside: the nearest side
    int axis;
    height = -(half - own.cwiseAbs()).minCoeff(&axis);
    n = Linear<M>::Unit(axis) * (own[axis] < 0 ? -1 : 1);
    nearest[axis] = n[axis] * half[axis];
  }
  return {rotate(pose.rotation, n), pose.position + rotate(pose.rotation, nearest), height};
}

template <class M>
Nearest<M> nearest(const HalfSpace<M>& half_space, const Pose<M>& pose, const Linear<M>& point) {
  const Linear<M> n = detail::turned<M>(pose, half_space.normal);
  const double height = n.dot(point - pose.position);
  return {n, point - height * n, height};
}

// The contact points of two kinds of shapes, each pair in one order.

template <class M, class Kind>
requires(!std::is_same_v<Kind, std::monostate>) Manifold<M> collide_kinds(const Kind& shape, const Pose<M>& pose1,
                                                                          const Ball<M>& ball,
                                                                          const Pose<M>& pose2, double margin) {
  Manifold<M> manifold;
  const auto [n, p1, height] = nearest<M>(shape, pose1, pose2.position);
  const double separation = height - ball.radius;
  manifold.normal = n;
  if (separation <= margin) manifold.add({p1, pose2.position - ball.radius * n, separation});
  return manifold;
}

/// The corners of the face that is most nearly parallel to the plane, on the box's lower side.
template <class M>
Manifold<M> collide_kinds(const HalfSpace<M>& half_space, const Pose<M>& pose1, const Box<M>& box,
                          const Pose<M>& pose2, double margin) {
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

}  // namespace

template <class M>
Manifold<M> collide(const Shape<M>& shape1, const Pose<M>& pose1, const Shape<M>& shape2, const Pose<M>& pose2,
                    double margin, std::uint32_t hint) {
  return std::visit(
      [&](const auto& kind1, const auto& kind2) -> Manifold<M> {
        if constexpr (requires { collide_boxes(kind1, pose1, kind2, pose2, margin, hint); })
          return collide_boxes(kind1, pose1, kind2, pose2, margin, hint);
        else if constexpr (requires { collide_kinds<M>(kind1, pose1, kind2, pose2, margin); })
          return collide_kinds<M>(kind1, pose1, kind2, pose2, margin);
        else if constexpr (requires { collide_kinds<M>(kind2, pose2, kind1, pose1, margin); })
          return mirrored<M>(collide_kinds<M>(kind2, pose2, kind1, pose1, margin));
        else
          return {};
      },
      shape1, shape2);
}

#define BYHAND_INSTANTIATE(M)                                                                               \
  template Manifold<M> collide<M>(const Shape<M>&, const Pose<M>&, const Shape<M>&, const Pose<M>&, double, \
                                  std::uint32_t)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
