#pragma once

#include "solver/body.hpp"

namespace byhand {

/// (1 - exp(-x))/x for x >= 0: the mean of exp(-xs) over 0 <= s <= 1. By its series and by doubling x, for libm's
/// exp differs from processor to processor.
double mean_decay(double x);

/// Damping into V over a time step h [s]: v exp(-ch), exactly, and stable for any ch. Before gravity, so that what
/// rests presses with its whole weight.
template <class M>
void damp(Bodies<M>& bodies, double h) {
  for (int i = 0; i < std::ssize(bodies.forces); ++i) {
    if (!moves(bodies.inverse_mass[i])) continue;
    const auto decay = [&](double rate) { return 1 - rate * h * mean_decay(rate * h); };
    bodies.velocity[i].template head<M::linear>() *= decay(bodies.forces[i].linear_damping);
    if constexpr (M::angular > 0)
      bodies.velocity[i].template tail<M::angular>() *= decay(bodies.forces[i].angular_damping);
  }
}

/// The gravity on a body, by its own scale [m/s²].
template <class M>
Linear<M> gravity_on(const Bodies<M>& bodies, int body, const Linear<M>& gravity) {
  return bodies.forces.empty() ? gravity : Linear<M>(bodies.forces[body].gravity_scale * gravity);
}

//! [gravity]
/// Gravity into V, before λ is solved: else the solver cannot answer it, and a hanging mass sinks at g h.
template <class M>
void add_gravity(Bodies<M>& bodies, const Linear<M>& gravity, double h) {
  for (int i = 0; i < bodies.size(); ++i)
    if (moves(bodies.inverse_mass[i]))
      bodies.velocity[i].template head<M::linear>() += gravity_on(bodies, i, gravity) * h;
}
//! [gravity]

/// What applied forces add to a body's velocity in a second [m/s², rad/s²].
template <class M>
Velocity<M> applied_acceleration(const Bodies<M>& bodies, int body) {
  if (bodies.applied.empty()) return Velocity<M>::Zero();
  return times_inverse_mass<M>(bodies.applied[body], bodies.inverse_mass[body], bodies.pose[body]);
}

/// Applied forces into V, with gravity.
template <class M>
void add_applied(Bodies<M>& bodies, double h) {
  for (int i = 0; i < std::ssize(bodies.applied); ++i) bodies.velocity[i] += h * applied_acceleration(bodies, i);
}

//! [advance]
/// Poses along velocities for one time step h [s]; a rotation turns by exactly ωh.
template <class M>
void advance_poses(Bodies<M>& bodies, double h) {
  for (int i = 0; i < bodies.size(); ++i)
    if (in_motion(bodies, i)) move<M, double>(bodies.pose[i], bodies.velocity[i], h);
}
//! [advance]

}  // namespace byhand
