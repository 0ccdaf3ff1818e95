#pragma once

#include <variant>

#include "solver/direct/direct.hpp"
#include "solver/rows/accelerated_gradient.hpp"
#include "solver/rows/conjugate_gradients.hpp"
#include "solver/rows/conjugate_sweeps.hpp"
#include "solver/rows/gauss_seidel.hpp"
#include "solver/rows/jacobi.hpp"
#include "solver/step_work.hpp"

namespace byhand {

/// Chooses by the scene's graph: without loops (chains, trees, columns) a direct solve, else conjugate sweeps
/// until they converge. Loops of rows without bounds (linkages, meshes) are solved directly too if that costs no
/// more than the sweeps; where they repeat or nearly do, with a regularisation of 1e-7.
struct ByGraph {
  Direct loopless = {};
  ConjugateSweeps loops = {};
};

void require_valid(const ByGraph& choice);

using RowSolver =
    std::variant<GaussSeidel, Jacobi, Direct, ConjugateSweeps, ByGraph, ConjugateGradients, AcceleratedGradient>;

/// The reference for rows with bounds: conjugate sweeps until the residual is within 1e-12 of the largest push.
/// Unlike a direct solve it allows rows that depend on each other. Where friction wedges it may not come so far:
/// `converged` of the Solution says so.
inline ConjugateSweeps exact_sweeps() { return {.sweeps = 1000000, .tolerance = 1e-12}; }

/// What is kept between steps: λ with its system, and scratch.
template <class M>
struct RowWork : StepWork<M> {
  BYHAND_DECLARE_COPIES(RowWork);

  Solution solution;  // of the last step
  Prepared<M> prepared;
  ConjugateGradientWork<M> conjugate_gradients;
  AcceleratedGradientWork<M> accelerated_gradient;
  DirectWork<M> direct;
};

/// The layout that a solver needs; `directly` as in StepWork.
Layout wanted_layout(const RowSolver& solver, bool directly);

/// Lays the rows out again if the scene has changed or the solver needs another layout.
template <class M>
void lay_out(const Scene<M>& scene, const RowSolver& solver, RowWork<M>& work);

/// Solves the rows of `work.system`, once they are written, and applies the impulses to the velocities.
template <class M>
void solve_rows(const RowSolver& solver, Bodies<M>& bodies, RowWork<M>& work, Begin begin = Begin::step);

}  // namespace byhand
