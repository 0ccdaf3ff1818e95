#pragma once

#include "solver/drift.hpp"
#include "solver/scene.hpp"

// Post-stabilisation: once the poses have moved they are put back onto C = 0, and the velocities know nothing of
// it. Each constraint in turn moves its two bodies by
//
//   M⁻¹Jᵀ ΔΛ,   ΔΛ = -s (JM⁻¹Jᵀ + γ)⁻¹ C,
//
// with C and J where the bodies stand at that moment: nonlinear Gauss–Seidel. Contacts are only pushed out of each
// other, and only of what exceeds the slop. What comes out is the nearest pose in the metric of the masses, so the
// centre of mass stays where it is; energy does not, for the poses fall into place without work being counted.
// (Source: E. Catto's b2ContactSolver::SolvePositionConstraints, Box2D 2.4, of which this keeps the idea.)
namespace byhand {

/// The cure that puts poses back. Costs its sweeps over all rows that have a C.
struct Projection {
  int sweeps = 4;    // >= 1
  double share = 1;  // s: of each constraint's error, in (0, 1]
  double slop = 0;   // of one-sided rows: how much overlap is left alone [m] >= 0
};

/// Throws std::invalid_argument for a choice outside the ranges above.
inline void require_valid(const Projection& cure) {
  require(cure.sweeps >= 1, "number of projection sweeps", cure.sweeps, "at least 1");
  require(cure.share > 0 && cure.share <= 1, "share of the projection", cure.share, "above 0 and at most 1");
  require_in("slop", cure.slop, 0, 1e300, "m");
}

/// The velocities stay as they are: no bias.
inline Correction correction(const Projection&, double /*h*/) { return {}; }

/// Moves the scene's poses towards C = 0. Returns how many rows were solved.
template <class M>
long long project(const Projection& cure, Scene<M>& scene);

}  // namespace byhand
