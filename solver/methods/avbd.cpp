#include "solver/methods/avbd.hpp"

namespace byhand {

void require_valid(const Avbd& method) {
  require(method.iterations >= 1, "number of iterations", method.iterations, "at least 1");
  require_in("alpha", method.alpha, 0, 1);
  require_in("beta", method.beta, 0, 1e300, "N/m²");
  require_in("memory", method.memory, 0, 1);
  require_positive("softest", method.softest);
  require_positive("stiffest", method.stiffest, "N/m");
  require_in("bounce threshold", method.bounce_threshold, 0, 1e300, "m/s");
}

namespace detail {

template <class M>
void begin_descent(const InverseMass<M>& mass, const Pose<M>& pose, const Pose<M>& free,
                   Eigen::Matrix<double, M::dof, M::dof>& H, Velocity<M>& slope) {
  H.setZero();
  H.diagonal().template head<M::linear>().setConstant(1 / mass.linear);
  if constexpr (M::angular > 0) H.template bottomRightCorner<M::angular, M::angular>() = inertia<M>(mass, pose);
  slope = H.lazyProduct(velocity_between<M>(free, pose, 1));
}

template <class M>
void end_descent(const Eigen::Matrix<double, M::dof, M::dof>& H, const Velocity<M>& slope, Pose<M>& pose) {
  move<M, double>(pose, -H.ldlt().solve(slope), 1);
}

#define BYHAND_INSTANTIATE(M)                                                        \
  template void begin_descent(const InverseMass<M>&, const Pose<M>&, const Pose<M>&, \
                              Eigen::Matrix<double, M::dof, M::dof>&, Velocity<M>&); \
  template void end_descent(const Eigen::Matrix<double, M::dof, M::dof>&, const Velocity<M>&, Pose<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace detail
}  // namespace byhand
