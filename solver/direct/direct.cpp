#include "solver/direct/direct.hpp"

#include "solver/direct/correction_limit.hpp"
#include "solver/rows/gauss_seidel.hpp"
#include "solver/rows/operators.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {
namespace {

/// Marks the rows whose λ is not at a bound.
template <class M>
void find_active(const System<M>& system, std::vector<char>& active) {
  active.assign(system.rows(), 1);
  system.for_each_run([&]<int K, Bound B>(std::span<const Block<M, K, B>> blocks) {
    if constexpr (B != Bound::none)
      for (const auto& block : blocks) {
        const double *lambda = &system.lambda[block.row], upper = system.upper[block.row];
        char* is_active = &active[block.row];
        if constexpr (B == Bound::interval) {
          is_active[0] = system.lower[block.row] < lambda[0] && lambda[0] < upper;
        } else if constexpr (B == Bound::friction) {
          const double radius = upper * system.lambda[block.normal_row];
          std::fill_n(is_active, K, Eigen::Map<const Rows<K>>(lambda).norm() < radius);
        } else {
          is_active[0] = lambda[0] > 0;
          is_active[1] = lambda[1] > 0;
          is_active[2] = std::abs(lambda[2]) < upper * (lambda[0] + lambda[1]);
        }
      }
  });
}

/// Solves for Δλ of the active rows and applies it.
template <class M>
void solve_change(const Direct& solver, System<M>& system, Bodies<M>& bodies, DirectWork<M>& work) {
  for (int k = 0; k < system.rows(); ++k) work.offset[k] = system.bias[k] + system.gamma[k] * system.lambda[k];
  solve_equations(solver, system, work.offset, bodies, work, work.change);
  for (int k = 0; k < system.rows(); ++k) {
    if (!work.active.empty() && !work.active[k]) work.change[k] = 0;
    system.lambda[k] += work.change[k];
  }
  apply_all(system, work.change, bodies.velocity);
}

/// Solves without bounds from the current λ. In space the inertia of a hub turns with its pose, while the rows may
/// be those of an earlier pose. The error of this mismatch is small, and iteration removes it.
template <class M>
Solution solve_resumed(const Direct& solver, System<M>& system, Bodies<M>& bodies, DirectWork<M>& work) {
  const auto& nodes = work.plan.nodes;
  const bool turned = M::angular == 3 && solver.factorisation == Factorisation::structured &&
                      std::any_of(nodes.begin(), nodes.end(), [](const auto& node) { return node.edge < 0; });
  for (int round = 1;; ++round) {
    solve_change(solver, system, bodies, work);
    const bool converged = !turned || largest_of(work.change) <= 1e-14 * largest_of(system.lambda);
    if (converged || round == solver.rounds)
      return {0, round, std::numeric_limits<double>::quiet_NaN(), converged};
  }
}

/// ½Δλᵀ(A + γ)Δλ + Δλᵀ(JV + b + γλ) for the Δλ since the solve began, from the velocities before and after.
/// Impulses within their bounds minimise it, and it begins at zero: a positive value is energy that no bias asked
/// for.
template <class M>
double objective(const System<M>& system, const std::vector<Velocity<M>>& velocity, DirectWork<M>& work) {
  rates_of(system, work.velocity_before, work.offset);
  rates_of(system, velocity, work.change);
  double sum = 0;
  for (int k = 0; k < system.rows(); ++k) {
    const double rates = work.offset[k] + work.change[k], now = system.lambda[k], was = work.lambda_before[k];
    sum += (now - was) * (0.5 * (rates + system.gamma[k] * (now + was)) + system.bias[k]);
  }
  return sum;
}

/// Solves the rows that are not at a bound, clamps λ, and lets sweeps find the rows that change sides. The bounds
/// of friction follow the normal impulses with a delay. If the two drive each other up, sweeps start again from
/// the beginning.
template <class M>
Solution solve_with_bounds(const Direct& solver, System<M>& system, Bodies<M>& bodies, DirectWork<M>& work,
                           Begin begin) {
  Prepared<M>& prepared = work.prepared;
  prepare(system, BlockSolve::whole, 1.0, prepared);
  prepare_to_watch(system, 1.0, prepared);
  work.velocity_before = bodies.velocity;
  work.lambda_before = system.lambda;
  if (begin == Begin::step) {
    apply_all(system, system.lambda, bodies.velocity);
    std::fill(work.lambda_before.begin(), work.lambda_before.end(), 0.0);
  }
  int passes = 0, round = 0;
  const auto swept = [&](int most) {
    Solution solution = sweep_until(solver.tolerance, most, 1, system, prepared, bodies);
    solution.passes = passes += solution.passes;
    solution.rounds = round;
    return solution;
  };
  while (round < solver.rounds) {
    ++round;
    find_active(system, work.active);
    solve_change(solver, system, bodies, work);
    work.change = system.lambda;
    hold_within_bounds(system, system.lambda);
    for (int k = 0; k < system.rows(); ++k) work.change[k] = system.lambda[k] - work.change[k];
    apply_all(system, work.change, bodies.velocity);
    if (const Solution solution = swept(3); solution.converged) return solution;
  }
  if (!(objective(system, bodies.velocity, work) <= 0)) {
    system.lambda = work.lambda_before;
    bodies.velocity = work.velocity_before;
  }
  return swept(100 * solver.rounds);
}

}  // namespace

template <class M>
std::vector<int> Direct::order(const Graph& graph, DirectWork<M>& work) const {
  if (factorisation == Factorisation::dense) return order_of(Layout::natural, graph);
  std::vector<int> order = elimination_order(graph, M::dof, work.plan);
  work.planned += work.plan.planned;
  return order;
}

template <class M>
Solution Direct::solve(System<M>& system, Bodies<M>& bodies, DirectWork<M>& work, Begin begin) const {
  if (system.rows() == 0) return {};
  work.offset.resize(system.rows());
  work.change.resize(system.rows());
  std::optional<bool> damped;  // nothing where dependence was not even suspected
  const auto solved = [&]() -> Solution {
    if (system.bounded) return solve_with_bounds(*this, system, bodies, work, begin);
    work.active.clear();
    if (begin == Begin::resume) return solve_resumed(*this, system, bodies, work);
    solve_equations(*this, system, system.bias, bodies, work, system.lambda);
    if (factorisation == Factorisation::structured) damped = limit_correction(*this, system, bodies, work);
    apply_all(system, system.lambda, bodies.velocity);
    return {0, damped == true ? 2 : 1, std::numeric_limits<double>::quiet_NaN(), damped != true};
  };
  Solution solution = solved();
  solution.row_solves = solution.rounds * direct_row_solves(*this, work.plan, system.rows(), M::dof);
  if (damped == false) solution.row_solves += row_solves_again(work.plan, M::dof);
  return solution;
}

#define BYHAND_INSTANTIATE(M)                                                  \
  template std::vector<int> Direct::order(const Graph&, DirectWork<M>&) const; \
  template Solution Direct::solve(System<M>&, Bodies<M>&, DirectWork<M>&, Begin) const
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
