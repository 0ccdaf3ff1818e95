#include "solver/direct/by_graph.hpp"

#include "solver/direct/newton_work.hpp"
#include "solver/rows/gauss_seidel.hpp"
#include "solver/rows/operators.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {

template <class M>
Layout ByGraph::layout(const ByGraphWork<M>& work) const {
  return work.directly ? loopless.layout() : loops.layout();
}

template <class M>
std::vector<int> ByGraph::order(const Graph& graph, ByGraphWork<M>& work) const {
  work.loopless = work.directly = has_no_loops(graph);
  if (!work.loopless && !graph.bounded) {
    const long long cost_of_sweeps = 4LL * M::dof * loops.sweeps * row_count(graph),
                    most = std::min(cost_of_sweeps, most_multiplications(graph));
    work.directly = plan_elimination(graph, M::dof, most).multiplications <= most;
  }
  return work.directly ? loopless.order(graph, work.direct) : order_of(loops.layout(), graph);
}

namespace {

/// Solves loops of rows without bounds. Where rows repeat, or so nearly that their impulses would grow without
/// limit, a regularisation decides between them.
template <class M>
Solution solve_loops(Direct solver, System<M>& system, Bodies<M>& bodies, DirectWork<M>& work, Begin begin) {
  constexpr double share = 1e-7;
  solver.smallest_pivot = std::max(solver.smallest_pivot, share);
  try {
    return solver.solve(system, bodies, work, begin);
  } catch (const SingularSystem&) {
    solver.smallest_pivot = 0;
    solver.regularisation = std::max(solver.regularisation, share);
    return solver.solve(system, bodies, work, begin);
  }
}

/// Whether any two moving bodies that share rows differ in mass by more than this ratio.
template <class M>
bool has_unlike_masses(const System<M>& system, double ratio) {
  bool unlike = false;
  for_each_block(system, [&](const BlockHeader& block, const Run&) {
    const double m1 = system.inverse_mass[block.body1].linear, m2 = system.inverse_mass[block.body2].linear;
    unlike = unlike || (block.moves1 && block.moves2 && std::max(m1, m2) > ratio * std::min(m1, m2));
  });
  return unlike;
}

/// Whether a factorisation costs no more than this share of all the sweeps.
template <class M>
bool newton_pays(double share, const ConjugateSweeps& sweeps, const System<M>& system, int bodies,
                 NewtonWork<M>& work) {
  if (work.matrix.layout() != system.layout) work.matrix.plan(system, bodies);
  const double cost_of_sweeps = 4.0 * M::dof * sweeps.sweeps * system.rows();
  return static_cast<double>(work.matrix.multiplications()) <= share * cost_of_sweeps;
}

}  // namespace

template <class M>
Solution ByGraph::solve_bounded_loops(System<M>& system, Bodies<M>& bodies, ByGraphWork<M>& work,
                                      Begin begin) const {
  const auto pays = [&] {
    return newton_pays(work.unlike ? 0.5 : 0.125, loops, system, bodies.size(), work.newton);
  };
  const auto all_sweeps = [&] {
    ConjugateSweeps sweeps = loops;
    if (work.unlike) sweeps.sweeps *= 10;
    return sweeps;
  };
  // What a solve without λ does depends on nothing that was before.
  const bool anew = work.laid_out != system.layout || largest_of(system.lambda) == 0;
  work.laid_out = system.layout;
  work.unlike = has_unlike_masses(system, unlike);
  work.by_newton = (work.by_newton && !anew) || (work.unlike && pays());
  Solution swept;
  if (!work.by_newton) {
    swept = all_sweeps().solve(system, bodies, work.direct.prepared, begin);
    if (swept.converged || !(swept.residual >= 0) || !pays()) return swept;
    work.by_newton = true;
    begin = Begin::resume;
  }
  Solution solution = stalled.solve(system, bodies, work.newton, begin);
  if (!solution.converged) {  // sweeps go on; where masses are alike they are content with less
    ConjugateSweeps sweeps = all_sweeps();
    if (work.unlike) sweeps.tolerance = stalled.tolerance;
    const Solution last = sweeps.solve(system, bodies, work.newton.prepared, Begin::resume);
    solution.passes += last.passes;
    solution.residual = last.residual;
    solution.converged = last.converged;
  }
  solution.passes += swept.passes;
  return solution;
}

template <class M>
Solution ByGraph::solve(System<M>& system, Bodies<M>& bodies, ByGraphWork<M>& work, Begin begin) const {
  if (work.loopless) return loopless.solve(system, bodies, work.direct, begin);
  if (work.directly) return solve_loops(loopless, system, bodies, work.direct, begin);
  if (system.bounded) return solve_bounded_loops(system, bodies, work, begin);
  return loops.solve(system, bodies, work.direct.prepared, begin);
}

#define BYHAND_INSTANTIATE(M)                                                    \
  template Layout ByGraph::layout(const ByGraphWork<M>&) const;                  \
  template std::vector<int> ByGraph::order(const Graph&, ByGraphWork<M>&) const; \
  template Solution ByGraph::solve(System<M>&, Bodies<M>&, ByGraphWork<M>&, Begin) const
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
