#pragma once

#include <array>

#include "solver/system.hpp"

// The three rows of a contact manifold in the plane, solved as one block: both normals together, then friction at
// the slip that they leave and bounded by their sum. Solved one after the other the normals would tilt the body in
// turns.
namespace byhand {

/// A = JM⁻¹Jᵀ + γ of the two normal rows and its inverse E: while a bound is active, A is needed besides.
struct NormalRows {
  double A00, A01, A11, E00, E01, E11;
  bool row_by_row;  // solve them one after the other

  NormalRows() = default;
  NormalRows(const Eigen::Matrix3d& A, bool one_by_one)
      : A00(A(0, 0)), A01(A(0, 1)), A11(A(1, 1)), row_by_row(one_by_one) {
    const Eigen::Matrix2d E = inverse_or_zero<2>(A.topLeftCorner<2, 2>());
    E00 = E(0, 0), E01 = E(0, 1), E11 = E(1, 1);
  }
};

template <class M>
struct PreparedBlock<M, 3, Bound::manifold> {
  int body1, body2;
  bool moves1, moves2;
  int row;
  Eigen::Matrix<double, 3, 2 * M::dof> J;  // by columns
  Jacobian<M, 3> W;
  Rows<3> bias, gamma;
  NormalRows normals;
  double A02, A12, E22;  // of A between the normals and friction; inverse of A's friction row alone
  double coefficient, relaxation;
};

//! [manifold]
/// λ >= 0 of both normals, given their rates at the present `lambda`: the complementarity problem of two rows,
/// solved by trying which of them press.
inline std::array<double, 2> pressing_normals(const NormalRows& rows, const Rows<3>& rate, const double* lambda) {
  if (rows.row_by_row) {
    const double first = rows.A00 > 0 ? std::max(0.0, lambda[0] - rate[0] / rows.A00) : 0.0;
    const double rate1 = rate[1] + rows.A01 * (first - lambda[0]);
    return {first, rows.A11 > 0 ? std::max(0.0, lambda[1] - rate1 / rows.A11) : 0.0};
  }
  const double first = lambda[0] - (rows.E00 * rate[0] + rows.E01 * rate[1]);
  const double second = lambda[1] - (rows.E01 * rate[0] + rows.E11 * rate[1]);
  if (first >= 0 && second >= 0) return {first, second};
  const double alone0 = rows.A00 > 0 ? lambda[0] - (rate[0] - rows.A01 * lambda[1]) / rows.A00 : 0.0;
  if (alone0 >= 0 && rate[1] + rows.A01 * (alone0 - lambda[0]) - rows.A11 * lambda[1] >= 0) return {alone0, 0};
  const double alone1 = rows.A11 > 0 ? lambda[1] - (rate[1] - rows.A01 * lambda[0]) / rows.A11 : 0.0;
  if (alone1 >= 0 && rate[0] + rows.A01 * (alone1 - lambda[1]) - rows.A00 * lambda[0] >= 0) return {0, alone1};
  return {0, 0};
}

/// (17) for a manifold: the Δλ of its rows.
template <bool soft, class M>
[[gnu::always_inline]] inline Rows<3> solve(const PreparedBlock<M, 3, Bound::manifold>& block, const double* V,
                                            const double* lambda) {
  constexpr int dof = M::dof;
  const double *v1 = V + dof * block.body1, *v2 = V + dof * block.body2, *now = lambda + block.row;
  Rows<3> rate = block.bias;
  for (int i = 0; i < dof; ++i) rate += block.J.col(i) * v1[i] + block.J.col(dof + i) * v2[i];
  if constexpr (soft)
    for (int k = 0; k < 3; ++k) rate[k] += block.gamma[k] * now[k];
  const auto [first, second] = pressing_normals(block.normals, rate, now);
  Rows<3> change(first - now[0], second - now[1], 0);
  change.template head<2>() *= block.relaxation;
  const double slip = rate[2] + block.A02 * change[0] + block.A12 * change[1];
  const double radius = block.coefficient * (now[0] + change[0] + now[1] + change[1]);
  change[2] = std::clamp(now[2] - block.relaxation * block.E22 * slip, -radius, radius) - now[2];
  return change;
}
//! [manifold]

}  // namespace byhand
