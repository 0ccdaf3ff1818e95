#include "solver/methods/row_solvers.hpp"

namespace byhand {

void require_valid(const ByGraph& choice) {
  require_valid(choice.loopless);
  require_valid(choice.loops);
}

Layout wanted_layout(const RowSolver& solver, bool loopless) {
  return std::visit(
      [&](const auto& choice) {
        if constexpr (requires { choice.loopless; })
          return loopless ? wanted_layout(choice.loopless, true) : wanted_layout(choice.loops, false);
        if constexpr (requires { choice.order; }) {
          if (choice.order == SweepOrder::reverse) return Layout::reverse;
          if (choice.order == SweepOrder::coloured) return Layout::coloured;
        }
        if constexpr (requires { choice.factorisation; })
          if (choice.factorisation == Factorisation::structured) return Layout::elimination;
        return Layout::natural;
      },
      solver);
}

template <class M>
void lay_out(const Scene<M>& scene, const RowSolver& solver, RowWork<M>& work) {
  if (work.version == scene.version() && work.layout == wanted_layout(solver, work.loopless)) return;
  const Graph graph = scene.graph();
  work.loopless = has_no_loops(graph);
  work.layout = wanted_layout(solver, work.loopless);
  work.version = scene.version();
  scene.lay_out(solve_order(work.layout, graph, M::dof, work.direct.plan), work.system);
}

template <class M>
void solve_rows(const RowSolver& solver, Bodies<M>& bodies, RowWork<M>& work, Begin begin) {
  const long long rows = work.system.rows();
  const auto note = [&](const Solution& solution, long long row_solves_a_round = 0) {
    work.row_solves += solution.passes * rows + solution.rounds * row_solves_a_round;
    work.solution += solution;
  };
  const auto solved = [&](const auto& choice, auto& scratch) {
    note(solve(choice, work.system, bodies.velocity, scratch, begin));
  };
  std::visit(
      [&]<class Choice>(const Choice& choice) {
        if constexpr (std::is_same_v<Choice, ByGraph>)
          work.loopless ? solve_rows(choice.loopless, bodies, work, begin)
                        : solve_rows(choice.loops, bodies, work, begin);
        else if constexpr (std::is_same_v<Choice, Direct>)
          note(solve(choice, work.system, bodies, work.prepared, work.direct, begin),
               direct_row_solves(choice, work.direct.plan, rows, M::dof));
        else if constexpr (std::is_same_v<Choice, ConjugateGradients>)
          solved(choice, work.conjugate_gradients);
        else if constexpr (std::is_same_v<Choice, AcceleratedGradient>)
          solved(choice, work.accelerated_gradient);
        else
          solved(choice, work.prepared);
      },
      solver);
}

BYHAND_DEFINE_COPIES(RowWork)

#define BYHAND_INSTANTIATE(M)                                            \
  template struct RowWork<M>;                                            \
  template void lay_out(const Scene<M>&, const RowSolver&, RowWork<M>&); \
  template void solve_rows(const RowSolver&, Bodies<M>&, RowWork<M>&, Begin)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
