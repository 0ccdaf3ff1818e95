#include "solver/rows/conjugate_sweeps.hpp"

#include "solver/rows/operators.hpp"
#include "solver/rows/prepared.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {

namespace {

/// Σ weight (now - before)², four sums at a time: one sum would wait for each addition.
double weighted_square(const std::vector<double>& weight, const std::vector<double>& now,
                       const std::vector<double>& before) {
  double sums[4] = {};
  const std::size_t size = now.size(), fours = size - size % 4;
  const auto term = [&](std::size_t i) { return weight[i] * (now[i] - before[i]) * (now[i] - before[i]); };
  for (std::size_t i = 0; i < fours; i += 4)
    for (std::size_t j = 0; j < 4; ++j) sums[j] += term(i + j);
  for (std::size_t i = fours; i < size; ++i) sums[i - fours] += term(i);
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

/// Moves on along the last direction, after a step from `before` to `now`; that and the way on are the new
/// direction.
void move_on(double share, std::size_t size, const double* before, double* now, double* direction) {
  for (std::size_t i = 0; i < size; ++i) {
    const double gradient = now[i] - before[i], onward = share * direction[i];
    now[i] += onward;
    direction[i] = onward + gradient;
  }
}

}  // namespace

//! [conjugate]
template <class M>
Solution ConjugateSweeps::solve(System<M>& system, Bodies<M>& bodies, Prepared<M>& prepared, Begin begin) const {
  std::vector<Velocity<M>>& velocities = bodies.velocity;
  prepare(system, BlockSolve::whole, 1.0, prepared);
  prepare_to_watch(system, 1.0, prepared);
  begin_sweeps(system, warm_start, begin, bodies);
  const int passes = byhand::passes(order);
  const double speed = fastest(system, velocities);
  prepared.direction.reserve(system.rows());
  prepared.V_direction.reserve(velocities.size());
  double last = 0;  // the square of the last gradient
  for (int k = 1;; ++k) {
    prepared.lambda_before = system.lambda;
    prepared.V_before = velocities;
    const Residual reached = watched_sweep(system, prepared, system.lambda.data(), numbers<M>(velocities), passes);
    const bool converged = reached.within(tolerance, speed);
    if (converged || !(reached.largest >= 0) || k == sweeps) return {passes * k, 0, reached.largest, converged};
    if (k == 1) {
      prepared.direction.assign(system.rows(), 0.0);
      prepared.V_direction.assign(velocities.size(), Velocity<M>::Zero());
    }
    // Rows differ in their units, impulses do not.
    const double square = weighted_square(prepared.impulse, system.lambda, prepared.lambda_before);
    const double share = square < last ? square / last : 0.0;
    last = square;
    move_on(share, system.lambda.size(), prepared.lambda_before.data(), system.lambda.data(),
            prepared.direction.data());
    move_on(share, M::dof * velocities.size(), numbers<M>(prepared.V_before), numbers<M>(velocities),
            numbers<M>(prepared.V_direction));
  }
}
//! [conjugate]

#define BYHAND_INSTANTIATE(M) \
  template Solution ConjugateSweeps::solve(System<M>&, Bodies<M>&, Prepared<M>&, Begin) const
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
