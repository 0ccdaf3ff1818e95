#include "solver/direct/loops.hpp"

#include <algorithm>

#include "solver/direct/correction_limit.hpp"
#include "solver/direct/energy_limit.hpp"
#include "solver/rows/operators.hpp"
#include "solver/rows/residual.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {
namespace {

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
      result.of_all = larger(result.of_all, asked + scale * std::abs(system.target_rate[row]));
      if (B != Bound::none) continue;
      result.of_unbounded = larger(result.of_unbounded, asked);
      result.left_of_unbounded = larger(result.left_of_unbounded, scale * std::abs(work.error[row]));
    }
  });
  return result;
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

/// Whether a factorisation costs little beside all the sweeps.
template <class M>
bool newton_pays(const ByGraph& choices, const System<M>& system, int bodies, ByGraphWork<M>& work) {
  Envelope<M>& matrix = work.newton.matrix;
  if (matrix.layout() != system.layout) matrix.plan(system, bodies);
  const double cost_of_sweeps = 4.0 * M::dof * choices.loops.sweeps * system.rows();
  return static_cast<double>(matrix.multiplications()) <= (work.unlike ? 0.5 : 0.125) * cost_of_sweeps;
}

/// Ten times as many where masses that touch differ much.
template <class M>
ConjugateSweeps sweeps_for(const ByGraph& choices, const ByGraphWork<M>& work) {
  ConjugateSweeps sweeps = choices.loops;
  if (work.unlike) sweeps.sweeps *= 10;
  return sweeps;
}

/// By sweeps and, where they stall, by Newton's method.
template <class M>
Solution solve_by_sweeps_or_newton(const ByGraph& choices, System<M>& system, Bodies<M>& bodies,
                                   ByGraphWork<M>& work, Begin begin) {
  ConjugateSweeps sweeps = sweeps_for(choices, work);
  Solution swept;
  if (!work.by_newton) {
    swept = sweeps.solve(system, bodies, work.direct.prepared, begin);
    if (swept.converged || !(swept.residual >= 0) || !newton_pays(choices, system, bodies.size(), work))
      return swept;
    work.by_newton = true;
    begin = Begin::resume;
  }
  SemismoothNewton newton = choices.stalled;
  if (work.unlike) newton.rounds *= 5;
  Solution solution = newton.solve(system, bodies, work.newton, begin);
  if (!solution.converged) {  // sweeps go on; where masses are alike they are content with less
    if (work.unlike) sweeps.tolerance = newton.tolerance;
    const Solution last = sweeps.solve(system, bodies, work.newton.prepared, Begin::resume);
    solution.passes += last.passes;
    solution.residual = last.residual;
    solution.converged = last.converged;
  }
  solution.passes += swept.passes;
  return solution;
}

/// Solves anew, without the impulses that rods, pins and welds have wound up against what they cannot move, and
/// with these damped as by limit_correction.
template <class M>
Solution solve_damped(const ConjugateSweeps& sweeps, System<M>& system, Bodies<M>& bodies, ByGraphWork<M>& work) {
  const std::vector<double> gamma = system.gamma;
  for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run&) {
    for (int row = block.row; B == Bound::none && row < block.row + K; ++row)
      system.gamma[row] += damping * work.newton.scales.D[row];
  });
  begin_anew(work.without, system, bodies);
  work.by_newton = false;
  Solution solution = sweeps.solve(system, bodies, work.direct.prepared, Begin::resume);
  system.gamma = gamma;
  solution.converged = false;
  return solution;
}

/// Sweeps or Newton's method, as the masses and the solves before suggest. Where bodies are held by
/// rods, pins and welds that contradict their contacts, these are damped.
template <class M>
Solution solve_bounded_loops(const ByGraph& choices, System<M>& system, Bodies<M>& bodies, ByGraphWork<M>& work,
                             Begin begin) {
  const double speed = fastest(system, bodies.velocity);
  // What a solve without λ does depends on nothing that was before.
  const bool anew = work.laid_out != system.layout || largest_of(system.lambda) == 0;
  work.laid_out = system.layout;
  work.unlike = has_unlike_masses(system, choices.unlike);
  work.by_newton = (work.by_newton && !anew) || (work.unlike && newton_pays(choices, system, bodies.size(), work));
  Solution solution = solve_by_sweeps_or_newton(choices, system, bodies, work, begin);
  if (solution.residual <= 0.1 * unmet * speed) return solution;
  const auto [of_all, of_unbounded, left] = demand(system, bodies, work.newton);
  if (of_unbounded > speed && left > 0.25 * of_unbounded) {
    const int passes = solution.passes;
    solution = solve_damped(sweeps_for(choices, work), system, bodies, work);
    solution.passes += passes;
  }
  solution.converged = solution.converged && solution.residual <= unmet * larger(speed, of_all);
  return solution;
}

}  // namespace

template <class M>
Solution solve_loops(Direct solver, System<M>& system, Bodies<M>& bodies, ByGraphWork<M>& work, Begin begin) {
  constexpr double share = 1e-7;
  solver.smallest_pivot = std::max(solver.smallest_pivot, share);
  try {
    return solver.solve(system, bodies, work.direct, begin);
  } catch (const SingularSystem&) {
    solver.smallest_pivot = 0, solver.regularisation = std::max(solver.regularisation, share);
    const double speed = fastest(system, bodies.velocity);
    Solution solution = solver.solve(system, bodies, work.direct, begin);
    const Demand rows = demand(system, bodies, work.newton);
    solution.converged = solution.converged && rows.left_of_unbounded <= unmet * larger(speed, rows.of_all);
    solution += {.passes = 1, .rounds = 1, .row_solves = solution.row_solves / solution.rounds};  // in vain
    return solution;
  }
}

template <class M>
Solution solve_bounded(const ByGraph& choices, System<M>& system, Bodies<M>& bodies, ByGraphWork<M>& work,
                       Begin begin) {
  work.without = bodies.velocity;
  if (begin != Begin::step) apply_all(system, system.lambda, work.without, -1);
  const auto solve = [&](Begin from) {
    return work.loopless ? choices.loopless.solve(system, bodies, work.direct, from)
                         : solve_bounded_loops(choices, system, bodies, work, from);
  };
  Solution solution = solve(begin);
  const bool limited = limit_energy(work.without, solution.converged, system, bodies, work.still,
                                    [&] { solution += solve(Begin::resume); });
  solution.converged = solution.converged && !limited;
  return solution;
}

#define BYHAND_INSTANTIATE(M)                                                            \
  template Solution solve_loops(Direct, System<M>&, Bodies<M>&, ByGraphWork<M>&, Begin); \
  template Solution solve_bounded(const ByGraph&, System<M>&, Bodies<M>&, ByGraphWork<M>&, Begin)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
