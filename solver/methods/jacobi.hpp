#pragma once

#include "solver/gauss_seidel.hpp"

namespace byhand {

/// Jacobi: every block is solved by (17) from the same velocities, then all impulses are applied at once. It
/// converges only while the largest eigenvalue of D⁻¹A stays below 2/relaxation.
struct Jacobi {
  int sweeps = 10;         // >= 1
  bool warm_start = true;  // begin with the λ of the last step
  double relaxation = 1;   // in (0, 2)
  BlockSolve block_solve = BlockSolve::whole;
};

/// Throws std::invalid_argument for a choice outside the ranges above.
void require_valid(const Jacobi& solver);

/// Solves the system's rows for λ and puts the impulses into the velocities. `prepared` and `change` are scratch
/// that is kept only so that no step allocates. Returns how many sweeps it took.
template <class M>
int solve(const Jacobi& solver, System<M>& system, std::vector<Velocity<M>>& velocities, Prepared<M>& prepared,
          std::vector<double>& change, Begin begin = Begin::step);

}  // namespace byhand
