#include "solver/direct/by_graph.hpp"

#include "solver/direct/loops.hpp"
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

template <class M>
Solution ByGraph::solve(System<M>& system, Bodies<M>& bodies, ByGraphWork<M>& work, Begin begin) const {
  if (system.bounded) return solve_bounded(*this, system, bodies, work, begin);
  if (work.loopless) return loopless.solve(system, bodies, work.direct, begin);
  if (work.directly) return solve_loops(loopless, system, bodies, work, begin);
  return loops.solve(system, bodies, work.direct.prepared, begin);
}

#define BYHAND_INSTANTIATE(M)                                                    \
  template Layout ByGraph::layout(const ByGraphWork<M>&) const;                  \
  template std::vector<int> ByGraph::order(const Graph&, ByGraphWork<M>&) const; \
  template Solution ByGraph::solve(System<M>&, Bodies<M>&, ByGraphWork<M>&, Begin) const
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
