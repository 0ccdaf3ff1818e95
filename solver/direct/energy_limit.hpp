#pragma once

#include "solver/system.hpp"

// Rows with bounds that cannot all be met: bars that are pinned to each other and wedge. As in
// correction_limit.hpp an exact solve answers a correction of millimetres with metres a second. Here the energy
// tells. With V of the bodies without λ and V⁺ = V + M⁻¹Jᵀλ, and E = ½V⁺·MV⁺,
//
//   E(V⁺) - E(V) = λᵀJV⁺ - ½λᵀAλ <= -λᵀb
//
// for friction only takes energy, and a row that presses has JV⁺ = -b. So E grows only by what rows push with:
// corrections, target rates, fixed bodies that have a velocity. Moving all bodies as fast as one row asks by
// itself would take ½Mv²; what all make beyond Σ½Mv² is taken back.
namespace byhand {

/// E of the bodies that move, at other velocities than theirs [J].
template <class M>
double energy_at(const Bodies<M>& bodies, const std::vector<Velocity<M>>& velocities);

/// The most that solved rows may leave [J] if the bodies have `before` without λ. `push` becomes what they push
/// with, the part of b that can be left out.
template <class M>
double most_energy(const System<M>& system, const Bodies<M>& bodies, double before, std::vector<double>& push);

/// Moves λ and V of system and bodies towards others, as far as leaves at most this energy [J]. Bounds that hold
/// for both hold between them.
template <class M>
void move_towards(const std::vector<double>& lambda, const std::vector<Velocity<M>>& velocity, double most,
                  System<M>& system, Bodies<M>& bodies);

/// Takes back what solved rows have made beyond that: they push with less. `without` are the velocities without λ,
/// and `solve` solves the rows from none. Returns whether it changed anything.
template <class M>
bool limit_energy(const std::vector<Velocity<M>>& without, System<M>& system, Bodies<M>& bodies,
                  std::vector<double>& push, auto&& solve) {
  const double before = energy_at(bodies, without);
  if (energy_at(bodies, bodies.velocity) <= before) return false;
  const double most = most_energy(system, bodies, before, push);
  if (energy_at(bodies, bodies.velocity) <= most) return false;
  const auto take_back = [&] {
    bodies.velocity = without;
    std::fill(system.lambda.begin(), system.lambda.end(), 0.0);
  };
  auto lambda = system.lambda;
  auto velocity = bodies.velocity;
  take_back();
  for (int k = 0; k < system.rows(); ++k) system.bias[k] -= push[k];
  solve();
  for (int k = 0; k < system.rows(); ++k) system.bias[k] += push[k];
  if (energy_at(bodies, bodies.velocity) > most) {  // not solved
    lambda = system.lambda;
    velocity = bodies.velocity;
    take_back();
  }
  move_towards(lambda, velocity, most, system, bodies);
  return true;
}

}  // namespace byhand
