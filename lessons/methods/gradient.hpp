#pragma once

#include "solver/rows/gauss_seidel.hpp"
#include "solver/rows/operators.hpp"
#include "solver/rows/residual.hpp"

// What conjugate and accelerated gradients begin with.
namespace byhand {

/// Applies the initial λ and finds the scales of the rows and their errors JV + b + γλ, which are the gradient.
/// Returns the speed of the fastest body [m/s].
template <class M>
double begin_descent(System<M>& system, bool warm_start, Begin begin, Bodies<M>& bodies, RowScales& scales,
                     std::vector<double>& error) {
  begin_sweeps(system, warm_start, begin, bodies);
  find_scales(system, scales);
  error.resize(system.rows());
  errors_of(system, bodies.velocity, system.lambda, error);
  return fastest(system, bodies.velocity);
}

template <class Solver>
void require_valid_descent(const Solver& solver) {
  require(solver.iterations >= 1, "number of iterations", solver.iterations, "at least 1");
  require_valid_tolerance(solver.tolerance);
}

}  // namespace byhand
