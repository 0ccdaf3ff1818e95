#pragma once

#include "solver/rows/row_solver.hpp"

namespace byhand {

template <class M>
struct Prepared;
struct Residual;

/// The order in which a sweep solves the rows: as the constraints were added, in reverse, by colour (red–black on
/// a chain), or forth and back, which counts as two sweeps.
enum class SweepOrder { natural, reverse, coloured, symmetric };

/// Passes over all rows in one sweep of this order.
inline int passes(SweepOrder order) { return order == SweepOrder::symmetric ? 2 : 1; }
/// How rows are laid out to be swept in this order.
inline Layout layout_for(SweepOrder order) {
  switch (order) {
    case SweepOrder::reverse: return Layout::reverse;
    case SweepOrder::coloured: return Layout::coloured;
    default: return Layout::natural;
  }
}

/// Projected Gauss–Seidel, also called sequential impulses: each block of rows is solved by (17) at the velocities
/// that the blocks before it have left, sweep after sweep.
struct GaussSeidel {
  int sweeps = 10;         // >= 1; a symmetric one is two passes
  bool warm_start = true;  // begin with the λ of the last step
  SweepOrder order = SweepOrder::natural;
  BlockSolve block_solve = BlockSolve::whole;
  double relaxation = 1;  // in (0, 2); other than 1 this is SOR
  double tolerance = 0;   // stop when the residual is at most this share of the largest λ, in [0, 1]; 0: do not
                          // look

  template <class M>
  using Work = Prepared<M>;
  Layout layout() const { return layout_for(order); }
  template <class M>
  Solution solve(System<M>& system, Bodies<M>& bodies, Prepared<M>& prepared, Begin begin = Begin::step) const;
};

inline void require_valid(const GaussSeidel& solver) {
  require(solver.sweeps >= 1, "number of sweeps", solver.sweeps, "at least 1");
  require_inside("relaxation", solver.relaxation, 0, 2);
  require_valid_tolerance(solver.tolerance);
}

/// Applies the initial λ of an iterative solver to the velocities.
template <class M>
void begin_sweeps(System<M>& system, bool warm_start, Begin begin, Bodies<M>& bodies);

/// One sweep over prepared rows in their layout's order; with two `passes` also one back.
template <class M>
void sweep(const System<M>& system, const Prepared<M>& prepared, double* lambda, double* V, int passes = 1);

/// The same; returns the residual of each row at its turn.
template <class M>
Residual watched_sweep(const System<M>& system, const Prepared<M>& prepared, double* lambda, double* V,
                       int passes = 1);

/// At most so many sweeps of so many passes, until the residual is within the tolerance or not a number.
template <class M>
Solution sweep_until(double tolerance, int most, int passes, System<M>& system, const Prepared<M>& prepared,
                     Bodies<M>& bodies);

}  // namespace byhand
