#include "solver/methods/velocity_stepping.hpp"

#include <numeric>

namespace byhand {

void require_valid(const VelocityStepping& method) {
  std::visit([](const auto& solver) { require_valid(solver); }, method.solver);
  std::visit([](const auto& cure) { require_valid(cure); }, method.drift);
  require(method.substeps >= 1, "number of substeps", method.substeps, "at least 1");
}

std::string refusal(const VelocityStepping& method, bool bounded) {
  if (bounded && std::holds_alternative<Direct>(method.solver))
    return "the direct solver cannot hold bounds (contacts, friction); use Gauss-Seidel or Jacobi there";
  return {};
}

Layout wanted_layout(const RowSolver& solver) {
  if (const auto* direct = std::get_if<Direct>(&solver))
    return direct->factorisation == Factorisation::structured ? Layout::elimination : Layout::natural;
  if (const auto* gauss_seidel = std::get_if<GaussSeidel>(&solver)) {
    if (gauss_seidel->order == SweepOrder::reverse) return Layout::reverse;
    if (gauss_seidel->order == SweepOrder::coloured) return Layout::coloured;
  }
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
void solve_rows(const RowSolver& solver, Bodies<M>& bodies, Work<M>& work) {
  if (const auto* gauss_seidel = std::get_if<GaussSeidel>(&solver)) {
    solve(*gauss_seidel, work.system, bodies.velocity, work.gauss_seidel);
    work.row_solves += static_cast<long long>(gauss_seidel->sweeps) * work.system.rows();
  } else if (const auto* jacobi = std::get_if<Jacobi>(&solver)) {
    solve(*jacobi, work.system, bodies.velocity, work.jacobi);
    work.row_solves += static_cast<long long>(jacobi->sweeps) * work.system.rows();
  } else {
    solve(std::get<Direct>(solver), work.system, bodies, work.direct);
    work.row_solves += direct_row_solves(std::get<Direct>(solver), work.direct.plan, work.system.rows(), M::dof);
  }
}

#define BYHAND_INSTANTIATE(M) template void solve_rows(const RowSolver&, Bodies<M>&, Work<M>&)
BYHAND_INSTANTIATE(PlaneParticle);
BYHAND_INSTANTIATE(PlaneBody);
BYHAND_INSTANTIATE(SpaceParticle);
BYHAND_INSTANTIATE(SpaceBody);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
