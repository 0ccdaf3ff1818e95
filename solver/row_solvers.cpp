#include "solver/row_solvers.hpp"

namespace byhand {

void require_valid(const ByGraph& choice) {
  require_valid(choice.loopless);
  require_valid(choice.loops);
}

Layout wanted_layout(const RowSolver& solver, bool directly) {
  return std::visit(
      [&](const auto& choice) {
        if constexpr (requires { choice.loopless; })
          return directly ? wanted_layout(choice.loopless, true) : wanted_layout(choice.loops, false);
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
  if (work.version == scene.version() && work.solver == solver.index() &&
      work.layout == wanted_layout(solver, work.directly))
    return;
  const Graph graph = scene.graph();
  const auto bounded = [&](const auto& entry) { return scene.store(entry.kind).bound != Bound::none; };
  work.loopless = work.directly = has_no_loops(graph);
  if (const auto* choice = std::get_if<ByGraph>(&solver);
      choice && !work.loopless && std::none_of(scene.entries().begin(), scene.entries().end(), bounded)) {
    const long long sweeps = 4LL * M::dof * choice->loops.sweeps * row_count(graph),
                    most = std::min(sweeps, most_multiplications(graph));
    work.directly = plan_elimination(graph, M::dof, most).multiplications <= most;
  }
  work.layout = wanted_layout(solver, work.directly);
  work.version = scene.version();
  work.solver = solver.index();
  scene.lay_out(solve_order(work.layout, graph, M::dof, work.direct.plan), work.system);
}

/// Solves loops of rows without bounds. Where rows repeat, or so nearly that their impulses would grow without
/// limit, a regularisation decides between them.
template <class M>
void solve_loops(Direct solver, Bodies<M>& bodies, RowWork<M>& work, Begin begin) {
  constexpr double share = 1e-7;
  solver.smallest_pivot = std::max(solver.smallest_pivot, share);
  try {
    solve_rows(solver, bodies, work, begin);
  } catch (const SingularSystem&) {
    solver.smallest_pivot = 0;
    solver.regularisation = std::max(solver.regularisation, share);
    solve_rows(solver, bodies, work, begin);
  }
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
          work.loopless   ? solve_rows(choice.loopless, bodies, work, begin)
          : work.directly ? solve_loops(choice.loopless, bodies, work, begin)
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
