#include "solver/methods/velocity_stepping.hpp"

#include <numeric>

namespace byhand {

void require_valid(const ByGraph& choice) {
  require_valid(choice.loopless);
  require_valid(choice.loops);
}

void require_valid(const VelocityStepping& method) {
  std::visit([](const auto& solver) { require_valid(solver); }, method.solver);
  std::visit([](const auto& cure) { require_valid(cure); }, method.drift);
  require(method.substeps >= 1, "number of substeps", method.substeps, "at least 1");
  require_in("bounce threshold", method.bounce_threshold, 0, 1e300, "m/s");
}

Layout wanted_layout(const RowSolver& solver, bool loopless) {
  const auto of_direct = [](const Direct& direct) {
    return direct.factorisation == Factorisation::structured ? Layout::elimination : Layout::natural;
  };
  const auto of_sweeps = [](SweepOrder order) {
    switch (order) {
      case SweepOrder::reverse: return Layout::reverse;
      case SweepOrder::coloured: return Layout::coloured;
      default: return Layout::natural;
    }
  };
  if (const auto* direct = std::get_if<Direct>(&solver)) return of_direct(*direct);
  if (const auto* sweeps = std::get_if<GaussSeidel>(&solver)) return of_sweeps(sweeps->order);
  if (const auto* conjugate = std::get_if<ConjugateSweeps>(&solver)) return of_sweeps(conjugate->order);
  if (const auto* by_graph = std::get_if<ByGraph>(&solver))
    return loopless ? of_direct(by_graph->loopless) : of_sweeps(by_graph->loops.order);
  return Layout::natural;
}

std::vector<int> solve_order(Layout layout, const Graph& graph, int dof, Elimination& plan) {
  if (layout == Layout::coloured) return coloured_order(graph);
  if (layout == Layout::elimination) {
    plan = plan_elimination(graph, dof);
    return plan.order;
  }
  std::vector<int> order(graph.edges.size());
  std::iota(order.begin(), order.end(), 0);
  if (layout == Layout::reverse) std::reverse(order.begin(), order.end());
  return order;
}

namespace {

/// What a direct solve costs in row-solves: one of those multiplies 2 dof numbers for JV (8) and 2 dof for
/// (20).
long long direct_row_solves(const Direct& solver, const Elimination& plan, long long rows, int dof) {
  const long long dense = rows * rows * rows / 6 + rows * rows;
  return (solver.factorisation == Factorisation::dense ? dense : plan.multiplications) / (4 * dof) + 1;
}

}  // namespace

template <class M>
void solve_rows(const RowSolver& solver, Bodies<M>& bodies, Work<M>& work, Begin begin) {
  const long long rows = work.system.rows();
  const auto by_conjugate_sweeps = [&](const ConjugateSweeps& choice) {
    work.row_solves += rows * solve(choice, work.system, bodies.velocity, work.conjugate, begin);
  };
  const auto directly = [&](const Direct& choice) {
    const int rounds = solve(choice, work.system, bodies, work.direct, begin);
    work.row_solves +=
        rounds * (direct_row_solves(choice, work.direct.plan, rows, M::dof) + (work.system.bounded ? rows : 0));
  };
  if (const auto* gauss_seidel = std::get_if<GaussSeidel>(&solver)) {
    work.row_solves += rows * solve(*gauss_seidel, work.system, bodies.velocity, work.gauss_seidel, begin);
  } else if (const auto* jacobi = std::get_if<Jacobi>(&solver)) {
    solve(*jacobi, work.system, bodies.velocity, work.jacobi, begin);
    work.row_solves += jacobi->sweeps * rows;
  } else if (const auto* direct = std::get_if<Direct>(&solver)) {
    directly(*direct);
  } else if (const auto* conjugate = std::get_if<ConjugateSweeps>(&solver)) {
    by_conjugate_sweeps(*conjugate);
  } else if (const auto& by_graph = std::get<ByGraph>(solver); work.loopless) {
    directly(by_graph.loopless);
  } else {
    by_conjugate_sweeps(by_graph.loops);
  }
}

#define BYHAND_INSTANTIATE(M) template void solve_rows(const RowSolver&, Bodies<M>&, Work<M>&, Begin)
BYHAND_INSTANTIATE(PlaneParticle);
BYHAND_INSTANTIATE(PlaneBody);
BYHAND_INSTANTIATE(SpaceParticle);
BYHAND_INSTANTIATE(SpaceBody);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
