#pragma once

#include "solver/body.hpp"
#include "solver/jacobian.hpp"

// The article's arithmetic for one constraint by itself, line by line. The row solvers in methods/ do the
// same sums, fused and in bulk; a test holds one against the other.
namespace byhand {

//! [18]
/// M⁻¹Jᵀ by (18), one row for each row of J, without a matrix M⁻¹: four numbers or small blocks.
template <class M, int K>
Jacobian<M, K> times_inverse_mass(const Jacobian<M, K>& J, const InverseMass<M>& m1, const Pose<M>& pose1,
                                  const InverseMass<M>& m2, const Pose<M>& pose2) {
  Jacobian<M, K> W;
  W.matrix.template middleCols<M::linear>(0) = m1.linear * J.l1();
  W.matrix.template middleCols<M::linear>(M::dof) = m2.linear * J.l2();
  if constexpr (M::angular > 0) {
    W.matrix.template middleCols<M::angular>(M::linear) = J.a1().lazyProduct(inverse_inertia(m1, pose1));
    W.matrix.template middleCols<M::angular>(M::dof + M::linear) = J.a2().lazyProduct(inverse_inertia(m2, pose2));
  }
  return W;
}
//! [18]

//! [19]
/// (19): J M⁻¹ Jᵀ, K × K. The article calls it the constraint mass; it is the *inverse* effective mass.
template <class M, int K>
Eigen::Matrix<double, K, K> inverse_effective_mass(const Jacobian<M, K>& J, const Jacobian<M, K>& W) {
  return J.matrix.lazyProduct(W.matrix.transpose());
}
//! [19]

//! [17]
/// (17) for one row: the impulse that makes JV + b vanish, 0 where J is zero or neither body moves. For b = 0
/// and J in m per m, [N s].
template <class M>
double impulse(const Jacobian<M, 1>& J, const Jacobian<M, 1>& W, const Velocity<M>& V1, const Velocity<M>& V2,
               double bias) {
  const double inverse_mass = inverse_effective_mass(J, W)(0, 0);
  return inverse_mass > 0 ? -(dot(J, V1, V2)[0] + bias) / inverse_mass : 0.0;
}
//! [17]

//! [20]
/// (20): V += M⁻¹Jᵀλ on both bodies. λ is an impulse; divided by the time step it is the article's force.
template <class M, int K>
void apply_impulse(const Jacobian<M, K>& W, const Rows<K>& lambda, Velocity<M>& V1, Velocity<M>& V2) {
  V1 += W.side1().transpose() * lambda;
  V2 += W.side2().transpose() * lambda;
}
//! [20]

}  // namespace byhand
