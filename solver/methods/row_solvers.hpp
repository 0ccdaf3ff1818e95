#pragma once

#include <variant>

#include "solver/methods/accelerated_gradient.hpp"
#include "solver/methods/conjugate_gradients.hpp"
#include "solver/methods/conjugate_sweeps.hpp"
#include "solver/methods/direct.hpp"
#include "solver/methods/gauss_seidel.hpp"
#include "solver/methods/jacobi.hpp"
#include "solver/scene.hpp"

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

/// The orders in which rows can be laid out.
enum class Layout { none, natural, reverse, coloured, elimination };

/// What is kept between steps: λ with its system, the layout it was made for, and scratch.
template <class M>
struct RowWork {
  System<M> system;
  Prepared<M> prepared;
  std::vector<double> change;  // of Jacobi's rows
  ConjugateWork<M> conjugate;
  ConjugateGradientWork<M> conjugate_gradients;
  AcceleratedGradientWork<M> accelerated_gradient;
  DirectWork<M> direct;
  Layout layout = Layout::none;
  int version = 0;           // of the scene that is laid out
  bool loopless = false;     // its graph
  long long row_solves = 0;  // so far; a direct solve counts as the row-solves that its multiplications would buy
};

/// The layout that a solver wants; `loopless` is whether the scene's graph has no loops.
Layout wanted_layout(const RowSolver& solver, bool loopless);

/// Constraint numbers in that layout; for Layout::elimination this also makes `plan`.
std::vector<int> solve_order(Layout layout, const Graph& graph, int dof, Elimination& plan);

/// Lays the rows out anew if constraints were added or the solver wants another order.
template <class S, class M = typename S::model>
void lay_out(const S& scene, const RowSolver& solver, RowWork<M>& work) {
  if (work.version == scene.version() && work.layout == wanted_layout(solver, work.loopless)) return;
  const Graph graph = scene.graph();
  work.loopless = has_no_loops(graph);
  work.layout = wanted_layout(solver, work.loopless);
  work.version = scene.version();
  scene.lay_out(solve_order(work.layout, graph, M::dof, work.direct.plan), work.system);
  work.direct.views.clear();
}

/// Solves the rows of `work.system` by the chosen solver and puts the impulses into the velocities.
template <class M>
void solve_rows(const RowSolver& solver, Bodies<M>& bodies, RowWork<M>& work, Begin begin = Begin::step);

}  // namespace byhand
