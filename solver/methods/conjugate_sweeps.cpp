#include "solver/methods/conjugate_sweeps.hpp"

namespace byhand {

void require_valid(const ConjugateSweeps& solver) {
  require(solver.sweeps >= 1, "number of sweeps", solver.sweeps, "at least 1");
  require_valid_tolerance(solver.tolerance);
}

//! [conjugate]
template <class M>
Solution solve(const ConjugateSweeps& solver, System<M>& system, std::vector<Velocity<M>>& velocities,
               Prepared<M>& prepared, Begin begin) {
  prepare(system, BlockSolve::whole, 1.0, prepared);
  prepare_to_watch(system, 1.0, prepared);
  begin_sweeps(system, solver.warm_start, begin, velocities);
  prepared.direction.assign(system.rows(), 0.0);
  prepared.V_direction.assign(velocities.size(), Velocity<M>::Zero());
  const int ways = byhand::ways(solver.order);
  const double speed = fastest(system, velocities);
  double share = 0;
  const auto move_on = [&]<class Number>(std::vector<Number>& now, const std::vector<Number>& before,
                                         std::vector<Number>& direction) {
    for (std::size_t i = 0; i < now.size(); ++i) {
      const Number gradient = now[i] - before[i], onward = share * direction[i];
      now[i] += onward;
      direction[i] = onward + gradient;
    }
  };
  double last = 0;  // the square of the last gradient
  for (int k = 1;; ++k) {
    prepared.lambda_before = system.lambda;
    prepared.V_before = velocities;
    const Residual reached = watched_sweep(system, prepared, system.lambda.data(), numbers<M>(velocities), ways);
    const bool converged = reached.within(solver.tolerance, speed);
    if (converged || !(reached.largest >= 0) || k == solver.sweeps)
      return {ways * k, 0, reached.largest, converged};
    double square = 0;
    for (int i = 0; i < system.rows(); ++i) {
      const double gradient = system.lambda[i] - prepared.lambda_before[i];
      square += prepared.impulse[i] * gradient * gradient;  // for rows differ in their units
    }
    share = square < last ? square / last : 0.0;
    last = square;
    move_on(system.lambda, prepared.lambda_before, prepared.direction);
    move_on(velocities, prepared.V_before, prepared.V_direction);
  }
}
//! [conjugate]

#define BYHAND_INSTANTIATE(M) \
  template Solution solve(const ConjugateSweeps&, System<M>&, std::vector<Velocity<M>>&, Prepared<M>&, Begin)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
