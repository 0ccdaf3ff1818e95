#pragma once

#include "solver/rows/residual.hpp"
#include "solver/rows/row_solver.hpp"

// Accelerated projected gradient descent (APGD). The answer is the λ within its bounds that minimises
//
//   f(λ) = ½λᵀ(A + γ)λ + λᵀ(JV₀ + b),   with the gradient g = JV + b + γλ at the V that λ makes.
//
// Each step goes down the gradient and is projected onto the bounds, from a point y ahead of λ by momentum:
//
//   λ' = Π(y - D⁻¹g(y)/L),     y' = λ' + β(λ' - λ),     β from Nesterov's θ'² = (1 - θ')θ²
//
// D is that of the natural map, so that rows in metres and in radians, of light and of heavy bodies, take similar
// steps. L bounds the curvature along the step, Δᵀ(A + γ)Δ <= L ΔᵀDΔ: where it does not, L is doubled and the step
// repeated; after each step L is reduced to nine tenths. Momentum is dropped where it points uphill. f may rise in
// an iteration, so the best λ is kept. The error falls with the square of the iterations, whatever the bounds.
//
// As in all solvers here, the radius of friction is μ times the current normal impulse: Π clamps first the
// normals, then friction. The paper projects both together onto Coulomb's cone. This makes f convex over a fixed
// set and the method provably convergent, but lifts sliding bodies off the ground by μ times their slip. Radii
// that move with λ are Coulomb's law without that lift and without the proof: where contacts wedge, the result is
// the best λ found.
//
// Source: H. Mazhar, T. Heyn, D. Negrut, A. Tasora, "Using Nesterov's method to accelerate multibody dynamics with
// friction and contact", ACM Transactions on Graphics 34, 2015. An iteration costs JV and M⁻¹Jᵀλ once for each
// row, as a sweep does, and a repeated step as much again.
namespace byhand {

/// Scratch, by row and by body.
template <class M>
struct AcceleratedGradientWork {
  RowScales scales;
  std::vector<double> g, now, y, g_at_y, next, change, best;
  std::vector<Velocity<M>> q;
};

/// Accelerated projected gradient descent on all rows.
struct AcceleratedGradient {
  int iterations = 50;      // >= 1
  double tolerance = 1e-6;  // stop when the residual is at most this share of the largest λ, in [0, 1]
  bool warm_start = true;   // begin with the λ of the last step

  template <class M>
  using Work = AcceleratedGradientWork<M>;
  template <class M>
  Solution solve(System<M>& system, Bodies<M>& bodies, Work<M>& work, Begin begin = Begin::step) const;
};

void require_valid(const AcceleratedGradient& solver);

}  // namespace byhand
