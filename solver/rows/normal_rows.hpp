#pragma once

#include <array>

#include "solver/system.hpp"

// The two normals of a contact manifold in the plane, solved together: one after the other they would tilt the
// body in turns.
namespace byhand {

/// A = JM⁻¹Jᵀ + γ of the two normal rows and its inverse E: while a bound is active, A is needed besides.
struct NormalRows {
  double A00, A01, A11, E00, E01, E11;
  bool row_by_row;  // solve them one after the other

  NormalRows() = default;
  NormalRows(double a00, double a01, double a11, bool one_by_one)
      : A00(a00), A01(a01), A11(a11), row_by_row(one_by_one) {
    const double determinant = A00 * A11 - A01 * A01;
    if (A00 > 0 && determinant > 1e-13 * A00 * A11) {
      const double share = 1 / determinant;
      E00 = A11 * share, E01 = -A01 * share, E11 = A00 * share;
    } else {  // as for a point, whose second row is zero
      const Eigen::Matrix2d E = inverse_or_zero<2>(Eigen::Matrix2d{{A00, A01}, {A01, A11}});
      E00 = E(0, 0), E01 = E(0, 1), E11 = E(1, 1);
    }
  }
  NormalRows(const Eigen::Matrix3d& A, bool one_by_one) : NormalRows(A(0, 0), A(0, 1), A(1, 1), one_by_one) {}
};

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
  if (!(alone0 > 0 || alone1 > 0)) return {0, 0};
  // One end neither presses nor parts, and rounding has refused both ways to say so.
  return {std::max(0.0, first), std::max(0.0, second)};
}

}  // namespace byhand
