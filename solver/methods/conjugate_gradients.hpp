#pragma once

#include "solver/gauss_seidel.hpp"

// All rows at once by conjugate gradients, for rows without bounds:
//
//   (A + γ)λ = -(JV + b),   A = JM⁻¹Jᵀ
//
// is a symmetric positive semidefinite system, and each iteration takes the best step along a direction p that is
// conjugate to all before: n iterations reach every answer that A's n different eigenvalues allow, so a chain of n
// links is solved exactly. A is never formed. What λ has done is in V, so that the residual is r = -(JV + b + γλ)
// as in (17), and what p would do is q = M⁻¹Jᵀp, so that Ap = Jq.
//
//   z = E r                          each block by itself: E = (JM⁻¹Jᵀ + γ)⁻¹ of its rows preconditions the whole
//   p = z + p (r·z)/(r·z)_before
//   α = (r·z)/(p·(Jq + γp))
//   λ += αp,   V += αq,   r -= α(Jq + γp)
//
// A bound would break the conjugacy: ConjugateSweeps is what is left of this then.
//
// Source: M. Hestenes, E. Stiefel, "Methods of conjugate gradients for solving linear systems", J. Research NBS
// 49, 1952. An iteration costs JV and M⁻¹Jᵀλ once for each row, as a sweep does.
namespace byhand {

/// Conjugate gradients on the rows of a scene in which none is bounded.
struct ConjugateGradients {
  int iterations = 50;      // >= 1
  double tolerance = 1e-9;  // >= 0: stop once no |JV + b + γλ| is larger [units of C per second]
  bool warm_start = true;   // begin with the λ of the last step
};

/// Throws std::invalid_argument for a choice outside the ranges above.
void require_valid(const ConjugateGradients& solver);

/// Scratch, kept so that no step allocates.
template <class M>
struct ConjugateGradientWork {
  template <int K, Bound B>
  using InverseOf = Eigen::Matrix<double, K, K>;

  PerBlock<M, InverseOf> inverses;  // E
  std::vector<double> r, z, p, Ap;  // by row
  std::vector<Velocity<M>> q;       // by body
};

/// Solves the system's rows, none of them bounded, for λ and puts the impulses into the velocities. Returns how
/// many iterations it took.
template <class M>
int solve(const ConjugateGradients& solver, System<M>& system, std::vector<Velocity<M>>& velocities,
          ConjugateGradientWork<M>& work, Begin begin = Begin::step);

}  // namespace byhand
