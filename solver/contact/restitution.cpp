#include "solver/contact/restitution.hpp"

#include "solver/direct/energy_limit.hpp"
#include "solver/rows/operators.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {

template <class M>
void limit_bounce(const Scene<M>& scene, double h, const std::vector<double>& lambda,
                  const std::vector<Velocity<M>>& velocity, System<M>& system, Bodies<M>& bodies) {
  std::vector<Velocity<M>> half(bodies.size());  // ah/2
  for (int body = 0; body < bodies.size(); ++body) {
    half[body] = h / 2 * applied_acceleration(bodies, body);
    if (moves(bodies.inverse_mass[body]))
      half[body].template head<M::linear>() += h / 2 * gravity_on(bodies, body, scene.gravity);
  }
  const auto add_half = [&](double sign, std::vector<Velocity<M>>& V) {
    for (int body = 0; body < bodies.size(); ++body) V[body] += sign * half[body];
  };
  std::vector<Velocity<M>> V = velocity;
  add_half(-1, V);
  const double earlier = kinetic_energy(bodies, V);
  apply_all(system, lambda, V, -1);
  const double begins = kinetic_energy(bodies, V);

  V = velocity;
  add_half(1, V);
  const double still = kinetic_energy(bodies, V);
  const double falls = still - earlier;  // ma·(x⁺ - x), for x⁺ - x = hV
  const double most = std::max(still, begins + falls + std::max(0.0, driven_energy(system, bodies)));

  Solved<M> bounced{system.lambda, bodies.velocity};
  add_half(1, bounced.velocity);
  if (kinetic_energy(bodies, bounced.velocity) <= (1 + rounding) * most) return;
  system.lambda = lambda;
  bodies.velocity = V;
  move_towards(bounced, most, system, bodies);
  add_half(-1, bodies.velocity);
}

#define BYHAND_INSTANTIATE(M)                                                     \
  template void limit_bounce(const Scene<M>&, double, const std::vector<double>&, \
                             const std::vector<Velocity<M>>&, System<M>&, Bodies<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
