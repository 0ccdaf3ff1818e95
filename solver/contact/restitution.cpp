#include "solver/contact/restitution.hpp"

#include <utility>

#include "solver/direct/energy_limit.hpp"
#include "solver/rows/operators.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {

template <class M>
void limit_bounce(const Scene<M>& scene, double h, const std::vector<double>& lambda,
                  const std::vector<Velocity<M>>& velocity, System<M>& system, Bodies<M>& bodies) {
  std::vector<Velocity<M>> half = velocity, without = velocity;  // ah/2, and V - M⁻¹Jᵀλ
  std::vector<double> back = lambda;
  for (double& impulse : back) impulse = -impulse;
  apply_all(system, back, without);
  for (int body = 0; body < bodies.size(); ++body) {
    half[body] = h / 2 * applied_acceleration(bodies, body);
    if (moves(bodies.inverse_mass[body]))
      half[body].template head<M::linear>() += h / 2 * gravity_on(bodies, body, scene.gravity);
  }
  const auto energy = [&](std::vector<Velocity<M>> V, double sign) {
    for (int body = 0; body < bodies.size(); ++body) V[body] += sign * half[body];
    return energy_at(bodies, V);
  };
  const double still = energy(velocity, 1);
  const double falls = still - energy(velocity, -1);  // ma·(x⁺ - x), for x⁺ - x = hV
  const double most = std::max(still, energy(without, -1) + falls + std::max(0.0, driven_energy(system, bodies)));
  if (energy(bodies.velocity, 1) <= (1 + rounding) * most) return;
  const std::vector<double> bounced = std::exchange(system.lambda, lambda);
  std::vector<Velocity<M>> parting = std::exchange(bodies.velocity, velocity);
  for (int body = 0; body < bodies.size(); ++body) {
    bodies.velocity[body] += half[body];
    parting[body] += half[body];
  }
  move_towards(bounced, parting, most, system, bodies);
  for (int body = 0; body < bodies.size(); ++body) bodies.velocity[body] -= half[body];
}

#define BYHAND_INSTANTIATE(M)                                                     \
  template void limit_bounce(const Scene<M>&, double, const std::vector<double>&, \
                             const std::vector<Velocity<M>>&, System<M>&, Bodies<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
