#pragma once

#include <algorithm>
#include <cmath>

#include "solver/step.hpp"

// What can be read off a scene: each a plain sum over bodies or rows, so that what is claimed can be checked.
namespace byhand {

struct PositionError {
  double max = 0, rms = 0;  // of |C|, in the unit of C
};

/// How far the scene is from its position constraints: over all rows that have a C; of one-sided rows only
/// overlap counts.
template <class M>
PositionError position_error(const Scene<M>& scene);

/// ½mv² + ½ω·Iω over all bodies that move [J].
template <class M>
double kinetic_energy(const Bodies<M>& bodies) {
  double energy = 0;
  for (int i = 0; i < bodies.size(); ++i) {
    if (!moves(bodies.inverse_mass[i])) continue;
    const Velocity<M>& V = bodies.velocity[i];
    energy += 0.5 * V.template head<M::linear>().squaredNorm() / bodies.inverse_mass[i].linear;
    if constexpr (M::angular > 0) {
      const Angular<M> spin = V.template tail<M::angular>();
      energy += 0.5 * spin.dot(inertia<M>(bodies.inverse_mass[i], bodies.pose[i]) * spin);
    }
  }
  return energy;
}

/// -m g·x over all bodies that move [J], zero at the origin.
template <class M>
double potential_energy(const Scene<M>& scene) {
  const Bodies<M>& bodies = scene.bodies();
  double energy = 0;
  for (int i = 0; i < bodies.size(); ++i)
    if (moves(bodies.inverse_mass[i]))
      energy -= scene.gravity.dot(bodies.pose[i].position) / bodies.inverse_mass[i].linear;
  return energy;
}

/// Kinetic and potential energy [J].
template <class M>
double energy(const Scene<M>& scene) {
  return kinetic_energy(scene.bodies()) + potential_energy(scene);
}

/// Σ m v over all bodies that move [kg m/s].
template <class M>
Linear<M> linear_momentum(const Bodies<M>& bodies) {
  Linear<M> sum = Linear<M>::Zero();
  for (int i = 0; i < bodies.size(); ++i)
    if (moves(bodies.inverse_mass[i]))
      sum += bodies.velocity[i].template head<M::linear>() / bodies.inverse_mass[i].linear;
  return sum;
}

/// Σ (x - about) × m v + Iω over all bodies that move [kg m²/s]: one number in the plane, three in space.
template <class M>
auto angular_momentum(const Bodies<M>& bodies, const Linear<M>& about = Linear<M>::Zero()) {
  decltype(cross(about, about)) sum;
  sum.setZero();
  for (int i = 0; i < bodies.size(); ++i) {
    if (!moves(bodies.inverse_mass[i])) continue;
    const Linear<M> momentum = bodies.velocity[i].template head<M::linear>() / bodies.inverse_mass[i].linear;
    sum += cross(Linear<M>(bodies.pose[i].position - about), momentum);
    if constexpr (M::angular > 0)
      sum += inertia<M>(bodies.inverse_mass[i], bodies.pose[i]) * bodies.velocity[i].template tail<M::angular>();
  }
  return sum;
}

/// The largest |JV + b + γλ| over the rows as they were last written and solved [units of C per second], at
/// velocities V. A bounded row that leans on its bound counts only what drives it off.
template <class M>
double residual(const System<M>& system, const std::vector<Velocity<M>>& V);

/// How far one step of the simulation's method leaves the velocities from those of the direct solve of the
/// same rows: the largest difference over all bodies [m/s, rad/s]. What is left of the step's error is not
/// the solver's.
template <class M>
double algebraic_error(Simulation<M> simulation, double h);

}  // namespace byhand
