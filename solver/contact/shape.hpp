#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <variant>

#include "solver/model.hpp"
#include "solver/support/require.hpp"

// What a body looks like to the others. A shape is centred on its body and turns with it.
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

/// All that lies behind a line or plane through the body's position.
template <class M>
struct HalfSpace {
  Linear<M> normal = Linear<M>::Unit(M::linear - 1);  // out of the solid, a unit vector in the body's axes
};

/// The shapes that a model's bodies can have; nothing touches std::monostate. A particle does not turn, so it is
/// no box.
template <class M>
using Shape = std::conditional_t<M::angular == 0, std::variant<std::monostate, Ball<M>, HalfSpace<M>>,
                                 std::variant<std::monostate, Ball<M>, Box<M>, HalfSpace<M>>>;

/// Lower and upper corner along the world's axes [m]; empty for no shape.
template <class M>
using Bounds = Eigen::AlignedBox<double, M::linear>;

namespace detail {

/// A direction of the body in the world; a particle's axes are the world's.
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

template <class M>
Bounds<M> bounds_of(std::monostate, const Pose<M>&) {
  return {};
}
template <class M>
Bounds<M> bounds_of(const Ball<M>& ball, const Pose<M>& pose) {
  const Linear<M> reach = Linear<M>::Constant(ball.radius);
  return {pose.position - reach, pose.position + reach};
}
template <class M>
Bounds<M> bounds_of(const Box<M>& box, const Pose<M>& pose) {
  const Linear<M> reach = axes<M>(pose).cwiseAbs() * box.half();
  return {pose.position - reach, pose.position + reach};
}
template <class M>
Bounds<M> bounds_of(const HalfSpace<M>&, const Pose<M>&) {
  const Linear<M> reach = Linear<M>::Constant(std::numeric_limits<double>::infinity());
  return {-reach, reach};
}

template <class M>
void require_valid_shape(std::monostate) {}
template <class M>
void require_valid_shape(const Ball<M>& ball) {
  require_positive("radius", ball.radius, "m");
}
template <class M>
void require_valid_shape(const Box<M>& box) {
  for (const double side : box.sides) require_positive("side", side, "m");
}
template <class M>
void require_valid_shape(const HalfSpace<M>& half_space) {
  require_in("length of the half-space's normal", half_space.normal.norm(), 1 - 1e-9, 1 + 1e-9);
}

}  // namespace detail

/// The least box along the world's axes that holds the shape; without limits for a half-space.
template <class M>
Bounds<M> bounds(const Shape<M>& shape, const Pose<M>& pose) {
  return std::visit([&](const auto& kind) { return detail::bounds_of<M>(kind, pose); }, shape);
}

/// Bounds that reach `margin` [m] further on every side.
template <class B>
B fattened(const B& bounds, double margin) {
  return {bounds.min().array() - margin, bounds.max().array() + margin};
}

/// Throws std::invalid_argument unless radius and sides are positive and finite and the normal has length 1.
template <class M>
void require_valid(const Shape<M>& shape) {
  std::visit([](const auto& kind) { detail::require_valid_shape<M>(kind); }, shape);
}

}  // namespace byhand
