#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <variant>

#include "solver/model.hpp"
#include "solver/support/require.hpp"

// Collision shapes. A shape is centred on its body and turns with it.
namespace byhand {

/// A disc in the plane, a solid sphere in space.
template <class M>
struct Ball {
  double radius = 0;  // [m]
};

/// A box of whole side lengths [m] along the body's axes.
template <class M>
struct Box {
  Linear<M> sides = Linear<M>::Zero();

  Linear<M> half() const { return 0.5 * sides; }
};

/// Everything behind a line (plane) through the body's position.
template <class M>
struct HalfSpace {
  Linear<M> normal = Linear<M>::Unit(1);  // outward unit vector in the body's axes
};

/// The shapes of a model; std::monostate is no shape. Particles do not turn, so they cannot be boxes.
template <class M>
using Shape = std::conditional_t<M::angular == 0, std::variant<std::monostate, Ball<M>, HalfSpace<M>>,
                                 std::variant<std::monostate, Ball<M>, Box<M>, HalfSpace<M>>>;

/// Axis-aligned bounding box in the world [m]; empty for no shape.
template <class M>
using Bounds = Eigen::AlignedBox<double, M::linear>;

namespace detail {

/// A direction in the body's axes, turned into the world.
template <class M>
Linear<M> turned(const Pose<M>& pose, const Linear<M>& direction) {
  if constexpr (M::angular == 0)
    return direction;
  else
    return rotate(pose.rotation, direction);
}

/// The body's axes in the world, as columns.
template <class M>
Eigen::Matrix<double, M::linear, M::linear> axes(const Pose<M>& pose) {
  if constexpr (M::linear == 2)
    return Eigen::Matrix2d{{pose.rotation.cos, -pose.rotation.sin}, {pose.rotation.sin, pose.rotation.cos}};
  else
    return pose.rotation.toRotationMatrix();
}

}  // namespace detail

/// The shape's bounding box in the world; without limits for a half-space.
template <class M>
Bounds<M> bounds(const Shape<M>& shape, const Pose<M>& pose) {
  if (std::holds_alternative<std::monostate>(shape)) return {};
  Linear<M> reach = Linear<M>::Constant(std::numeric_limits<double>::infinity());
  if (const auto* ball = std::get_if<Ball<M>>(&shape)) reach.setConstant(ball->radius);
  if constexpr (M::angular > 0)
    if (const auto* box = std::get_if<Box<M>>(&shape)) reach = detail::axes<M>(pose).cwiseAbs() * box->half();
  return {pose.position - reach, pose.position + reach};
}

/// Bounds enlarged by `margin` [m] on every side.
template <class B>
B fattened(const B& bounds, double margin) {
  return {bounds.min().array() - margin, bounds.max().array() + margin};
}

/// Throws std::invalid_argument unless radius and sides are positive and finite and the normal has length 1.
template <class M>
void require_valid(const Shape<M>& shape) {
  if (const auto* ball = std::get_if<Ball<M>>(&shape)) require_positive("radius", ball->radius, "m");
  if constexpr (M::angular > 0)
    if (const auto* box = std::get_if<Box<M>>(&shape))
      for (const double side : box->sides) require_positive("side", side, "m");
  if (const auto* half_space = std::get_if<HalfSpace<M>>(&shape))
    require_unit("length of the half-space's normal", half_space->normal.norm());
}

}  // namespace byhand
