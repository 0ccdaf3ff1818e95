#pragma once

#include "solver/body.hpp"

namespace byhand {

/// When positions move: with the new velocities (symplectic, also called semi-implicit), or with the old ones
/// (explicit), which gains energy and is here to be seen.
enum class Euler { symplectic, explicit_ };

//! [gravity]
/// Gravity into V, before λ is solved: else the solver cannot answer it, and a hanging mass sinks at g h.
template <class M>
void add_gravity(Bodies<M>& bodies, const Linear<M>& gravity, double h) {
  const Linear<M> gain = gravity * h;
  for (int i = 0; i < bodies.size(); ++i)
    if (moves(bodies.inverse_mass[i])) bodies.velocity[i].template head<M::linear>() += gain;
}
//! [gravity]

//! [advance]
/// Poses along velocities for one time step h [s]; a rotation turns by exactly ωh.
template <class M>
void advance_poses(Bodies<M>& bodies, double h) {
  for (int i = 0; i < bodies.size(); ++i)
    if (in_motion(bodies, i)) move<M, double>(bodies.pose[i], bodies.velocity[i], h);
}
//! [advance]

}  // namespace byhand
