#include "solver/methods/velocity_stepping.hpp"

namespace byhand {

void require_valid(const VelocityStepping& method) {
  std::visit([](const auto& solver) { require_valid(solver); }, method.solver);
  std::visit([](const auto& cure) { require_valid(cure); }, method.drift);
  require(method.substeps >= 1, "number of substeps", method.substeps, "at least 1");
  require_in("bounce threshold", method.bounce_threshold, 0, 1e300, "m/s");
}

//! [split_impulse]
template <class M>
void push_poses(const SplitImpulse& cure, const RowSolver& solver, double h, Bodies<M>& bodies, Work<M>& work) {
  System<M>& system = work.system;
  Pushes& pushes = work.pushes;
  work.velocity = bodies.velocity;
  work.lambda = system.lambda;
  if (!cure.warm_start || pushes.version != work.version || pushes.layout != work.layout)
    pushes.lambda.assign(system.rows(), 0.0);
  pushes.version = work.version;
  pushes.layout = work.layout;
  for (int i = 0; i < system.rows(); ++i) system.lambda[i] += pushes.lambda[i];
  apply_all(system, pushes.lambda, bodies.velocity);
  set_bias(Baumgarte{cure.beta, BetaReading::per_step, cure.slop, cure.speed_cap}, h, system);
  solve_rows(solver, bodies, work, Begin::again);
  for (int i = 0; i < system.rows(); ++i) pushes.lambda[i] = system.lambda[i] - work.lambda[i];
  for (int i = 0; i < bodies.size(); ++i) bodies.velocity[i] -= work.velocity[i];  // P
  advance_poses(bodies, h);
  bodies.velocity = work.velocity;
  system.lambda = work.lambda;
  set_bias(cure, h, system);
}
//! [split_impulse]

#define BYHAND_INSTANTIATE(M) \
  template void push_poses(const SplitImpulse&, const RowSolver&, double, Bodies<M>&, Work<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
