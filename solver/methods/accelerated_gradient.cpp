#include "solver/methods/accelerated_gradient.hpp"

#include <cmath>

namespace byhand {
namespace {

/// D: the diagonal of A + γ. Both tangents of friction in space get the larger of theirs, so that Π stays a
/// disc's.
template <class M>
void find_diagonal(const System<M>& system, std::vector<double>& D) {
  system.for_each_run([&]<int K, Bound B>(std::span<const Block<M, K, B>> blocks) {
    for (const auto& block : blocks) {
      double* d = &D[block.row];
      for (int k = 0; k < K; ++k) d[k] = inverse_effective_mass(block.J, block.W, k) + system.gamma[block.row + k];
      if constexpr (K == 2 && B == Bound::friction) d[0] = d[1] = std::max(d[0], d[1]);
    }
  });
}

/// `result` = Π(from - D⁻¹g/L). In natural order, so that a friction finds its normal clamped already.
template <class M>
void step_within_bounds(const System<M>& system, const std::vector<double>& from, const std::vector<double>& g,
                        const std::vector<double>& D, double L, std::vector<double>& result) {
  for (std::size_t i = 0; i < from.size(); ++i) result[i] = D[i] > 0 ? from[i] - g[i] / (L * D[i]) : from[i];
  hold_within_bounds(system, result);
}

}  // namespace

void require_valid(const AcceleratedGradient& solver) {
  require(solver.iterations >= 1, "number of iterations", solver.iterations, "at least 1");
  require_in("tolerance", solver.tolerance, 0, 1e300, "m/s");
}

//! [accelerated_gradient]
template <class M>
int solve(const AcceleratedGradient& solver, System<M>& system, std::vector<Velocity<M>>& velocities,
          AcceleratedGradientWork<M>& work, Begin begin) {
  const int rows = system.rows();
  auto& [D, g, now, y, g_at_y, next, change, best, q] = work;
  for (auto* numbers : {&D, &g, &now, &y, &g_at_y, &next, &change, &best}) numbers->resize(rows);
  q.resize(velocities.size());
  begin_sweeps(system, solver.warm_start, begin, velocities);
  now = best = y = system.lambda;
  find_diagonal(system, D);
  rates_of(system, velocities, g);
  for (int i = 0; i < rows; ++i) g[i] += system.bias[i] + system.gamma[i] * now[i];
  g_at_y = g;

  double L = 1, theta = 1, smallest_error = std::numeric_limits<double>::infinity();
  int passes = 0;
  while (passes < solver.iterations) {
    for (;; L *= 2) {
      step_within_bounds(system, y, g_at_y, D, L, next);
      for (int i = 0; i < rows; ++i) next[i] -= y[i];  // Δ
      multiply(system, next, q, change);
      ++passes;
      double curvature = 0, bound = 0;
      for (int i = 0; i < rows; ++i) {
        curvature += next[i] * change[i];
        bound += next[i] * D[i] * next[i];
      }
      if (curvature <= L * bound * (1 + 1e-12)) break;
    }
    const double theta_next = 0.5 * theta * (std::sqrt(theta * theta + 4) - theta);
    double momentum = theta * (1 - theta) / (theta * theta + theta_next), uphill = 0;
    for (int i = 0; i < rows; ++i) {
      next[i] += y[i];
      change[i] += g_at_y[i];  // g of next
      uphill += g_at_y[i] * (next[i] - now[i]);
    }
    theta = theta_next;
    if (uphill > 0) momentum = 0, theta = 1;
    for (int i = 0; i < rows; ++i) {
      y[i] = next[i] + momentum * (next[i] - now[i]);
      g_at_y[i] = change[i] + momentum * (change[i] - g[i]);
    }
    std::swap(now, next);
    std::swap(g, change);
    L *= 0.9;

    // The error [units of C per second]: what a further step without momentum would change.
    step_within_bounds(system, now, g, D, 1, next);
    double error = 0;
    for (int i = 0; i < rows; ++i) error = std::max(error, D[i] * std::abs(next[i] - now[i]));
    if (error < smallest_error) smallest_error = error, best = now;
    if (error <= solver.tolerance) break;
  }
  for (int i = 0; i < rows; ++i) change[i] = best[i] - system.lambda[i];
  system.lambda = best;
  apply_all(system, change, velocities);
  return passes;
}
//! [accelerated_gradient]

#define BYHAND_INSTANTIATE(M)                                                           \
  template int solve(const AcceleratedGradient&, System<M>&, std::vector<Velocity<M>>&, \
                     AcceleratedGradientWork<M>&, Begin)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
