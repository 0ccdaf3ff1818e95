#include "solver/methods/rattle.hpp"

namespace byhand {

void require_valid(const Rattle& family) {
  require(family.substeps >= 1, "number of substeps", family.substeps, "at least 1");
  require_in("regularisation", family.regularisation, 0, 1);
}

template <class M>
void move_kicked(Bodies<M>& bodies, const RattleWork<M>& work) {
  bodies.pose = work.begin.pose;
  bodies.velocity = work.kicked;
  begin_turn(Gyroscopic::implicit, bodies, work.h);
  advance_poses(bodies, work.h);
}

namespace {

/// `work.change` is impulses: into velocities, and to λ.
template <class M>
void give(std::vector<Velocity<M>>& velocities, RattleWork<M>& work) {
  apply_all(work.system, work.change, velocities);
  for (std::size_t row = 0; row < work.change.size(); ++row) work.system.lambda[row] += work.change[row];
}

}  // namespace

template <class M>
void correct_kick(RattleWork<M>& work) {
  solve_again(work.offset, work.direct, work.change);
  work.row_solves += row_solves_again(work.direct.plan, M::dof);
  give(work.kicked, work);
}

template <class M>
void factor_rows(const Bodies<M>& bodies, double regularisation, RattleWork<M>& work) {
  std::fill(work.offset.begin(), work.offset.end(), 0.0);
  solve_rows(regularisation, bodies, work);
}

template <class M>
void stop_rates(Bodies<M>& bodies, RattleWork<M>& work) {
  give(bodies.velocity, work);
}

#define BYHAND_INSTANTIATE(M)                                          \
  template void move_kicked(Bodies<M>&, const RattleWork<M>&);         \
  template void correct_kick(RattleWork<M>&);                          \
  template void factor_rows(const Bodies<M>&, double, RattleWork<M>&); \
  template void stop_rates(Bodies<M>&, RattleWork<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
