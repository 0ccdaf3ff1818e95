#pragma once

#include "solver/integrate/kinetic_energy.hpp"
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

/// Energies that differ by no more than this share are the same.
constexpr double rounding = 1e-9;

/// λ, and the velocities that it gives.
template <class M>
struct Solved {
  std::vector<double> lambda;
  std::vector<Velocity<M>> velocity;
};

/// What target rates, and fixed bodies that have a velocity, give to the bodies by λ [J].
template <class M>
double driven_energy(const System<M>& system, const Bodies<M>& bodies);

/// The most that rows may make of energy [J]. `still` becomes b without what they push with.
template <class M>
double pushed_energy(const System<M>& system, const Bodies<M>& bodies, std::vector<double>& still);

/// No λ, and the velocities of the bodies without it.
template <class M>
void begin_anew(const std::vector<Velocity<M>>& without, System<M>& system, Bodies<M>& bodies) {
  bodies.velocity = without;
  std::fill(system.lambda.begin(), system.lambda.end(), 0.0);
}

/// Moves λ and V of system and bodies towards others, as far as leaves at most this energy [J]. Bounds that hold
/// for both hold between them.
template <class M>
void move_towards(const Solved<M>& other, double most, System<M>& system, Bodies<M>& bodies);

/// Takes back what rows have made beyond that: they push with less. `without` are the velocities without λ, and
/// `solve` solves the rows from none. Where rows have not converged, what they may make counts from where they are
/// when they push with nothing: else what is crushed would gain some in every step. `bias` is scratch. Returns
/// whether it changed anything.
template <class M>
bool limit_energy(const std::vector<Velocity<M>>& without, bool converged, System<M>& system, Bodies<M>& bodies,
                  std::vector<double>& bias, auto&& solve) {
  const double before = kinetic_energy(bodies, without), after = kinetic_energy(bodies, bodies.velocity);
  if (after <= (1 + rounding) * before) return false;
  const double made = pushed_energy(system, bodies, bias);
  if (converged && after <= (1 + rounding) * (before + made)) return false;
  Solved<M> pushed{system.lambda, bodies.velocity};
  begin_anew(without, system, bodies);
  system.bias.swap(bias);
  solve();
  system.bias.swap(bias);
  double most = kinetic_energy(bodies, bodies.velocity) + made;
  if (most > before + made) {  // not solved
    pushed = {system.lambda, bodies.velocity};
    most = before + made;
    begin_anew(without, system, bodies);
  }
  move_towards(pushed, most, system, bodies);
  return true;
}

}  // namespace byhand
