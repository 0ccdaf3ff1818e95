#pragma once

#include <variant>

#include "solver/direct/direct.hpp"
#include "solver/gauss_seidel.hpp"
#include "solver/methods/accelerated_gradient.hpp"
#include "solver/methods/conjugate_gradients.hpp"
#include "solver/methods/conjugate_sweeps.hpp"
#include "solver/methods/jacobi.hpp"
#include "solver/methods/step_work.hpp"

// How the rows of a step are solved, once they are written.
namespace byhand {

/// The choice left to the scene's graph: what has no loops (chains, trees, columns) is solved directly, the rest
/// by conjugate sweeps that stop when they have nothing more to do.
struct ByGraph {
  Direct loopless = {};
  ConjugateSweeps loops = {};
};

/// Throws std::invalid_argument for a choice outside its range.
void require_valid(const ByGraph& choice);

using RowSolver =
    std::variant<GaussSeidel, Jacobi, Direct, ConjugateSweeps, ByGraph, ConjugateGradients, AcceleratedGradient>;

/// The reference for rows with bounds: conjugate sweeps until one changes no velocity by 1e-14 m/s. It needs no
/// row to be independent of the others, as a direct solve does.
inline ConjugateSweeps exact_sweeps() { return {.sweeps = 1000000, .tolerance = 1e-14}; }

/// What is kept between steps: λ with its system, and scratch.
template <class M>
struct RowWork : StepWork<M> {
  Prepared<M> prepared;
  std::vector<double> change;  // of Jacobi's rows
  ConjugateWork<M> conjugate;
  ConjugateGradientWork<M> conjugate_gradients;
  AcceleratedGradientWork<M> accelerated_gradient;
  DirectWork<M> direct;
};

/// The layout that a solver wants; `loopless` is whether the scene's graph has no loops.
Layout wanted_layout(const RowSolver& solver, bool loopless);

/// Lays the rows out anew if the scene has changed or the solver wants another order.
template <class M>
void lay_out(const Scene<M>& scene, const RowSolver& solver, RowWork<M>& work);

/// Solves the rows of `work.system` by the chosen solver and puts the impulses into the velocities.
template <class M>
void solve_rows(const RowSolver& solver, Bodies<M>& bodies, RowWork<M>& work, Begin begin = Begin::step);

}  // namespace byhand
