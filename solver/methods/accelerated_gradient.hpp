#pragma once

#include "solver/gauss_seidel.hpp"

// Accelerated projected gradient descent (APGD). Of all λ within their bounds the answer is the one that makes
//
//   f(λ) = ½λᵀ(A + γ)λ + λᵀ(JV₀ + b)                    least; its gradient is g = JV + b + γλ at the V that λ
//   makes
//
// A step goes down the gradient and back within the bounds, from a point y that runs ahead of λ by momentum:
//
//   λ' = Π(y - D⁻¹g(y)/L),     y' = λ' + β(λ' - λ),     β from Nesterov's θ'² = (1 - θ')θ²
//
// with D the diagonal of A + γ, so that rows in metres and in radians, of light and of heavy bodies, step alike. L
// bounds the curvature along the step, Δᵀ(A + γ)Δ <= L ΔᵀDΔ: where it does not, L is doubled and the step taken
// again; after each step it is let down to nine tenths. Momentum is dropped where it points uphill. As f need not
// fall in every iteration, the best λ is kept. The error falls with the square of the iterations, whatever the
// bounds.
//
// A friction's radius is here, as in every solver of this library, μ times the normal impulse that stands: Π holds
// the normals first and then friction within what they press. The paper instead projects normal and friction
// together onto Coulomb's cone, which makes f convex over one fixed set and the method provably convergent, but
// lifts what slides off the ground by μ times its slip. Radii that move with λ are the law of Coulomb without that
// lift, at the price of the proof: where contacts wedge, what is kept is the best that was met.
//
// Source: H. Mazhar, T. Heyn, D. Negrut, A. Tasora, "Using Nesterov's method to accelerate multibody dynamics with
// friction and contact", ACM Transactions on Graphics 34, 2015. An iteration costs JV and M⁻¹Jᵀλ once for each
// row, as a sweep does; a step taken again costs as much.
namespace byhand {

/// Accelerated projected gradient descent on all rows.
struct AcceleratedGradient {
  int iterations = 50;      // >= 1
  double tolerance = 1e-6;  // >= 0: stop once no row is left further from its answer [units of C per second]
  bool warm_start = true;   // begin with the λ of the last step
};

/// Throws std::invalid_argument for a choice outside the ranges above.
void require_valid(const AcceleratedGradient& solver);

/// Scratch by row and by body, kept so that no step allocates.
template <class M>
struct AcceleratedGradientWork {
  std::vector<double> D, g, now, y, g_at_y, next, change, best;
  std::vector<Velocity<M>> q;
};

/// Solves the system's rows for λ and puts the impulses into the velocities. Returns how often it went over all
/// rows.
template <class M>
int solve(const AcceleratedGradient& solver, System<M>& system, std::vector<Velocity<M>>& velocities,
          AcceleratedGradientWork<M>& work, Begin begin = Begin::step);

}  // namespace byhand
