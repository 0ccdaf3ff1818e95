#pragma once

#include "solver/rows/gauss_seidel.hpp"

namespace byhand {

/// Jacobi: every block is solved by (17) at the same velocities, then all impulses are applied at once. It
/// converges only while the largest eigenvalue of D⁻¹A stays below 2/relaxation.
struct Jacobi {
  int sweeps = 10;         // >= 1
  bool warm_start = true;  // begin with the λ of the last step
  double relaxation = 1;   // in (0, 2)
  BlockSolve block_solve = BlockSolve::whole;
};

void require_valid(const Jacobi& solver);

template <class M>
Solution solve(const Jacobi& solver, System<M>& system, std::vector<Velocity<M>>& velocities,
               Prepared<M>& prepared, Begin begin = Begin::step);

}  // namespace byhand
