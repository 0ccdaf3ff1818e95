#include "solver/methods/row_solvers.hpp"

namespace byhand {
namespace {

/// One function out of several.
template <class... F>
struct Cases : F... {
  using F::operator()...;
};
template <class... F>
Cases(F...) -> Cases<F...>;

/// Calls f with the solver that is meant.
template <class F>
auto with_choice(const RowSolver& solver, bool loopless, F&& f) {
  return std::visit(
      [&]<class Choice>(const Choice& choice) {
        if constexpr (std::is_same_v<Choice, ByGraph>)
          return loopless ? f(choice.loopless) : f(choice.loops);
        else
          return f(choice);
      },
      solver);
}

Layout layout_of(SweepOrder order) {
  switch (order) {
    case SweepOrder::reverse: return Layout::reverse;
    case SweepOrder::coloured: return Layout::coloured;
    default: return Layout::natural;
  }
}

}  // namespace

void require_valid(const ByGraph& choice) {
  require_valid(choice.loopless);
  require_valid(choice.loops);
}

Layout wanted_layout(const RowSolver& solver, bool loopless) {
  return with_choice(solver, loopless, [](const auto& choice) {
    if constexpr (requires { choice.order; })
      return layout_of(choice.order);
    else if constexpr (requires { choice.factorisation; })
      return choice.factorisation == Factorisation::structured ? Layout::elimination : Layout::natural;
    else
      return Layout::natural;
  });
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
  const auto passes = [&](const auto& choice, auto&... scratch) {
    return rows * solve(choice, work.system, bodies.velocity, scratch..., begin);
  };
  work.row_solves += with_choice(
      solver, work.loopless,
      Cases{[&](const GaussSeidel& choice) { return passes(choice, work.prepared); },
            [&](const Jacobi& choice) { return passes(choice, work.prepared, work.change); },
            [&](const ConjugateSweeps& choice) { return passes(choice, work.prepared, work.conjugate); },
            [&](const ConjugateGradients& choice) { return passes(choice, work.conjugate_gradients); },
            [&](const AcceleratedGradient& choice) { return passes(choice, work.accelerated_gradient); },
            [&](const Direct& choice) {
              const int rounds = solve(choice, work.system, bodies, work.prepared, work.direct, begin);
              return rounds * (direct_row_solves(choice, work.direct.plan, rows, M::dof) +
                               (work.system.bounded ? rows : 0));
            }});
}

#define BYHAND_INSTANTIATE(M)                                            \
  template void lay_out(const Scene<M>&, const RowSolver&, RowWork<M>&); \
  template void solve_rows(const RowSolver&, Bodies<M>&, RowWork<M>&, Begin)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
