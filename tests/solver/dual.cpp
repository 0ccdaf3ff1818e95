#include "tests/solver/dual.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {

template <class M>
Pose<M, Dual> moving(const Pose<M>& pose, const Velocity<M>& V) {
  return moved<M, Dual>(cast<Dual, M>(pose), Velocity<M, Dual>(V.template cast<Dual>()), Dual(0, 1));
}

#define INSTANTIATE(M) template Pose<M, Dual> moving<M>(const Pose<M>& pose, const Velocity<M>& V)

BYHAND_FOR_EACH_MODEL(INSTANTIATE);

}  // namespace byhand
