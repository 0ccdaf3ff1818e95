#pragma once

#include <cstring>

#include "solver/rows/normal_rows.hpp"

// The three rows of a contact manifold in the plane, solved as one block: both normals together, then friction at
// the slip that they leave and bounded by their sum. Solved one after the other the normals would tilt the body in
// turns.
namespace byhand {

template <class M, int K, Bound B>
struct PreparedBlock;

/// What (17) and (20) read of a manifold: a Number is one double, or a Pair of two manifolds. The rows share n, t
/// and the bodies' masses, so that half the numbers of J and M⁻¹Jᵀ are enough.
template <class Number>
struct ManifoldNumbers {
  Number nx, ny;          // n; t is (ny, -nx)
  Number ends;            // 1, or 0 of a point, whose second row is zero
  Number a1[3], a2[3];    // of J (6), by row
  Number m1, I1, m2, I2;  // inverse masses and inertias
  Number bias[3], gamma[3];
  Number E00, E01, E11;  // of NormalRows
  Number A02, A12, E22;  // of A between the normals and friction; inverse of A's friction row alone
  Number coefficient, relaxation;
};

/// One manifold; or two that share no moving body, for every x86-64 processor computes with two numbers at once.
/// Each comes to the same bits as by itself.
template <>
struct PreparedBlock<PlaneBody, 3, Bound::manifold> {
  int count;  // of manifolds here; 0 after the last
  int row[2], body1[2], body2[2];
  bool moves1[2], moves2[2];
  union {
    ManifoldNumbers<double> one;
    ManifoldNumbers<detail::Pair> two;
  };
  NormalRows normals[2];
};
using PreparedManifold = PreparedBlock<PlaneBody, 3, Bound::manifold>;

/// Calls f with the numbers of one manifold or of two.
template <class F>
[[gnu::always_inline]] inline void with_numbers(const PreparedManifold& block, F&& f) {
  if (block.count == 1) f(block.one);
  if (block.count == 2) f(block.two);
}

/// How many manifolds have their numbers in one Number, and the number of one of them.
template <class Number>
inline constexpr int lanes = sizeof(Number) / sizeof(double);
inline double lane(double number, int /*which*/) { return number; }
inline double lane(detail::Pair numbers, int which) { return numbers[which]; }
inline void set_lane(double& number, int /*which*/, double value) { number = value; }
inline void set_lane(detail::Pair& numbers, int which, double value) { numbers[which] = value; }
inline bool not_negative(double number) { return number >= 0; }
inline bool not_negative(detail::Pair numbers) { return numbers[0] >= 0 && numbers[1] >= 0; }

/// λ >= 0 of the normals of one manifold or of two.
template <class Number>
[[gnu::always_inline]] inline std::array<Number, 2> pressing_normals(const ManifoldNumbers<Number>& numbers,
                                                                     const NormalRows* rows, const Number* rate,
                                                                     const Number* now) {
  const Number first = now[0] - (numbers.E00 * rate[0] + numbers.E01 * rate[1]),
               second = now[1] - (numbers.E01 * rate[0] + numbers.E11 * rate[1]);
  if (not_negative(first < second ? first : second) && !rows->row_by_row) return {first, second};
  double pressing[2][lanes<Number>];
  for (int i = 0; i < lanes<Number>; ++i) {
    const double lambda[] = {lane(now[0], i), lane(now[1], i)};
    const auto alone = pressing_normals(rows[i], {lane(rate[0], i), lane(rate[1], i), lane(rate[2], i)}, lambda);
    for (int k = 0; k < 2; ++k) pressing[k][i] = alone[k];
  }
  std::array<Number, 2> result;
  std::memcpy(&result, pressing, sizeof pressing);
  return result;
}

/// (17): the Δλ of the rows, at λ `now` and the velocities of the bodies.
template <bool soft, class Number>
[[gnu::always_inline]] inline std::array<Number, 3> solve(const ManifoldNumbers<Number>& numbers,
                                                          const NormalRows* rows, const Number* v1,
                                                          const Number* v2, const Number* now) {
  const auto& [nx, ny, ends, a1, a2, m1, I1, m2, I2, bias, gamma, E00, E01, E11, A02, A12, E22, coefficient,
               relaxation] = numbers;
  const Number vx = v2[0] - v1[0], vy = v2[1] - v1[1], along = nx * vx + ny * vy;
  Number rate[3] = {along, ends * along, ny * vx - nx * vy};
  for (int k = 0; k < 3; ++k) {
    rate[k] += bias[k] + (a1[k] * v1[2] + a2[k] * v2[2]);
    if constexpr (soft) rate[k] += gamma[k] * now[k];
  }
  const auto [first, second] = pressing_normals(numbers, rows, rate, now);
  const Number change0 = relaxation * (first - now[0]), change1 = relaxation * (second - now[1]);
  const Number slip = rate[2] + A02 * change0 + A12 * change1;
  const Number radius = coefficient * (now[0] + change0 + now[1] + change1);
  const Number friction = now[2] - relaxation * E22 * slip, below = friction < -radius ? -radius : friction;
  return {change0, change1, (radius < below ? radius : below) - now[2]};
}

/// (20).
template <class Number>
[[gnu::always_inline]] inline void apply(const ManifoldNumbers<Number>& numbers,
                                         const std::array<Number, 3>& change, Number* v1, Number* v2) {
  const Number push = change[0] + numbers.ends * change[1];
  const Number px = numbers.nx * push + numbers.ny * change[2], py = numbers.ny * push - numbers.nx * change[2];
  const auto turn = [&](const Number* a) -> Number {
    return a[0] * change[0] + a[1] * change[1] + a[2] * change[2];
  };
  v1[0] -= numbers.m1 * px;
  v1[1] -= numbers.m1 * py;
  v1[2] += numbers.I1 * turn(numbers.a1);
  v2[0] += numbers.m2 * px;
  v2[1] += numbers.m2 * py;
  v2[2] += numbers.I2 * turn(numbers.a2);
}

/// Three numbers in a row, of a body or of a manifold's λ: from one place, or from two into the pairs' halves.
[[gnu::always_inline]] inline void gather(const double* all, const int* place, double* three) {
  for (int i = 0; i < 3; ++i) three[i] = all[place[0] + i];
}
[[gnu::always_inline]] inline void gather(const double* all, const int* place, detail::Pair* three) {
  for (int i = 0; i < 3; ++i) three[i] = detail::Pair{all[place[0] + i], all[place[1] + i]};
}
template <class Number>
[[gnu::always_inline]] inline void gather_velocities(const PreparedManifold& block, const double* V, Number* v1,
                                                     Number* v2) {
  const int first[] = {3 * block.body1[0], 3 * block.body1[1]},
            second[] = {3 * block.body2[0], 3 * block.body2[1]};
  gather(V, first, v1);
  gather(V, second, v2);
}
template <class Number>
[[gnu::always_inline]] inline void scatter_velocities(const PreparedManifold& block, const Number* v1,
                                                      const Number* v2, double* V) {
  for (int i = 0; i < lanes<Number>; ++i) {
    for (int k = 0; k < 3 && block.moves1[i]; ++k) V[3 * block.body1[i] + k] = lane(v1[k], i);
    for (int k = 0; k < 3 && block.moves2[i]; ++k) V[3 * block.body2[i] + k] = lane(v2[k], i);
  }
}

}  // namespace byhand
