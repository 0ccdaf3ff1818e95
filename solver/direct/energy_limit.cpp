#include "solver/direct/energy_limit.hpp"

#include <cmath>
#include <limits>

#include "solver/direct/correction_limit.hpp"
#include "solver/rows/operators.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {

namespace {

/// A distance that no body that moves is farther from any point that turns it [m]: no two of them are farther
/// apart, and no row holds one by a longer arm.
template <class M>
double reach_of(const System<M>& system, const Bodies<M>& bodies) {
  Linear<M> least = Linear<M>::Constant(std::numeric_limits<double>::infinity()), most = -least;
  for (int body = 0; body < bodies.size(); ++body) {
    if (!moves(bodies.inverse_mass[body])) continue;
    least = least.cwiseMin(bodies.pose[body].position);
    most = most.cwiseMax(bodies.pose[body].position);
  }
  double longest = 0;  // squared
  for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run&) {
    const auto look = [&](const auto& J) {
      // The rows of a pin see r along each axis, and together at least all of it.
      double squares = 0;
      for (int k = 0; k < K; ++k) {
        const double length2 = J.row(k).template head<M::linear>().squaredNorm();
        if (length2 > 0) squares += J.row(k).template tail<M::angular>().squaredNorm() / length2;
      }
      longest = std::max(longest, squares);
    };
    if (block.moves1) look(block.J.side1());
    if (block.moves2) look(block.J.side2());
  });
  return (most - least).norm() + std::sqrt(longest);
}

}  // namespace

template <class M>
double driven_energy(const System<M>& system, const Bodies<M>& bodies) {
  double energy = 0;
  for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run&) {
    const Rows<K> rate = led(bodies, block);
    for (int k = 0, row = block.row; k < K; ++k, ++row)
      energy -= system.lambda[row] * (system.target_rate[row] + rate[k]);
  });
  return energy;
}

template <class M>
double pushed_energy(const System<M>& system, const Bodies<M>& bodies, std::vector<double>& still) {
  const double reach = reach_of(system, bodies);
  double fastest = 0;
  still = system.bias;
  for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run&) {
    const Rows<K> rate = led(bodies, block);
    for (int k = 0, row = block.row; k < K; ++k, ++row) {
      const double drive = system.target_rate[row] + rate[k];
      double correction = system.bias[row] - system.target_rate[row], push = correction + drive;
      if (one_sided(system, block, k)) {
        push = std::min(push, 0.0);
        correction = std::min(correction, 0.0);
      }
      if (push == 0) continue;
      still[row] -= push;
      const double asked = asked_speed(bodies, block, k, correction) + asked_speed(bodies, block, k, drive, reach);
      fastest = std::max(fastest, asked);
    }
  });
  double mass = 0;
  for (const InverseMass<M>& inverse : bodies.inverse_mass)
    if (moves(inverse)) mass += 1 / inverse.linear;
  constexpr double swept = 1.01;  // with what sweeps leave
  return swept * 0.5 * mass * fastest * fastest;
}

template <class M>
void move_towards(const Solved<M>& other, double most, System<M>& system, Bodies<M>& bodies) {
  // E(V + s ΔV) = E(V) + 2 s half + s² E(ΔV).
  std::vector<Velocity<M>> change = other.velocity;
  for (int body = 0; body < bodies.size(); ++body) change[body] -= bodies.velocity[body];
  const double now = kinetic_energy(bodies, bodies.velocity), of_change = kinetic_energy(bodies, change);
  const double half = 0.5 * (kinetic_energy(bodies, other.velocity) - now - of_change);
  const double left = std::max(0.0, most - now), root = std::sqrt(half * half + of_change * left);
  const double share = std::min(1.0, half > 0 ? left / (half + root) : (root - half) / of_change);
  for (int body = 0; body < bodies.size(); ++body) bodies.velocity[body] += share * change[body];
  for (int k = 0; k < system.rows(); ++k) system.lambda[k] += share * (other.lambda[k] - system.lambda[k]);
}

#define BYHAND_INSTANTIATE(M)                                                              \
  template double driven_energy(const System<M>&, const Bodies<M>&);                       \
  template double pushed_energy(const System<M>&, const Bodies<M>&, std::vector<double>&); \
  template void move_towards(const Solved<M>&, double, System<M>&, Bodies<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
