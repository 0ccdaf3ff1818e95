#pragma once

#include "solver/body.hpp"
#include "solver/jacobian.hpp"
#include "solver/support/finite.hpp"

// The article's arithmetic for one constraint by itself, line by line. The row solvers in rows/ do the
// same sums, fused and in bulk; a test holds one against the other.
namespace byhand {

//! [18]
/// M⁻¹Jᵀ by (18), row for row, without a matrix M⁻¹. `turned` is a body's pose, or its I⁻¹ in the world.
template <class M, int K, class Turned>
Jacobian<M, K> times_inverse_mass(const Jacobian<M, K>& J, const InverseMass<M>& m1, const Turned& turned1,
                                  const InverseMass<M>& m2, const Turned& turned2) {
  Jacobian<M, K> W;
  const auto divide_side = [&](int side, const InverseMass<M>& mass, const Turned& turned) {
    for (int k = 0; k < K; ++k)
      for (int i = 0; i < M::linear; ++i) W.matrix(k, side + i) = mass.linear * J.matrix(k, side + i);
    if constexpr (M::angular > 0) {
      const auto& inverse = inverse_inertia(mass, turned);
      for (int k = 0; k < K; ++k)
        for (int i = 0; i < M::angular; ++i)
          W.matrix(k, side + M::linear + i) =
              sum_of_products<M::angular>(&J.matrix(k, side + M::linear), &inverse(0, i));
    }
  };
  divide_side(0, m1, turned1);
  divide_side(M::dof, m2, turned2);
  return W;
}
//! [18]

//! [19]
/// (19): J M⁻¹ Jᵀ, K × K. The article calls it the constraint mass; it is the *inverse* effective mass.
template <class M, int K>
Eigen::Matrix<double, K, K> inverse_effective_mass(const Jacobian<M, K>& J, const Jacobian<M, K>& W) {
  Eigen::Matrix<double, K, K> A;
  for (int k = 0; k < K; ++k)
    for (int l = 0; l < K; ++l) A(k, l) = sum_of_products<2 * M::dof>(&J.matrix(k, 0), &W.matrix(l, 0));
  return A;
}
//! [19]

/// Row k of (19) by itself: entry (k, k).
template <class M, int K>
double inverse_effective_mass(const Jacobian<M, K>& J, const Jacobian<M, K>& W, int k) {
  return sum_of_products<2 * M::dof>(J.side1(k), W.side1(k));
}

//! [17]
/// (17) for one row: the impulse that makes JV + b vanish, 0 where J is zero or neither body moves.
/// [N s] where C is in metres, [N s/m] for the C of (2).
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
  for (int i = 0; i < M::dof; ++i) {
    double gain1 = 0, gain2 = 0;
    for (int k = 0; k < K; ++k) {
      gain1 += W.matrix(k, i) * lambda[k];
      gain2 += W.matrix(k, M::dof + i) * lambda[k];
    }
    V1[i] += gain1;
    V2[i] += gain2;
  }
}
//! [20]

}  // namespace byhand
