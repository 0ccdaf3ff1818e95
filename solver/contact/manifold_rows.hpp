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

/// What a sweep reads of a manifold, or of two side by side that share no moving body: every x86-64 processor
/// computes with two numbers at once, and each comes to the same bits as by itself. The rows of a manifold share
/// n, t and the bodies' masses, so that half the numbers of J and M⁻¹Jᵀ are enough.
template <>
struct PreparedBlock<PlaneBody, 3, Bound::manifold> {
  using Pair = detail::Pair;

  int count;  // of manifolds here; none after the last
  int row[2], body1[2], body2[2];
  bool moves1[2], moves2[2];
  Pair nx, ny;          // n; t is (ny, -nx)
  Pair ends;            // 1, or 0 of a point, whose second row is zero
  Pair a1[3], a2[3];    // of J (6), by row
  Pair m1, I1, m2, I2;  // inverse masses and inertias
  Pair bias[3], gamma[3];
  Pair E00, E01, E11;  // of NormalRows
  Pair A02, A12, E22;  // of A between the normals and friction; inverse of A's friction row alone
  Pair coefficient, relaxation;
  NormalRows normals[2];
};
using PreparedManifold = PreparedBlock<PlaneBody, 3, Bound::manifold>;

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

/// λ of both normals of one manifold or two, given their rates.
[[gnu::always_inline]] inline std::array<detail::Pair, 2> pressing_normals(const PreparedManifold& block,
                                                                           const detail::Pair* rate,
                                                                           const detail::Pair* now) {
  using detail::Pair;
  const Pair first = now[0] - (block.E00 * rate[0] + block.E01 * rate[1]),
             second = now[1] - (block.E01 * rate[0] + block.E11 * rate[1]);
  const Pair least = first < second ? first : second;
  if (least[0] >= 0 && least[1] >= 0 && !block.normals[0].row_by_row) return {first, second};
  Pair result[2] = {};
  for (int lane = 0; lane < block.count; ++lane) {
    const double lambda[] = {now[0][lane], now[1][lane]};
    const auto pressing =
        pressing_normals(block.normals[lane], {rate[0][lane], rate[1][lane], rate[2][lane]}, lambda);
    for (int k = 0; k < 2; ++k) result[k][lane] = pressing[k];
  }
  return {result[0], result[1]};
}

/// (17) for one manifold or two: the Δλ of the rows, at λ `now` and the velocities of the bodies.
template <bool soft>
[[gnu::always_inline]] inline std::array<detail::Pair, 3> solve(const PreparedManifold& block,
                                                                const detail::Pair* v1, const detail::Pair* v2,
                                                                const detail::Pair* now) {
  using detail::Pair;
  const Pair vx = v2[0] - v1[0], vy = v2[1] - v1[1], along = block.nx * vx + block.ny * vy;
  Pair rate[3] = {along, block.ends * along, block.ny * vx - block.nx * vy};
  for (int k = 0; k < 3; ++k) {
    rate[k] += block.bias[k] + (block.a1[k] * v1[2] + block.a2[k] * v2[2]);
    if constexpr (soft) rate[k] += block.gamma[k] * now[k];
  }
  const auto [first, second] = pressing_normals(block, rate, now);
  const Pair change0 = block.relaxation * (first - now[0]), change1 = block.relaxation * (second - now[1]);
  const Pair slip = rate[2] + block.A02 * change0 + block.A12 * change1;
  const Pair radius = block.coefficient * (now[0] + change0 + now[1] + change1);
  const Pair friction = now[2] - block.relaxation * block.E22 * slip,
             below = friction < -radius ? -radius : friction;
  return {change0, change1, (radius < below ? radius : below) - now[2]};
}

/// (20) for one manifold or two.
[[gnu::always_inline]] inline void apply(const PreparedManifold& block, const std::array<detail::Pair, 3>& change,
                                         detail::Pair* v1, detail::Pair* v2) {
  using detail::Pair;
  const Pair push = change[0] + block.ends * change[1];
  const Pair px = block.nx * push + block.ny * change[2], py = block.ny * push - block.nx * change[2];
  const auto turn = [&](const Pair* a) { return a[0] * change[0] + a[1] * change[1] + a[2] * change[2]; };
  v1[0] -= block.m1 * px;
  v1[1] -= block.m1 * py;
  v1[2] += block.I1 * turn(block.a1);
  v2[0] += block.m2 * px;
  v2[1] += block.m2 * py;
  v2[2] += block.I2 * turn(block.a2);
}
//! [manifold]

/// The numbers of a manifold's bodies or rows, one by one for each of the two.
[[gnu::always_inline]] inline void gather(const double* all, int first, int second, detail::Pair* three) {
  for (int i = 0; i < 3; ++i) three[i] = detail::Pair{all[first + i], all[second + i]};
}
[[gnu::always_inline]] inline void gather_velocities(const PreparedManifold& block, const double* V,
                                                     detail::Pair* v1, detail::Pair* v2) {
  gather(V, 3 * block.body1[0], 3 * block.body1[1], v1);
  gather(V, 3 * block.body2[0], 3 * block.body2[1], v2);
}
[[gnu::always_inline]] inline void scatter_velocities(const PreparedManifold& block, const detail::Pair* v1,
                                                      const detail::Pair* v2, double* V) {
  for (int lane = 0; lane < 2; ++lane) {
    for (int i = 0; i < 3 && block.moves1[lane]; ++i) V[3 * block.body1[lane] + i] = v1[i][lane];
    for (int i = 0; i < 3 && block.moves2[lane]; ++i) V[3 * block.body2[lane] + i] = v2[i][lane];
  }
}

}  // namespace byhand
