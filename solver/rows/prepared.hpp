#pragma once

#include "solver/rows/manifold_rows.hpp"
#include "solver/rows/residual.hpp"
#include "solver/rows/row_solver.hpp"

// Row solvers use (17) for a block of rows, Δλ = -E(JV + b + γλ) with E = (JM⁻¹Jᵀ + γ)⁻¹, multiplied out
// beforehand: the inner loop is two short sums, and a sweep costs half as much.
namespace byhand {

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

/// The rows of a system, ready for sweeps, and the scratch of sweeps, which is kept so that no step allocates.
template <class M>
struct Prepared {
  template <int K, Bound B>
  using BlockOf = PreparedBlock<M, K, B>;

  PerBlock<M, BlockOf> blocks;
  bool soft = false;      // whether any γ is not zero
  std::vector<double> D;  // by row, the diagonal of JM⁻¹Jᵀ + γ
  // Of watched sweeps, by row: what makes of a Δλ² the square of an impulse [N s], |l|² (of a row that only turns,
  // D over m₁⁻¹ + m₂⁻¹), and the square of a speed, D times m₁⁻¹ + m₂⁻¹.
  std::vector<double> impulse, speed;
  std::vector<double> change, lambda_before, direction;  // by row
  std::vector<Velocity<M>> V_before, V_direction;        // by body
};

/// Fills `prepared` from the system's rows. `relaxation` multiplies every Δλ.
template <class M>
void prepare(const System<M>& system, BlockSolve block_solve, double relaxation, Prepared<M>& prepared);
/// Fills `impulse` and `speed` after that, for sweeps that are watched.
template <class M>
void prepare_to_watch(const System<M>& system, double relaxation, Prepared<M>& prepared);

namespace detail {

/// K sums that run side by side, two at once.
template <int K>
class Sums {
 public:
  /// Begins with the numbers of a column, times `factor`.
  explicit Sums(const double* column, double factor = 1) {
    for (int i = 0; i < K / 2; ++i) pairs_[i] = pair(column + 2 * i) * factor;
    if constexpr (K % 2 == 1) last_ = column[K - 1] * factor;
  }
  void add(const double* column, double factor) {
    for (int i = 0; i < K / 2; ++i) pairs_[i] += pair(column + 2 * i) * factor;
    if constexpr (K % 2 == 1) last_ += column[K - 1] * factor;
  }
  Rows<K> operator+(const Sums& others) const {
    Rows<K> all;
    for (int i = 0; i < K / 2; ++i) {
      const Pair sum = pairs_[i] + others.pairs_[i];
      std::memcpy(&all[2 * i], &sum, sizeof sum);
    }
    if constexpr (K % 2 == 1) all[K - 1] = last_ + others.last_;
    return all;
  }

 private:
  static Pair pair(const double* numbers) {
    Pair both;
    std::memcpy(&both, numbers, sizeof both);
    return both;
  }

  Pair pairs_[K / 2 + 1];
  double last_;
};

}  // namespace detail

/// (17) for one prepared block at velocities V (dof numbers a body): the Δλ of its rows, within their bounds.
template <bool soft, class M, int K, Bound B>
inline Rows<K> solve(const PreparedBlock<M, K, B>& block, const double* V, const double* lambda) {
  constexpr int dof = M::dof;
  const double *v1 = V + dof * block.body1, *v2 = V + dof * block.body2;
  // Two chains of sums; body 1 comes late, for along a chain the block before has just written it.
  const double* J = block.J.data();
  detail::Sums<K> early(block.bias.data()), late(J, v1[0]);
  for (int i = 0; i < dof; ++i) early.add(J + K * (dof + i), v2[i]);
  for (int i = 1; i < dof; ++i) late.add(J + K * i, v1[i]);
  Rows<K> change = early + late;
  if constexpr (soft)
    for (int k = 0; k < K; ++k)
      for (int l = 0; l < K; ++l) change[k] += block.gamma[k][l] * lambda[block.row + l];
  if constexpr (B != Bound::none) {
    const Eigen::Map<const Rows<K>> now(lambda + block.row);
    const double normal_row = B == Bound::friction ? lambda[block.normal_row] : 0.0;
    change = bounded<K, B>(now + change, block.lower, block.upper, normal_row) - now;
  }
  return change;
}

}  // namespace byhand
