#include "solver/direct/direct.hpp"

namespace byhand {
namespace {

/// Whether each row of a block can still give way: λ is not at a bound.
template <int K, Bound B>
void note_active(const double* lambda, double lower, double upper, double normal_row, char* active) {
  if constexpr (B == Bound::interval) {
    active[0] = lower < lambda[0] && lambda[0] < upper;
  } else if constexpr (B == Bound::friction) {
    const bool inside = Eigen::Map<const Rows<K>>(lambda).norm() < upper * normal_row;
    for (int k = 0; k < K; ++k) active[k] = inside;
  } else if constexpr (B == Bound::manifold) {
    active[0] = lambda[0] > 0;
    active[1] = lambda[1] > 0;
    active[2] = std::abs(lambda[2]) < upper * (lambda[0] + lambda[1]);
  }
}

template <class M>
void find_active(const System<M>& system, std::vector<char>& active) {
  active.assign(system.rows(), 1);
  system.for_each_run([&]<int K, Bound B>(std::span<const Block<M, K, B>> blocks) {
    if constexpr (B != Bound::none)
      for (const auto& block : blocks)
        note_active<K, B>(&system.lambda[block.row], system.lower[block.row], system.upper[block.row],
                          system.lambda[block.normal_row], &active[block.row]);
  });
}

/// Holds λ within all bounds; `change` becomes what that takes.
template <class M>
void hold(System<M>& system, std::vector<double>& change) {
  std::fill(change.begin(), change.end(), 0.0);
  system.for_each_run([&]<int K, Bound B>(std::span<const Block<M, K, B>> blocks) {
    if constexpr (B != Bound::none)
      for (const auto& block : blocks) {
        Eigen::Map<Rows<K>> lambda(&system.lambda[block.row]);
        const Rows<K> held = bounded<K, B>(lambda, system.lower[block.row], system.upper[block.row],
                                           system.lambda[block.normal_row]);
        for (int k = 0; k < K; ++k) change[block.row + k] = held[k] - lambda[k];
        lambda = held;
      }
  });
}

/// Solves for what λ has still to change by, with rows that are not active left as they are.
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

/// Solves from the λ that stands, without bounds. Once poses have moved, a hub in space has turned its inertia
/// away from that of the rows, if they stand as they were: what this leaves is a small share, and is solved for
/// again.
template <class M>
int settle(const Direct& solver, System<M>& system, Bodies<M>& bodies, DirectWork<M>& work) {
  const auto& nodes = work.plan.nodes;
  const bool turned = M::angular == 3 && solver.factorisation == Factorisation::structured &&
                      std::any_of(nodes.begin(), nodes.end(), [](const auto& node) { return node.edge < 0; });
  const auto largest = [](const std::vector<double>& numbers) {
    return std::abs(*std::max_element(numbers.begin(), numbers.end(),
                                      [](double a, double b) { return std::abs(a) < std::abs(b); }));
  };
  for (int round = 1;; ++round) {
    solve_change(solver, system, bodies, work);
    if (!turned || round == solver.rounds || largest(work.change) <= 1e-14 * largest(system.lambda)) return round;
  }
}

template <class M>
void solve_active(const Direct& solver, System<M>& system, Bodies<M>& bodies, DirectWork<M>& work) {
  solve_change(solver, system, bodies, work);
  hold(system, work.change);
  apply_all(system, work.change, bodies.velocity);
}

/// ½Δλᵀ(A + γ)Δλ + Δλᵀ(JV + b + γλ) of what a solve has added, from both velocities: what impulses within their
/// bounds lower, and begin with at zero. Above it an answer makes energy that no bias asked for.
template <class M>
double objective(const System<M>& system, const std::vector<double>& lambda_before,
                 const std::vector<Velocity<M>>& before, const std::vector<Velocity<M>>& after) {
  double sum = 0;
  system.for_each_run([&]<int K, Bound B>(std::span<const Block<M, K, B>> blocks) {
    for (const auto& block : blocks) {
      const Rows<K> rates = dot(block.J, before[block.body1], before[block.body2]) +
                            dot(block.J, after[block.body1], after[block.body2]);
      for (int k = 0; k < K; ++k) {
        const int row = block.row + k;
        const double now = system.lambda[row], was = lambda_before[row];
        sum += (now - was) * (0.5 * (rates[k] + system.gamma[row] * (now + was)) + system.bias[row]);
      }
    }
  });
  return sum;
}

//! [active_set]
/// Solve what is not at a bound, hold what breaks one, let sweeps tell what else would move. Friction that slides
/// is held at a bound that lags behind its normal; where the two drive each other up, sweeps begin anew.
template <class M>
int solve_with_bounds(const Direct& solver, System<M>& system, Bodies<M>& bodies, Prepared<M>& prepared,
                      DirectWork<M>& work, Begin begin) {
  prepare(system, BlockSolve::whole, 1.0, prepared);
  work.velocity_before = bodies.velocity;
  work.lambda_before = system.lambda;
  if (begin == Begin::step) {
    apply_all(system, system.lambda, bodies.velocity);
    std::fill(work.lambda_before.begin(), work.lambda_before.end(), 0.0);
  }
  const auto sweeps_settle = [&](int most) {
    for (int i = 0; i < most; ++i)
      if (watched_sweep(system, prepared, bodies.velocity) <= solver.tolerance) return true;
    return false;
  };
  for (int round = 1; round <= solver.rounds; ++round) {
    find_active(system, work.active);
    solve_active(solver, system, bodies, work);
    if (sweeps_settle(3)) return round;
  }
  if (!(objective(system, work.lambda_before, work.velocity_before, bodies.velocity) <= 0)) {
    system.lambda = work.lambda_before;
    bodies.velocity = work.velocity_before;
  }
  sweeps_settle(100 * solver.rounds);
  return solver.rounds;
}
//! [active_set]

}  // namespace

void require_valid(const Direct& solver) {
  require_in("regularisation", solver.regularisation, 0, 1);
  require(solver.rounds >= 1, "number of rounds", solver.rounds, "at least 1");
  require_positive("tolerance", solver.tolerance, "m/s");
}

template <class M>
int solve(const Direct& solver, System<M>& system, Bodies<M>& bodies, Prepared<M>& prepared, DirectWork<M>& work,
          Begin begin) {
  if (system.rows() == 0) return 0;
  if (system.bounded || begin == Begin::again) {
    work.offset.resize(system.rows());
    work.change.resize(system.rows());
  }
  if (system.bounded) return solve_with_bounds(solver, system, bodies, prepared, work, begin);
  work.active.clear();
  if (begin == Begin::again) return settle(solver, system, bodies, work);
  solve_equations(solver, system, system.bias, bodies, work, system.lambda);
  apply_all(system, system.lambda, bodies.velocity);
  return 1;
}

#define BYHAND_INSTANTIATE(M) \
  template int solve(const Direct&, System<M>&, Bodies<M>&, Prepared<M>&, DirectWork<M>&, Begin)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
