#pragma once

#include "solver/rows/row_solver.hpp"

namespace byhand {

template <class M>
struct Prepared;

/// Jacobi: every block is solved by (17) at the same velocities, then all impulses are applied at once. It
/// converges only while the largest eigenvalue of D⁻¹A stays below 2/relaxation.
struct Jacobi {
  int sweeps = 10;         // >= 1
  bool warm_start = true;  // begin with the λ of the last step
  double relaxation = 1;   // in (0, 2)
  BlockSolve block_solve = BlockSolve::whole;

  template <class M>
  using Work = Prepared<M>;
  template <class M>
  Solution solve(System<M>& system, Bodies<M>& bodies, Prepared<M>& prepared, Begin begin = Begin::step) const;
};

inline void require_valid(const Jacobi& solver) {
  require(solver.sweeps >= 1, "number of sweeps", solver.sweeps, "at least 1");
  require_inside("relaxation", solver.relaxation, 0, 2);
}

}  // namespace byhand
