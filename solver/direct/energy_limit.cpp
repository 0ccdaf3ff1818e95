#include "solver/direct/energy_limit.hpp"

#include "solver/direct/correction_limit.hpp"
#include "solver/rows/operators.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {

template <class M>
double energy_at(const Bodies<M>& bodies, const std::vector<Velocity<M>>& velocities) {
  double energy = 0;
  for (int body = 0; body < bodies.size(); ++body) {
    const InverseMass<M>& inverse = bodies.inverse_mass[body];
    if (!moves(inverse)) continue;
    const double v = speed(bodies, body, velocities[body]);
    energy += 0.5 * v * v / inverse.linear;
  }
  return energy;
}

namespace {

/// A distance that no two bodies that move are farther apart [m].
template <class M>
double extent(const Bodies<M>& bodies) {
  Linear<M> least = Linear<M>::Constant(std::numeric_limits<double>::infinity()), most = -least;
  for (int body = 0; body < bodies.size(); ++body) {
    if (!moves(bodies.inverse_mass[body])) continue;
    least = least.cwiseMin(bodies.pose[body].position);
    most = most.cwiseMax(bodies.pose[body].position);
  }
  return (most - least).norm();
}

}  // namespace

template <class M>
double most_energy(const System<M>& system, const Bodies<M>& bodies, double before, std::vector<double>& push) {
  const double reach = extent(bodies);
  double squares = 0;  // of the speeds that the rows ask for
  push.resize(system.rows());
  for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run&) {
    const auto of_fixed = [&](int body, bool moves) {
      return moves ? Velocity<M>(Velocity<M>::Zero()) : bodies.velocity[body];
    };
    const Rows<K> led = dot(block.J, of_fixed(block.body1, block.moves1), of_fixed(block.body2, block.moves2));
    for (int k = 0, row = block.row; k < K; ++k, ++row) {
      const double drive = system.target_rate[row] + led[k],
                   correction = system.bias[row] - system.target_rate[row];
      const bool pushes_only = one_sided(system, block, k);
      push[row] = pushes_only ? std::min(correction + drive, 0.0) : correction + drive;
      if (push[row] == 0) continue;
      const double speed = asked_speed(bodies, block, k, pushes_only ? std::min(correction, 0.0) : correction) +
                           asked_speed(bodies, block, k, drive, reach);
      squares += speed * speed;
    }
  });
  double mass = 0;
  for (const InverseMass<M>& inverse : bodies.inverse_mass)
    if (moves(inverse)) mass += 1 / inverse.linear;
  return before + 0.5 * mass * squares;
}

template <class M>
void move_towards(const std::vector<double>& lambda, const std::vector<Velocity<M>>& velocity, double most,
                  System<M>& system, Bodies<M>& bodies) {
  // E(V + s ΔV) = E(V) + 2 s half + s² E(ΔV).
  std::vector<Velocity<M>> change = velocity;
  for (int body = 0; body < bodies.size(); ++body) change[body] -= bodies.velocity[body];
  const double now = energy_at(bodies, bodies.velocity), of_change = energy_at(bodies, change);
  const double half = 0.5 * (energy_at(bodies, velocity) - now - of_change), left = std::max(0.0, most - now);
  const double share = left / (half + std::sqrt(half * half + of_change * left));
  if (!(share > 0)) return;
  for (int body = 0; body < bodies.size(); ++body) bodies.velocity[body] += share * change[body];
  for (int k = 0; k < system.rows(); ++k) system.lambda[k] += share * (lambda[k] - system.lambda[k]);
}

#define BYHAND_INSTANTIATE(M)                                                                                 \
  template double energy_at(const Bodies<M>&, const std::vector<Velocity<M>>&);                               \
  template double most_energy(const System<M>&, const Bodies<M>&, double, std::vector<double>&);              \
  template void move_towards(const std::vector<double>&, const std::vector<Velocity<M>>&, double, System<M>&, \
                             Bodies<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
