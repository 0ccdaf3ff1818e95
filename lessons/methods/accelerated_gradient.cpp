#include "lessons/methods/accelerated_gradient.hpp"

#include <cmath>

#include "lessons/methods/gradient.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {
namespace {

/// `result` = Π(from - D⁻¹g/L). In natural order, so that a friction finds its normal clamped already.
template <class M>
void step_within_bounds(const System<M>& system, const std::vector<double>& from, const std::vector<double>& g,
                        const std::vector<double>& D, double L, std::vector<double>& result) {
  for (std::size_t i = 0; i < from.size(); ++i) result[i] = D[i] > 0 ? from[i] - g[i] / (L * D[i]) : from[i];
  hold_within_bounds(system, result);
}

/// From λ and its gradient g down to where the residual is within the tolerance, or as far as the iterations
/// allow. `best` becomes the best λ. Returns the number of passes over all rows.
template <class M>
int descend(const AcceleratedGradient& solver, int iterations, double speed, const System<M>& system,
            AcceleratedGradientWork<M>& work) {
  const int rows = system.rows();
  auto& [scales, g, now, y, g_at_y, next, change, best, q] = work;
  const std::vector<double>& D = scales.D;
  now = best = y = system.lambda;
  g_at_y = g;
  double L = 1, theta = 1, smallest = std::numeric_limits<double>::infinity();
  int passes = 0;
  while (passes < iterations) {
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
      if (!(curvature > L * bound * (1 + 1e-12))) break;  // also if it is not a number
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

    const Residual reached = residual(system, now, g, scales);
    const bool done = reached.within(solver.tolerance, speed);
    if (done || reached.largest < smallest) smallest = reached.largest, best = now;
    if (done || std::isnan(reached.largest)) break;
  }
  return passes;
}

}  // namespace

void require_valid(const AcceleratedGradient& solver) { require_valid_descent(solver); }

template <class M>
Solution AcceleratedGradient::solve(System<M>& system, Bodies<M>& bodies, AcceleratedGradientWork<M>& work,
                                    Begin begin) const {
  std::vector<Velocity<M>>& velocities = bodies.velocity;
  for (auto* numbers : {&work.next, &work.change}) numbers->resize(system.rows());
  work.q.resize(velocities.size());
  const double speed = begin_descent(system, warm_start, begin, bodies, work.scales, work.g);
  Solution solution;
  do {
    solution.passes += descend(*this, iterations - solution.passes, speed, system, work);
    for (int i = 0; i < system.rows(); ++i) work.change[i] = work.best[i] - system.lambda[i];
    system.lambda = work.best;
    apply_all(system, work.change, velocities);
    // On the way g is a sum of changes; this is the gradient itself.
    errors_of(system, velocities, system.lambda, work.g);
    const Residual reached = residual(system, system.lambda, work.g, work.scales);
    solution.residual = reached.largest;
    solution.converged = reached.within(tolerance, speed);
  } while (!solution.converged && !std::isnan(solution.residual) && solution.passes < iterations);
  return solution;
}

#define BYHAND_INSTANTIATE(M) \
  template Solution AcceleratedGradient::solve(System<M>&, Bodies<M>&, AcceleratedGradientWork<M>&, Begin) const
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
