#pragma once

#include "solver/cures/correction.hpp"

// Post-stabilisation: after the poses have moved they are put back onto C = 0, and the velocities stay as they
// are. Each constraint in turn moves its two bodies by
//
//   M⁻¹Jᵀ ΔΛ,   ΔΛ = -s (JM⁻¹Jᵀ + γ)⁻¹ C,
//
// with C and J at the current poses: nonlinear Gauss–Seidel. Contacts are only pushed apart, by the overlap beyond
// the slop. The centre of mass stays, for the poses move to the nearest in the metric of the masses; energy does
// not. Source of the idea: E. Catto's b2ContactSolver::SolvePositionConstraints, Box2D 2.4.
namespace byhand {

template <class M>
class ContactManager;

/// Corrects poses after each substep. Cost: its sweeps over all rows that have a C.
struct Projection {
  int sweeps = 4;    // >= 1
  double share = 1;  // s: share of each constraint's error that is removed, in (0, 1]
  double slop = 0;   // as in Correction

  template <class M>
  void after_move(Stage<M>& stage) const;
};

inline void require_valid(const Projection& cure) {
  require(cure.sweeps >= 1, "number of projection sweeps", cure.sweeps, "at least 1");
  require(cure.share > 0 && cure.share <= 1, "share of the projection", cure.share, "above 0 and at most 1");
  require_in("slop", cure.slop, 0, 1e300, "m");
}

/// Moves the scene's poses towards C = 0 of its constraints and of these contacts. Returns the number of rows
/// solved.
template <class M>
long long project(const Projection& cure, Scene<M>& scene, const ContactManager<M>& contacts = {});

}  // namespace byhand
