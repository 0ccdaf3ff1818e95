#include "solver/methods/split_impulse.hpp"

#include "solver/integrate/euler.hpp"

namespace byhand {

//! [split_impulse]
template <class M>
void push_poses(const SplitImpulse& cure, const RowSolver& solver, double h, Bodies<M>& bodies, RowWork<M>& rows,
                SplitImpulseWork<M>& work) {
  System<M>& system = rows.system;
  work.velocity = bodies.velocity;
  work.lambda = system.lambda;
  if (!cure.warm_start || work.layout != system.layout) work.pushes.assign(system.rows(), 0.0);
  work.layout = system.layout;
  for (int i = 0; i < system.rows(); ++i) system.lambda[i] += work.pushes[i];
  apply_all(system, work.pushes, bodies.velocity);
  set_bias({cure.beta / h, cure.slop, cure.speed_cap}, h, system);
  solve_rows(solver, bodies, rows, Begin::resume);
  for (int i = 0; i < system.rows(); ++i) work.pushes[i] = system.lambda[i] - work.lambda[i];
  for (int i = 0; i < bodies.size(); ++i) bodies.velocity[i] -= work.velocity[i];  // P
  advance_poses(bodies, h);
  bodies.velocity = work.velocity;
  system.lambda = work.lambda;
  set_bias(correction(cure, h), h, system);
}
//! [split_impulse]

#define BYHAND_INSTANTIATE(M)                                                                      \
  template void push_poses(const SplitImpulse&, const RowSolver&, double, Bodies<M>&, RowWork<M>&, \
                           SplitImpulseWork<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
