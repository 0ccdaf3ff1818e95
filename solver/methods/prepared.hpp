#pragma once

#include <array>

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
  int row, leader;
  Eigen::Matrix<double, K, 2 * M::dof> J;  // -E J, by columns: the K sums of (8) run side by side
  Jacobian<M, K> W;                        // M⁻¹Jᵀ
  Rows<K> bias;                            // -E b
  double gamma[K][K];                      // -E γ
  double lower, upper;
};

/// A face's rows act on each other while bounds hold some of them back, so that A = JM⁻¹Jᵀ + γ is needed beside E.
template <class M>
struct PreparedBlock<M, 3, Bound::face> {
  int body1, body2;
  bool moves1, moves2;
  int row;
  Eigen::Matrix<double, 3, 2 * M::dof> J;  // by columns
  Jacobian<M, 3> W;
  Rows<3> bias, gamma;
  double A00, A01, A11, A02, A12;  // of A
  double E00, E01, E11, E22;       // of the inverse of A's normal rows, and of its friction row
  double coefficient, relaxation;
  bool row_by_row;
};

template <class M>
struct Prepared {
  template <int K, Bound B>
  using BlockOf = PreparedBlock<M, K, B>;

  PerBlock<M, BlockOf> blocks;
  std::vector<Velocity<M>> before;  // a watched sweep
  bool soft = false;                // whether any γ is not zero
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

/// Fills `prepared` from the system's rows as they are. `relaxation` multiplies every Δλ.
template <class M>
void prepare(const System<M>& system, BlockSolve block_solve, double relaxation, Prepared<M>& prepared);

/// (17) for one prepared block at velocities V (dof numbers a body): the Δλ of its rows, within their bounds.
template <bool soft, class M, int K, Bound B>
inline Rows<K> solve(const PreparedBlock<M, K, B>& block, const double* V, const double* lambda) {
  constexpr int dof = M::dof;
  const double *v1 = V + dof * block.body1, *v2 = V + dof * block.body2;
  // Two chains of sums, body 1 in the second: along a chain it is the body that the block before has just written.
  Rows<K> change = block.bias, late = block.J.col(0) * v1[0];
  for (int i = 0; i < dof; ++i) change += block.J.col(dof + i) * v2[i];
  for (int i = 1; i < dof; ++i) late += block.J.col(i) * v1[i];
  change += late;
  if constexpr (soft)
    for (int k = 0; k < K; ++k)
      for (int l = 0; l < K; ++l) change[k] += block.gamma[k][l] * lambda[block.row + l];
  if constexpr (B != Bound::none) {
    const Eigen::Map<const Rows<K>> now(lambda + block.row);
    const double leader = B == Bound::ball ? lambda[block.leader] : 0.0;
    change = bounded<K, B>(now + change, block.lower, block.upper, leader) - now;
  }
  return change;
}

//! [face]
/// λ of a face's two ends, both >= 0, that leaves no rate of approach, given its rates at the λ that is there: the
/// complementarity problem of two rows, by trying which of them press.
template <class Block>
inline std::array<double, 2> ends_that_press(const Block& face, const Rows<3>& rate, const double* lambda) {
  if (face.row_by_row) {
    const double first = face.A00 > 0 ? std::max(0.0, lambda[0] - rate[0] / face.A00) : 0.0;
    const double rate1 = rate[1] + face.A01 * (first - lambda[0]);
    return {first, face.A11 > 0 ? std::max(0.0, lambda[1] - rate1 / face.A11) : 0.0};
  }
  const double first = lambda[0] - (face.E00 * rate[0] + face.E01 * rate[1]);
  const double second = lambda[1] - (face.E01 * rate[0] + face.E11 * rate[1]);
  if (first >= 0 && second >= 0) return {first, second};
  const double alone0 = face.A00 > 0 ? lambda[0] - (rate[0] - face.A01 * lambda[1]) / face.A00 : 0.0;
  if (alone0 >= 0 && rate[1] + face.A01 * (alone0 - lambda[0]) - face.A11 * lambda[1] >= 0) return {alone0, 0};
  const double alone1 = face.A11 > 0 ? lambda[1] - (rate[1] - face.A01 * lambda[0]) / face.A11 : 0.0;
  if (alone1 >= 0 && rate[0] + face.A01 * (alone1 - lambda[1]) - face.A00 * lambda[0] >= 0) return {0, alone1};
  return {0, 0};
}

/// (17) for a face: its ends together, then friction at the rate that they leave, within what they press.
template <bool soft, class M>
inline Rows<3> solve(const PreparedBlock<M, 3, Bound::face>& face, const double* V, const double* lambda) {
  constexpr int dof = M::dof;
  const double *v1 = V + dof * face.body1, *v2 = V + dof * face.body2, *now = lambda + face.row;
  Rows<3> rate = face.bias;
  for (int i = 0; i < dof; ++i) rate += face.J.col(i) * v1[i] + face.J.col(dof + i) * v2[i];
  if constexpr (soft)
    for (int k = 0; k < 3; ++k) rate[k] += face.gamma[k] * now[k];
  const auto [first, second] = ends_that_press(face, rate, now);
  Rows<3> change(first - now[0], second - now[1], 0);
  change.template head<2>() *= face.relaxation;
  const double slip = rate[2] + face.A02 * change[0] + face.A12 * change[1];
  const double radius = face.coefficient * (now[0] + change[0] + now[1] + change[1]);
  change[2] = std::clamp(now[2] - face.relaxation * face.E22 * slip, -radius, radius) - now[2];
  return change;
}
//! [face]

/// (20) for a Block or PreparedBlock: V += M⁻¹Jᵀ `change` on the bodies that move.
template <class M, int K, class AnyBlock>
inline void apply(const AnyBlock& block, const Rows<K>& change, double* V) {
  constexpr int dof = M::dof;
  const double* W = block.W.matrix.data();
  const auto add = [&](double* v, int side) {
    double gain[dof];
    for (int i = 0; i < dof; ++i) {
      gain[i] = W[side + i] * change[0];
      for (int k = 1; k < K; ++k) gain[i] += W[2 * dof * k + side + i] * change[k];
    }
    for (int i = 0; i < dof; ++i) v[i] += gain[i];
  };
  if (block.moves1) add(V + dof * block.body1, 0);
  if (block.moves2) add(V + dof * block.body2, dof);
}

/// Velocities of all bodies as plain numbers, dof a body.
template <class M>
double* numbers(std::vector<Velocity<M>>& velocities) {
  static_assert(sizeof(Velocity<M>) == M::dof * sizeof(double));
  return velocities.empty() ? nullptr : velocities.front().data();
}

/// V += M⁻¹Jᵀλ for all rows, λ given as one number a row: the warm start, and how a direct solution reaches the
/// bodies.
template <class M>
void apply_all(const System<M>& system, const std::vector<double>& lambda, std::vector<Velocity<M>>& velocities);

/// `rates` = JV for all rows, one number a row.
template <class M>
void rates_of(const System<M>& system, const std::vector<Velocity<M>>& velocities, std::vector<double>& rates);

/// Where a solve begins: at the start of a step, with no λ or the last step's as the solver chooses; or once more
/// from the λ that the velocities hold already.
enum class Begin { step, again };

/// Puts the λ that sweeps begin with into the velocities.
template <class M>
void begin_sweeps(System<M>& system, bool warm_start, Begin begin, std::vector<Velocity<M>>& velocities) {
  if (begin == Begin::again) return;
  if (warm_start)
    apply_all(system, system.lambda, velocities);
  else
    std::fill(system.lambda.begin(), system.lambda.end(), 0.0);
}

}  // namespace byhand
