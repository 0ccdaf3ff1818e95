#pragma once

#include "solver/rows/row_solver.hpp"

// Rows within bounds are solved where their natural map vanishes (rows/residual.hpp),
//
//   F(λ) = λ - Π(λ - D⁻¹e) = 0,   e = JV + b + γλ,   V = V₀ + M⁻¹Jᵀλ.
//
// Π clamps a normal to λ_n >= 0 and friction to the disc |λ_t| <= μ λ_n. It is piecewise smooth, and Newton's
// method takes the derivative of the piece that λ is on. With x = Δλ, a row of the step reads
//
//   open          λ - D⁻¹e outside its interval:   x = bound - λ
//   pressed       within it, or sticking:          e + J ΔV + γx = 0
//   sliding       y = λ_t - D⁻¹e_t outside the disc, d = y/|y|, r = μ λ_n, τ = r/|y|:
//                 λ_t + x = r d + μ x_n d + τ (1 - d dᵀ)(x - D⁻¹(J ΔV + γx))
//
// Where four contacts share a face, λ is not unique and these equations are singular. So each solve looks for λ
// near where it began, λ°: ε D (λ - λ°) is added to e, and the solves begin anew from what they found (the
// proximal point method), which leaves the solution as it is. Then every row gives x = h - R ΔV by itself, or from
// its contact's normal, and what is left has the size of the bodies alone:
//
//   (1 + M⁻¹Jᵀ R) ΔV = M⁻¹Jᵀ h.
//
// This Schur complement has a block for every two bodies that touch, however many points they touch in. Friction
// makes it unsymmetric. The work does not grow with the ratio of the masses, as that of sweeps does.
//
// A step is shortened until Σ F² falls. Where it does not, sweeps go on from the best λ, ε grows, and the radius
// of friction changes between being held at μ λ°_n, where the problem is convex, and following λ_n. After P.
// Alart, A. Curnier, A mixed formulation for frictional contact problems prone to Newton like solution methods,
// Comput. Methods Appl. Mech. Eng. 92, 1991; R. T. Rockafellar, Monotone operators and the proximal point
// algorithm, SIAM J. Control Optim. 14, 1976.
namespace byhand {

template <class M>
struct NewtonWork;

/// Semismooth Newton's method on the natural map, begun by sweeps.
struct SemismoothNewton {
  int rounds = 20;           // factorisations >= 1
  int sweeps = 10;           // at the beginning, and where a step fails >= 1
  double tolerance = 1e-12;  // as of GaussSeidel, in (0, 1]

  template <class M>
  using Work = NewtonWork<M>;
  template <class M>
  Solution solve(System<M>& system, Bodies<M>& bodies, NewtonWork<M>& work, Begin begin = Begin::step) const;
};

inline void require_valid(const SemismoothNewton& solver) {
  require(solver.rounds >= 1, "number of rounds", solver.rounds, "at least 1");
  require(solver.sweeps >= 1, "number of sweeps", solver.sweeps, "at least 1");
  require(solver.tolerance > 0 && solver.tolerance <= 1, "tolerance", solver.tolerance, "above 0 and at most 1");
}

}  // namespace byhand
