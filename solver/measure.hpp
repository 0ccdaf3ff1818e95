#pragma once

#include <algorithm>
#include <cmath>

#include "solver/constraints/spring.hpp"
#include "solver/integrate/euler.hpp"
#include "solver/integrate/kinetic_energy.hpp"
#include "solver/step.hpp"

// Measured quantities of a scene: plain sums over all bodies that move, or over rows.
namespace byhand {

/// ½mv² + ½ω·Iω [J].
template <class M>
double kinetic_energy(const Bodies<M>& bodies) {
  return kinetic_energy(bodies, bodies.velocity);
}

/// -m g·x, zero at the origin, with each body's gravity scale, and ½kC² of springs [J].
template <class M>
double potential_energy(const Scene<M>& scene) {
  const Bodies<M>& bodies = scene.bodies();
  double energy = 0;
  for (int i = 0; i < bodies.size(); ++i)
    if (moves(bodies.inverse_mass[i]))
      energy -= gravity_on(bodies, i, scene.gravity).dot(bodies.pose[i].position) / bodies.inverse_mass[i].linear;
  for (const Spring<M>& spring : scene.template all<Spring<M>>()) {
    const double C = spring.template value<double>(bodies.pose[spring.at.body1], bodies.pose[spring.at.body2])[0];
    energy += 0.5 * spring.elastic.stiffness * C * C;
  }
  return energy;
}

template <class M>
double energy(const Scene<M>& scene) {
  return kinetic_energy(scene.bodies()) + potential_energy(scene);
}

/// m v [kg m/s].
template <class M>
Linear<M> linear_momentum(const Bodies<M>& bodies) {
  Linear<M> sum = Linear<M>::Zero();
  for (int i = 0; i < bodies.size(); ++i)
    if (moves(bodies.inverse_mass[i]))
      sum += bodies.velocity[i].template head<M::linear>() / bodies.inverse_mass[i].linear;
  return sum;
}

/// (x - about) × m v + Iω [kg m²/s]: one number in the plane, three in space.
template <class M>
auto angular_momentum(const Bodies<M>& bodies, const Linear<M>& about = Linear<M>::Zero()) {
  decltype(cross(about, about)) sum;
  sum.setZero();
  for (int i = 0; i < bodies.size(); ++i) {
    const InverseMass<M>& mass = bodies.inverse_mass[i];
    if (!moves(mass)) continue;
    const Linear<M> momentum = bodies.velocity[i].template head<M::linear>() / mass.linear;
    sum += cross(Linear<M>(bodies.pose[i].position - about), momentum);
    if constexpr (M::angular > 0)
      sum += inertia<M>(mass, bodies.pose[i]) * bodies.velocity[i].template tail<M::angular>();
  }
  return sum;
}

struct PositionError {
  double max = 0, rms = 0;  // of |C|, in the unit of C
};

/// |C| over all rows that have a C, of a scene's constraints and of these contacts; of one-sided rows only overlap
/// counts. NaN if any is.
template <class M>
PositionError position_error(const Scene<M>& scene, const ContactManager<M>& contacts = {});
/// The same with the contacts of the last step.
template <class M, class Method>
PositionError position_error(const Simulation<M, Method>& simulation) {
  return position_error(simulation.scene, simulation.work.contacts);
}

/// The largest residual of the rows as last written and solved, at velocities V [m/s]: that of the natural map,
/// see rows/residual.hpp. NaN if any is.
template <class M>
double residual(const System<M>& system, const std::vector<Velocity<M>>& V);

/// The largest difference between the velocities after one step and after the same step with the dense direct
/// solver [m/s, rad/s]. The rest of the step's error is not the solver's. NaN where either step is NotFinite.
template <class M, class Method>
double algebraic_error(Simulation<M, Method> simulation, double h) {
  Simulation<M, Method> exact = simulation;
  exact.method.solver = Direct{Factorisation::dense};
  try {
    simulation.step(h);
    exact.step(h);
  } catch (const NotFinite&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const auto &V = simulation.scene.bodies().velocity, &exact_V = exact.scene.bodies().velocity;
  double largest = 0;
  for (std::size_t i = 0; i < V.size(); ++i)
    for (int k = 0; k < M::dof; ++k) largest = larger(largest, std::abs(V[i][k] - exact_V[i][k]));
  return largest;
}

}  // namespace byhand
