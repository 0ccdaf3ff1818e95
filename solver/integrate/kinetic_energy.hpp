#pragma once

#include "solver/body.hpp"

namespace byhand {

/// ½mv² + ½ω·Iω of all bodies that move, at these velocities [J].
template <class M>
double kinetic_energy(const Bodies<M>& bodies, const std::vector<Velocity<M>>& velocities) {
  double energy = 0;
  for (int i = 0; i < bodies.size(); ++i) {
    const InverseMass<M>& mass = bodies.inverse_mass[i];
    if (!moves(mass)) continue;
    energy += 0.5 * velocities[i].template head<M::linear>().squaredNorm() / mass.linear;
    if constexpr (M::angular > 0) {
      const Angular<M> spin = velocities[i].template tail<M::angular>();
      energy += 0.5 * spin.dot(inertia<M>(mass, bodies.pose[i]) * spin);
    }
  }
  return energy;
}

}  // namespace byhand
