#pragma once

#include "solver/system.hpp"

// Bodies that meet faster than a threshold part again with a share e of their speed:
//
//   JV⁺ = -e JV⁻, that is (21) with b = e JV⁻, for each contact that pressed.
//
// JV⁻ is what it was before the step's impulses, and the rows are solved a second time once the positions have
// moved: a contact that is still open closes its gap first, so a ball turns round on the ground and not above it.
// The second solve goes on from the accumulated λ, so that a contact which lets go may take back all that it has
// pressed.
namespace byhand {

/// How many rows of a block, the first, may bounce.
template <int K, Bound B>
constexpr int bouncing = B == Bound::interval ? 1 : normals<K, B>;

/// Notes JV of each row that may bounce; nothing where no surface does.
template <class M>
void note_approach(const System<M>& system, const std::vector<Velocity<M>>& velocities,
                   std::vector<double>& approach);

/// Sets the bias of the rows that approached faster than `threshold` [m/s] and pressed. Returns whether there are
/// any.
template <class M>
bool set_bounce(const std::vector<double>& approach, double threshold, System<M>& system);

/// Forgets the λ of those rows: they part, and the next step is not to begin with that push.
template <class M>
void forget_bounce(const std::vector<double>& approach, double threshold, System<M>& system);

}  // namespace byhand
