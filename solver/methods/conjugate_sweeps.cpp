#include "solver/methods/conjugate_sweeps.hpp"

namespace byhand {

void require_valid(const ConjugateSweeps& solver) {
  require(solver.sweeps >= 1, "number of sweeps", solver.sweeps, "at least 1");
  require_in("tolerance", solver.tolerance, 0, 1e300, "m/s");
}

//! [conjugate]
template <class M>
int solve(const ConjugateSweeps& solver, System<M>& system, std::vector<Velocity<M>>& velocities,
          Prepared<M>& prepared, ConjugateWork<M>& work, Begin begin) {
  prepare(system, BlockSolve::whole, 1.0, prepared);
  begin_sweeps(system, solver.warm_start, begin, velocities);
  work.direction.assign(system.rows(), 0.0);
  work.V_direction.assign(velocities.size(), Velocity<M>::Zero());
  const int ways = byhand::ways(solver.order);
  double last = 0;  // the square of the last gradient
  for (int k = 1; k <= solver.sweeps; ++k) {
    work.before = system.lambda;
    const double change = watched_sweep(system, prepared, velocities, ways);
    if (change <= solver.tolerance || k == solver.sweeps) return ways * k;
    double square = 0;
    for (int i = 0; i < system.rows(); ++i) {
      const double gradient = system.lambda[i] - work.before[i];
      square += gradient * gradient;
    }
    const double share = square < last ? square / last : 0.0;
    last = square;
    for (int i = 0; i < system.rows(); ++i) {
      const double gradient = system.lambda[i] - work.before[i], onward = share * work.direction[i];
      system.lambda[i] += onward;
      work.direction[i] = onward + gradient;
    }
    for (std::size_t i = 0; i < velocities.size(); ++i) {
      const Velocity<M> gradient = velocities[i] - prepared.before[i], onward = share * work.V_direction[i];
      velocities[i] += onward;
      work.V_direction[i] = onward + gradient;
    }
  }
  return ways * solver.sweeps;
}
//! [conjugate]

#define BYHAND_INSTANTIATE(M)                                                                     \
  template int solve(const ConjugateSweeps&, System<M>&, std::vector<Velocity<M>>&, Prepared<M>&, \
                     ConjugateWork<M>&, Begin)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
