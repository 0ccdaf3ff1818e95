#include "solver/cures/split_impulse.hpp"

#include "solver/integrate/euler.hpp"
#include "solver/rows/operators.hpp"
#include "solver/support/each_model.hpp"
#include "solver/work.hpp"

namespace byhand {

/// The poses have moved by hV; now they move by hP.
template <class M>
void SplitImpulse::after_move(Stage<M>& stage) const {
  System<M>& system = stage.work.system;
  Bodies<M>& bodies = stage.scene.state();
  auto& [pseudo_impulses, layout, lambda, velocity] = kept_as<SplitImpulseWork<M>>(stage.kept);
  velocity = bodies.velocity;
  lambda = system.lambda;
  if (!warm_start || layout != system.layout) pseudo_impulses.assign(system.rows(), 0.0);
  layout = system.layout;
  for (int i = 0; i < system.rows(); ++i) system.lambda[i] += pseudo_impulses[i];
  apply_all(system, pseudo_impulses, bodies.velocity);
  set_bias({beta / stage.h, slop, speed_cap}, stage.h, system);
  stage.solve_rows_again();
  for (int i = 0; i < system.rows(); ++i) pseudo_impulses[i] = system.lambda[i] - lambda[i];
  for (int i = 0; i < bodies.size(); ++i) bodies.velocity[i] -= velocity[i];  // P
  advance_poses(bodies, stage.h);
  bodies.velocity = velocity;
  system.lambda = lambda;
  set_bias(correction(stage.h), stage.h, system);
}

#define BYHAND_INSTANTIATE(M) template void SplitImpulse::after_move(Stage<M>&) const
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
