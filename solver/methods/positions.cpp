#include "solver/methods/positions.hpp"

namespace byhand {

template <class M>
Velocity<M> velocity_between(const Pose<M>& before, const Pose<M>& after, double h) {
  Velocity<M> V;
  V.template head<M::linear>() = (after.position - before.position) / h;
  if constexpr (M::angular == 1) V[M::linear] = principal_angle(after.rotation * inverse(before.rotation)) / h;
  if constexpr (M::angular == 3) V.template tail<3>() = turn_of(after.rotation * inverse(before.rotation)) / h;
  return V;
}

template <class M>
void velocities_between(const std::vector<Pose<M>>& before, double h, Bodies<M>& bodies) {
  for (int i = 0; i < bodies.size(); ++i)
    if (moves(bodies.inverse_mass[i])) bodies.velocity[i] = velocity_between<M>(before[i], bodies.pose[i], h);
}

#define BYHAND_INSTANTIATE(M)                                                    \
  template Velocity<M> velocity_between(const Pose<M>&, const Pose<M>&, double); \
  template void velocities_between(const std::vector<Pose<M>>&, double, Bodies<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
