#pragma once

#include "solver/rows/residual.hpp"
#include "solver/rows/row_solver.hpp"

// All rows at once by conjugate gradients, for rows without bounds:
//
//   (A + γ)λ = -(JV + b),   A = JM⁻¹Jᵀ
//
// is a symmetric positive semidefinite system. Each iteration takes the best step along a direction p that is
// conjugate to all directions before, so that a matrix with n different eigenvalues takes n iterations and a chain
// of n links is solved exactly. A is never formed: the velocities contain the effect of λ, so that the residual is
// r = -(JV + b + γλ) as in (17), and Ap = Jq with q = M⁻¹Jᵀp.
//
//   z = E r                          the preconditioner: E = (JM⁻¹Jᵀ + γ)⁻¹ of each block by itself
//   p = z + p (r·z)/(r·z)_before
//   α = (r·z)/(p·(Jq + γp))
//   λ += αp,   V += αq,   r -= α(Jq + γp)
//
// A bound would break the conjugacy; see ConjugateSweeps.
//
// Source: M. Hestenes, E. Stiefel, "Methods of conjugate gradients for solving linear systems", J. Research NBS
// 49, 1952. An iteration costs JV and M⁻¹Jᵀλ once for each row, as a sweep does.
namespace byhand {

/// Scratch.
template <class M>
struct ConjugateGradientWork {
  template <int K, Bound B>
  using InverseOf = Eigen::Matrix<double, K, K>;

  PerBlock<M, InverseOf> inverses;  // E
  RowScales scales;
  std::vector<double> r, z, p, Ap;  // by row
  std::vector<Velocity<M>> q;       // by body
};

/// Conjugate gradients on the rows of a scene without bounds.
struct ConjugateGradients {
  int iterations = 50;      // >= 1
  double tolerance = 1e-9;  // stop when the residual is at most this share of the largest λ, in [0, 1]
  bool warm_start = true;   // begin with the λ of the last step

  template <class M>
  using Work = ConjugateGradientWork<M>;
  static constexpr bool holds_bounds = false;
  template <class M>
  Solution solve(System<M>& system, Bodies<M>& bodies, Work<M>& work, Begin begin = Begin::step) const;
};

void require_valid(const ConjugateGradients& solver);

}  // namespace byhand
