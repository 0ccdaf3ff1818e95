#pragma once

#include "solver/system.hpp"

// Rows with bounds that cannot all be met: bars that are pinned to each other and wedge. As in
// correction_limit.hpp an exact solve answers a correction of millimetres with metres a second. Here the energy
// tells. With V of the bodies without λ and V⁺ = V + M⁻¹Jᵀλ, and E = ½V⁺·MV⁺,
//
//   E(V⁺) - E(V) = λᵀJV⁺ - ½λᵀAλ <= -λᵀb
//
// for friction only takes energy, and a row that presses has JV⁺ = -b. So E grows only by what rows push with:
// corrections, target rates, fixed bodies that have a velocity. What they make beyond ½Mv², all bodies as fast as
// the row that asks most, is taken back.
namespace byhand {

/// E of the bodies that move, at other velocities than theirs [J].
template <class M>
double energy_at(const Bodies<M>& bodies, const std::vector<Velocity<M>>& velocities);

/// Energies that differ by no more than this share are the same.
constexpr double rounding = 1e-9;

/// What target rates, and fixed bodies that have a velocity, give to the bodies by λ [J].
template <class M>
double driven_energy(const System<M>& system, const Bodies<M>& bodies);

/// The most that rows may make of energy [J]. `push` becomes what they push with, the part of b that can be left
/// out.
template <class M>
double pushed_energy(const System<M>& system, const Bodies<M>& bodies, std::vector<double>& push);

/// Moves λ and V of system and bodies towards others, as far as leaves at most this energy [J]. Bounds that hold
/// for both hold between them.
template <class M>
void move_towards(const std::vector<double>& lambda, const std::vector<Velocity<M>>& velocity, double most,
                  System<M>& system, Bodies<M>& bodies);

/// Takes back what rows have made beyond that: they push with less. `without` are the velocities without λ, and
/// `solve` solves the rows from none. Where rows have not converged, what they may make counts from where they are
/// when they push with nothing: else what is crushed would gain some in every step. Returns whether it changed
/// anything.
template <class M>
bool limit_energy(const std::vector<Velocity<M>>& without, bool converged, System<M>& system, Bodies<M>& bodies,
                  std::vector<double>& push, auto&& solve) {
  const double before = energy_at(bodies, without), after = energy_at(bodies, bodies.velocity);
  if (after <= (1 + rounding) * before) return false;
  const double made = pushed_energy(system, bodies, push);
  if (converged && after <= before + made) return false;
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
  double most = energy_at(bodies, bodies.velocity) + made;
  if (most > before + made) {  // not solved
    lambda = system.lambda;
    velocity = bodies.velocity;
    most = before + made;
    take_back();
  }
  move_towards(lambda, velocity, most, system, bodies);
  return true;
}

}  // namespace byhand
