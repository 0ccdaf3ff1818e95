#include "solver/methods/conjugate_sweeps.hpp"

namespace byhand {

void require_valid(const ConjugateSweeps& solver) {
  require(solver.sweeps >= 1, "number of sweeps", solver.sweeps, "at least 1");
  require_in("tolerance", solver.tolerance, 0, 1e300, "m/s");
}

//! [conjugate]
template <class M>
int solve(const ConjugateSweeps& solver, System<M>& system, std::vector<Velocity<M>>& velocities,
          Prepared<M>& prepared, Begin begin) {
  prepare(system, BlockSolve::whole, 1.0, prepared);
  begin_sweeps(system, solver.warm_start, begin, velocities);
  prepared.direction.assign(system.rows(), 0.0);
  prepared.V_direction.assign(velocities.size(), Velocity<M>::Zero());
  const int ways = byhand::ways(solver.order);
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
  for (int k = 1; k <= solver.sweeps; ++k) {
    prepared.lambda_before = system.lambda;
    const double change = watched_sweep(system, prepared, velocities, ways);
    if (change <= solver.tolerance || k == solver.sweeps) return ways * k;
    double square = 0;
    for (int i = 0; i < system.rows(); ++i) {
      const double gradient = system.lambda[i] - prepared.lambda_before[i];
      square += gradient * gradient;
    }
    share = square < last ? square / last : 0.0;
    last = square;
    move_on(system.lambda, prepared.lambda_before, prepared.direction);
    move_on(velocities, prepared.V_before, prepared.V_direction);
  }
  return ways * solver.sweeps;
}
//! [conjugate]

#define BYHAND_INSTANTIATE(M) \
  template int solve(const ConjugateSweeps&, System<M>&, std::vector<Velocity<M>>&, Prepared<M>&, Begin)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
