#pragma once

#include "solver/system.hpp"

// What the row solvers share: (17) for a block of rows, Δλ = -E(JV + b + γλ) with E = (JM⁻¹Jᵀ + γ)⁻¹,
// multiplied out beforehand so that the inner loop is two short sums. A sweep then costs half of what it
// costs with E, J and W apart.
namespace byhand {

/// How a block's E is made: the inverse of the whole K × K matrix, or of its lower triangle, which solves its
/// rows one after the other.
enum class BlockSolve { whole, row_by_row };

template <class M, int K, Bound B>
struct PreparedBlock {
  int body1, body2;
  bool moves1, moves2;
  int row, normal_row;
  Eigen::Matrix<double, K, 2 * M::dof> J;  // -E J, by columns: the K sums of (8) run side by side
  Jacobian<M, K> W;                        // M⁻¹Jᵀ
  Rows<K> bias;                            // -E b
  double gamma[K][K];                      // -E γ
  double lower, upper;
};

/// Inverse of a symmetric positive semidefinite K × K matrix by symmetric sweeps; a pivot that vanishes
/// beside its diagonal gets a zero row, so that rows without effect (two fixed bodies, J = 0, a repeated row)
/// get no impulse rather than an infinite one.
template <int K>
Eigen::Matrix<double, K, K> inverse_or_zero(Eigen::Matrix<double, K, K> A) {
  const Eigen::Matrix<double, K, 1> diagonal = A.diagonal();
  for (int p = 0; p < K; ++p) {
    const double pivot = A(p, p);
    if (!(pivot > 1e-13 * diagonal[p])) {
      A.row(p).setZero();
      A.col(p).setZero();
      continue;
    }
    const double inverse = 1 / pivot;
    const Eigen::Matrix<double, K, 1> column = A.col(p);
    for (int i = 0; i < K; ++i)
      for (int j = 0; j < K; ++j)
        if (i != p && j != p) A(i, j) -= column[i] * inverse * column[j];
    for (int i = 0; i < K; ++i)
      if (i != p) A(i, p) = A(p, i) = -column[i] * inverse;
    A(p, p) = -inverse;
  }
  return -A;
}

}  // namespace byhand
