#pragma once

#include "solver/rows/gauss_seidel.hpp"

namespace byhand {

/// Nonlinear conjugate gradients on sweeps (NNCG): the change that a sweep of projected Gauss–Seidel makes is
/// taken for a gradient. After each sweep λ moves on along the previous direction, by the share of Fletcher and
/// Reeves; where a sweep changes more than the one before, the direction is dropped. The last operation is a
/// sweep, so that λ keeps its bounds. The slow modes of a large system take the square root of the sweeps that
/// Gauss–Seidel takes.
///
/// What a tolerance leaves rocks on: a pyramid of 210 boxes in the plane at 0.6 mm/s with 1e-5, at 0.05 mm/s with
/// 1e-6. In space 50 sweeps end before that, and it rocks at 3 mm/s; with 128 of them at 0.5 mm/s.
///
/// After M. Silcowitz-Hansen, S. Niebe, K. Erleben, "A nonsmooth nonlinear conjugate gradient method for
/// interactive contact force problems", The Visual Computer 26, 2010.
struct ConjugateSweeps {
  int sweeps = 50;                          // >= 1
  bool warm_start = true;                   // begin with the λ of the last step
  SweepOrder order = SweepOrder::coloured;  // the same in every sweep, or there is no gradient
  double tolerance = 1e-6;                  // as of GaussSeidel; 0: stop when nothing is left

  template <class M>
  using Work = Prepared<M>;
  Layout layout() const { return layout_for(order); }
  template <class M>
  Solution solve(System<M>& system, Bodies<M>& bodies, Prepared<M>& prepared, Begin begin = Begin::step) const;
};

inline void require_valid(const ConjugateSweeps& solver) {
  require(solver.sweeps >= 1, "number of sweeps", solver.sweeps, "at least 1");
  require_valid_tolerance(solver.tolerance);
}

/// The reference for rows with bounds: conjugate sweeps until the residual is within 1e-12 of the largest λ.
/// Unlike a direct solve it allows rows that depend on each other. Where friction wedges it may not come so far:
/// `converged` of the Solution says so.
inline ConjugateSweeps exact_sweeps() { return {.sweeps = 1000000, .tolerance = 1e-12}; }

}  // namespace byhand
