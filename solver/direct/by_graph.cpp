#include "solver/direct/by_graph.hpp"

#include "solver/direct/newton_work.hpp"
#include "solver/rows/gauss_seidel.hpp"
#include "solver/rows/operators.hpp"
#include "solver/rows/residual.hpp"
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

/// A tolerance is a share of λ, and where rows contradict each other λ grows. So a row does not count as solved
/// that leaves more than this share of the speeds of bodies, and of what rows ask for.
constexpr double unmet = 0.01;

/// What rows ask for, and what a solve has left of it [m/s].
struct Demand {
  double of_all = 0, of_unbounded = 0, left_of_unbounded = 0;
};
template <class M>
Demand demand(const System<M>& system, const Bodies<M>& bodies, NewtonWork<M>& work) {
  Demand result;
  find_scales(system, work.scales);
  work.error.resize(system.rows());
  errors_of(system, bodies.velocity, system.lambda, work.error);
  for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run&) {
    for (int row = block.row; row < block.row + K; ++row) {
      const double D = work.scales.D[row], scale = D > 0 ? work.scales.speed[row] / D : 0.0;
      const double asked = scale * std::abs(system.bias[row] - system.target_rate[row]);
      result.of_all = larger(result.of_all, asked);
      if (B != Bound::none) continue;
      result.of_unbounded = larger(result.of_unbounded, asked);
      result.left_of_unbounded = larger(result.left_of_unbounded, scale * std::abs(work.error[row]));
    }
  });
  return result;
}

/// Solves loops of rows without bounds. Where rows repeat, or so nearly that their impulses would grow without
/// limit, a regularisation decides between them; then they may also contradict each other.
template <class M>
Solution solve_loops(Direct solver, System<M>& system, Bodies<M>& bodies, ByGraphWork<M>& work, Begin begin) {
  constexpr double share = 1e-7;
  solver.smallest_pivot = std::max(solver.smallest_pivot, share);
  try {
    return solver.solve(system, bodies, work.direct, begin);
  } catch (const SingularSystem&) {
    solver.smallest_pivot = 0;
    solver.regularisation = std::max(solver.regularisation, share);
    const double speed = fastest(system, bodies.velocity);
    Solution solution = solver.solve(system, bodies, work.direct, begin);
    const Demand rows = demand(system, bodies, work.newton);
    solution.converged = solution.converged && rows.left_of_unbounded <= unmet * larger(speed, rows.of_all);
    return solution;
  }
}

/// Solves anew, without the impulses that rods, pins and welds have wound up against what they cannot move, and
/// with these damped as by limit_correction.
template <class M>
Solution solve_damped(const ConjugateSweeps& sweeps, System<M>& system, Bodies<M>& bodies, ByGraphWork<M>& work) {
  constexpr double damping = 0.04;
  const std::vector<double> gamma = system.gamma;
  for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run&) {
    for (int row = block.row; B == Bound::none && row < block.row + K; ++row)
      system.gamma[row] += damping * work.newton.scales.D[row];
  });
  for (double& lambda : system.lambda) lambda = -lambda;
  apply_all(system, system.lambda, bodies.velocity);
  std::fill(system.lambda.begin(), system.lambda.end(), 0.0);
  Solution solution = sweeps.solve(system, bodies, work.direct.prepared, Begin::resume);
  system.gamma = gamma;
  solution.converged = false;
  return solution;
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
  const double speed = fastest(system, bodies.velocity);
  const auto checked = [&](Solution solution) {
    if (solution.residual <= 0.1 * unmet * speed) return solution;
    const auto [of_all, of_unbounded, left] = demand(system, bodies, work.newton);
    if (of_unbounded > speed && left > 0.25 * of_unbounded) {
      work.by_newton = false;
      const int passes = solution.passes;
      solution = solve_damped(all_sweeps(), system, bodies, work);
      solution.passes += passes;
    }
    solution.converged = solution.converged && solution.residual <= unmet * larger(speed, of_all);
    return solution;
  };
  // What a solve without λ does depends on nothing that was before.
  const bool anew = work.laid_out != system.layout || largest_of(system.lambda) == 0;
  work.laid_out = system.layout;
  work.unlike = has_unlike_masses(system, unlike);
  work.by_newton = (work.by_newton && !anew) || (work.unlike && pays());
  Solution swept;
  if (!work.by_newton) {
    swept = all_sweeps().solve(system, bodies, work.direct.prepared, begin);
    if (swept.converged || !(swept.residual >= 0) || !pays()) return checked(swept);
    work.by_newton = true;
    begin = Begin::resume;
  }
  SemismoothNewton newton = stalled;
  if (work.unlike) newton.rounds *= 5;
  Solution solution = newton.solve(system, bodies, work.newton, begin);
  if (!solution.converged) {  // sweeps go on; where masses are alike they are content with less
    ConjugateSweeps sweeps = all_sweeps();
    if (work.unlike) sweeps.tolerance = stalled.tolerance;
    const Solution last = sweeps.solve(system, bodies, work.newton.prepared, Begin::resume);
    solution.passes += last.passes;
    solution.residual = last.residual;
    solution.converged = last.converged;
  }
  solution.passes += swept.passes;
  return checked(solution);
}

template <class M>
Solution ByGraph::solve(System<M>& system, Bodies<M>& bodies, ByGraphWork<M>& work, Begin begin) const {
  if (work.loopless) return loopless.solve(system, bodies, work.direct, begin);
  if (work.directly) return solve_loops(loopless, system, bodies, work, begin);
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
