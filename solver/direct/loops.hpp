#pragma once

#include "solver/direct/by_graph.hpp"
#include "solver/direct/newton_work.hpp"

// What ByGraph does with rows that may depend on each other, and contradict each other.
namespace byhand {

/// Loops of rows without bounds, directly. Where rows repeat, or so nearly that their impulses would grow without
/// limit, a regularisation decides between them.
template <class M>
Solution solve_loops(Direct solver, System<M>& system, Bodies<M>& bodies, ByGraphWork<M>& work, Begin begin);

/// Rows with bounds: directly without loops, else by sweeps and by Newton's method. Where contacts hold against
/// rods, pins and welds, these are damped; and no solve makes more energy than energy_limit.hpp allows. Then it
/// has not converged.
template <class M>
Solution solve_bounded(const ByGraph& choices, System<M>& system, Bodies<M>& bodies, ByGraphWork<M>& work,
                       Begin begin);

}  // namespace byhand
