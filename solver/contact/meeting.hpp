#pragma once

#include "solver/contact/manifold.hpp"

// Where two shapes on their way will meet. What lies ahead is judged there: the plane of the present nearest
// points would turn a body away that passes by.
namespace byhand {

/// A shape, where it is, and the velocity [m/s, rad/s] that it is expected to keep.
template <class M>
struct Mover {
  const Shape<M>& shape;
  const Pose<M>& pose;
  const Velocity<M>& velocity;
  double rim_speed;  // as below

  Linear<M> linear() const { return velocity.template head<M::linear>(); }
  Angular<M> angular() const { return velocity.template tail<M::angular>(); }
};

/// The most that turning adds to the speed of any point of a shape [m/s].
template <class M>
double rim_speed(const Shape<M>& shape, const Velocity<M>& velocity) {
  const auto* box = std::get_if<Box<M>>(&shape);
  return box ? velocity.template tail<M::angular>().norm() * box->half().norm() : 0;
}

/// The most that a velocity moves any point of a shape [m/s].
template <class M>
double top_speed(const Shape<M>& shape, const Velocity<M>& velocity) {
  return velocity.template head<M::linear>().norm() + rim_speed<M>(shape, velocity);
}

/// Half of what a shape measures where it is thinnest [m]; infinite for a half-space.
template <class M>
double half_thickness(const Shape<M>& shape) {
  if (const auto* box = std::get_if<Box<M>>(&shape)) return box->half().minCoeff();
  if (const auto* ball = std::get_if<Ball<M>>(&shape)) return ball->radius;
  return std::numeric_limits<double>::infinity();
}

/// How fast the gap between p1 and p2 closes along the normal [m/s], negative where it opens.
template <class M>
double closing_speed(const Mover<M>& first, const Mover<M>& second, const Linear<M>& normal,
                     const ContactPoint<M>& point);

/// At least the speed [m/s] at which any two points of them come nearer to each other.
template <class M>
double approach(const Mover<M>& first, const Mover<M>& second) {
  return (second.linear() - first.linear()).norm() + first.rim_speed + second.rim_speed;
}

/// Moves a manifold of the present to where boxes and balls that may close the gap within `time` [s] meet or come
/// nearest, as conservative advancement finds it: by steps that are too short for them to touch. It is empty if
/// there they are farther apart than `margin` [m].
///
/// Its points are moved back, with the bodies and along the normal as fast as turning will close the gap there: so
/// J is that of the meeting, and -C/JV the time until then.
///
/// Source: B. Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, thesis, Berkeley 1996, section 2.3.
template <class M>
void move_to_meeting(const Mover<M>& first, const Mover<M>& second, double time, double margin,
                     Manifold<M>& manifold);

}  // namespace byhand
