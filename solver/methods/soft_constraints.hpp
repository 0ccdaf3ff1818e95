#pragma once

#include "solver/drift.hpp"
#include "solver/methods/row_solvers.hpp"

// A soft constraint takes its error back as a damped spring does, tuned for each row by itself: one that swings
// with frequency ω and is damped by ζ whatever hangs on it. With the row's own effective mass m = 1/A of (19), A =
// JM⁻¹Jᵀ, and the spring's row of constraints/spring.hpp,
//
//   k = mω²,   c = 2mζω,   JV + k/(c + hk) C + γλ = 0,   γ = 1/(h(c + hk))
//   c + hk = mω(2ζ + hω) = mω a₁                             a₁ = 2ζ + hω
//   bias   = k/(c + hk) C = (ω/a₁) C
//   γ      = 1/(h m ω a₁) = A/a₂                             a₂ = hω a₁
//
// Alone such a row is stable for every hω and ζ. It gives way where it carries: what pulls it with T at rest finds
// λ/h = T, JV = 0, so that C = -(a₁/ω) γλ, a sag of T/(mω²). And while it gives way it makes velocity. Therefore
// the rows are solved a second time once the poses have moved, hard and without bias, from the λ that stands: they
// relax. What is left in V is what JV = 0 leaves, and the λ for the next step carries no correction.
//
// With J and C written anew at the new poses (`refresh`) that second solve knows where the bodies are, and V is
// tangent to the constraint where the next step begins. With the rows of the step's start it is not.
//
// Source: E. Catto, "Soft constraints", GDC 2011, and "Solver2D", 2024; Box2D 3 does so. Cost: the rows twice, and
// written twice where they are refreshed.
namespace byhand {

/// Rows as springs of one frequency, and then relaxed.
struct SoftConstraints {
  double frequency = 90;     // ω [rad/s] > 0
  double damping_ratio = 1;  // ζ >= 0
  bool relax = true;         // solve the rows a second time, hard and without bias
  bool refresh = true;       // write them anew for that
  // Of one-sided rows alone, as in Baumgarte:
  double slop = 0;                                             // [m] >= 0
  double speed_cap = std::numeric_limits<double>::infinity();  // [m/s] > 0
};

/// Throws std::invalid_argument for a choice outside the ranges above.
void require_valid(const SoftConstraints& cure);

/// b = (ω/a₁) C.
inline Correction correction(const SoftConstraints& cure, double h) {
  return {cure.frequency / (2 * cure.damping_ratio + h * cure.frequency), cure.slop, cure.speed_cap};
}

/// What the rows had of their own before they were softened, by row.
struct SoftWork {
  std::vector<double> gamma, rate;
};

/// Before the rows are solved: gives every row that has a C and no softness of its own γ = A/a₂; a contact that is
/// still open stays hard.
template <class M>
void soften(const SoftConstraints& cure, double h, System<M>& system, SoftWork& work);

/// Once the poses have moved: solves the rows again, hard and without bias, from the λ that stands.
template <class M>
void relax(const SoftConstraints& cure, const RowSolver& solver, double h, Scene<M>& scene, RowWork<M>& rows,
           SoftWork& work);

}  // namespace byhand
