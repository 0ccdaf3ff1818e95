#pragma once

#include "solver/row.hpp"
#include "solver/support/each_model.hpp"
#include "tests/solver/dual.hpp"

// Templates of the solver that many tests call, compiled once, in compiled_rows.cpp and compiled_poses.cpp.
namespace byhand {

#define BYHAND_ROWS_OF(kind, M, K)                                                                              \
  kind template void set_row_along<M, K>(Jacobian<M, K>&, int, const Linear<M>&, const Arm<M>&, const Arm<M>&); \
  kind template Rows<K> dot<M, K>(const Jacobian<M, K>&, const Velocity<M>&, const Velocity<M>&);               \
  kind template Jacobian<M, K> times_inverse_mass<M, K>(const Jacobian<M, K>&, const InverseMass<M>&,           \
                                                        const Pose<M>&, const InverseMass<M>&, const Pose<M>&); \
  kind template Eigen::Matrix<double, K, K> inverse_effective_mass<M, K>(const Jacobian<M, K>&,                 \
                                                                         const Jacobian<M, K>&);                \
  kind template void apply_impulse<M, K>(const Jacobian<M, K>&, const Rows<K>&, Velocity<M>&, Velocity<M>&)

/// What is asked of a pair's rows, one by one or as those of a pin.
#define BYHAND_COMPILE_ROWS(kind, M) \
  BYHAND_ROWS_OF(kind, M, 1);        \
  BYHAND_ROWS_OF(kind, M, M::linear)

#define BYHAND_POSES_OF(kind, M, T)                                         \
  kind template Arm<M, T> in_world<M, T>(const Pose<M, T>&, const Arm<M>&); \
  kind template Linear<M, T> anchor<M, T>(const Pose<M, T>&, const Arm<M, T>&)

#define BYHAND_COMPILE_POSES(kind, M)                                                 \
  BYHAND_POSES_OF(kind, M, double);                                                   \
  BYHAND_POSES_OF(kind, M, Dual);                                                     \
  kind template void move<M, double>(Pose<M>&, const Velocity<M>&, const double&);    \
  kind template Pose<M> moved<M, double>(Pose<M>, const Velocity<M>&, const double&); \
  kind template Arm<M> arm_to<M>(const Pose<M>&, const Linear<M>&)

#define BYHAND_COMPILED_ELSEWHERE(M) \
  BYHAND_COMPILE_ROWS(extern, M);    \
  BYHAND_COMPILE_POSES(extern, M)

BYHAND_FOR_EACH_MODEL(BYHAND_COMPILED_ELSEWHERE);

}  // namespace byhand
