#pragma once

#include "solver/contact/manifold_rows.hpp"

namespace byhand {

template <class M>
struct Prepared {
  template <int K, Bound B>
  using BlockOf = PreparedBlock<M, K, B>;

  PerBlock<M, BlockOf> blocks;
  std::vector<Velocity<M>> before;  // a watched sweep
  bool soft = false;                // whether any γ is not zero
};

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
    const double normal_row = B == Bound::friction ? lambda[block.normal_row] : 0.0;
    change = bounded<K, B>(now + change, block.lower, block.upper, normal_row) - now;
  }
  return change;
}

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

/// In which order the rows of a sweep are solved: as the constraints were added, the other way round, colour by
/// colour, which is red–black on a chain, or as they were added and then back, which counts as two sweeps.
enum class SweepOrder { natural, reverse, coloured, symmetric };

/// How many sweeps one in this order is.
inline int ways(SweepOrder order) { return order == SweepOrder::symmetric ? 2 : 1; }

/// Projected Gauss–Seidel, which is sequential impulses: each block of rows is solved by (17) with what the
/// blocks before it have already changed, over and over. A choice, not a state: λ is kept in the System.
struct GaussSeidel {
  int sweeps = 10;         // >= 1; of symmetric ones each is two
  bool warm_start = true;  // begin with the λ of the last step
  SweepOrder order = SweepOrder::natural;
  BlockSolve block_solve = BlockSolve::whole;
  double relaxation = 1;  // in (0, 2); other than 1 this is SOR
  double tolerance = 0;   // >= 0: no further sweep once one changes no velocity by more [m/s, rad/s]
};

/// Throws std::invalid_argument for a choice outside the ranges above.
void require_valid(const GaussSeidel& solver);

/// Solves the system's rows for λ and puts the impulses into the velocities. `prepared` is scratch that is
/// kept only so that no step allocates. Returns how many sweeps it took.
template <class M>
int solve(const GaussSeidel& solver, System<M>& system, std::vector<Velocity<M>>& velocities,
          Prepared<M>& prepared, Begin begin = Begin::step);

/// One sweep over prepared rows in the order in which they are laid out, and one back where there are two `ways`.
template <class M>
void sweep(const System<M>& system, const Prepared<M>& prepared, double* lambda, double* V, int ways = 1);

/// One sweep, and by how much it changed any velocity at most [m/s, rad/s].
template <class M>
double watched_sweep(System<M>& system, Prepared<M>& prepared, std::vector<Velocity<M>>& velocities, int ways = 1);

}  // namespace byhand
