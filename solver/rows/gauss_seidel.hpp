#pragma once

#include "solver/rows/manifold_rows.hpp"

// What all row solvers share, and the article's own, Gauss–Seidel. A row solver is a struct of choices. It has
// `require_valid`, which throws std::invalid_argument for a choice outside its range, and `solve`, which solves
// the system's rows for λ, applies the impulses to the velocities, and returns what it reached.
//
// The residual of a row is the Δλ of its natural map,
//
//   Δλ = Π(λ - D⁻¹(JV + b + γλ)) - λ,
//
// where Π holds λ within its bounds and D is the diagonal of JM⁻¹Jᵀ + γ. It vanishes just where the row is solved:
// within its bounds λ leaves no error, at a bound only an error that drives it off counts. As a speed it is
//
//   |Δλ| √(D (m₁⁻¹ + m₂⁻¹))   [m/s].
//
// For a rod between two particles this is the speed at which its ends still part. Any other row is scaled to the
// same JM⁻¹Jᵀ = m₁⁻¹ + m₂⁻¹, so that rows in m, m² and rad are alike, whatever the unit of length. The scale is
// the largest |λ| in the same measure: a tolerance is a share of it. Gauss–Seidel's own Δλ is the residual of each
// row at its turn, so that a sweep yields it nearly free. V is no measure: where four contacts share a face it
// returns to itself while λ still changes.
namespace byhand {

/// The largest residual of all rows, and what it is compared with [m/s].
struct Residual {
  double largest = 0;
  double push = 0;  // the largest λ, as a speed

  /// Whether it is at most this share of the largest push, or only rounding beside the `speed` of the fastest
  /// body.
  bool within(double tolerance, double speed) const {
    return largest <= tolerance * push || (tolerance > 0 && largest <= 1e-14 * speed);
  }
};

/// What one solve of the rows has reached, or all solves of a step together.
struct Solution {
  int passes = 0;         // over all rows
  int rounds = 0;         // direct solves
  double residual = 0;    // the largest [m/s]; NaN where a solver did not look: a fixed number of sweeps, or a
                          // direct solve without bounds, which is exact to rounding
  bool converged = true;  // whether it is within the solver's tolerance

  Solution& operator+=(const Solution& other) {
    passes += other.passes;
    rounds += other.rounds;
    residual = larger(residual, other.residual);
    converged = converged && other.converged;
    return *this;
  }
};

/// D of the natural map and the factor that makes a speed of Δλ, by row. Both tangents of friction in space get
/// the larger D of theirs, so that Π stays a disc's.
struct RowScales {
  std::vector<double> D, speed;
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

/// The velocities of all bodies as plain numbers, dof a body.
template <class M>
double* numbers(std::vector<Velocity<M>>& velocities) {
  static_assert(sizeof(Velocity<M>) == M::dof * sizeof(double));
  return velocities.empty() ? nullptr : velocities.front().data();
}

/// Calls f(block, its element in a PerBlock storage) for each block in solve order. The storage is resized to fit.
template <class M, class Storage, class F>
void for_each_block_with(const System<M>& system, Storage& storage, F&& f) {
  for (const Run& run : system.runs)
    for_type<M>(run.type, [&](auto type) {
      std::get<type>(storage).resize(std::get<type>(system.blocks).size());
      const auto blocks = part<type>(system.blocks, run);
      const auto elements = part<type>(storage, run);
      for (int i = 0; i < run.count; ++i) f(blocks[i], elements[i]);
    });
}

// Operations on all rows, with one number a row.

/// V += M⁻¹Jᵀλ.
template <class M>
void apply_all(const System<M>& system, const std::vector<double>& lambda, std::vector<Velocity<M>>& velocities);

/// `rates` = JV.
template <class M>
void rates_of(const System<M>& system, const std::vector<Velocity<M>>& velocities, std::vector<double>& rates);

/// `product` = (JM⁻¹Jᵀ + γ)x, by way of V = M⁻¹Jᵀx.
template <class M>
void multiply(const System<M>& system, const std::vector<double>& x, std::vector<Velocity<M>>& V,
              std::vector<double>& product);

/// `error` = JV + b + γλ.
template <class M>
void errors_of(const System<M>& system, const std::vector<Velocity<M>>& velocities,
               const std::vector<double>& lambda, std::vector<double>& error);

template <class M>
void find_scales(const System<M>& system, RowScales& scales);

/// The residual of λ whose errors JV + b + γλ are these.
template <class M>
Residual residual(const System<M>& system, const std::vector<double>& lambda, const std::vector<double>& error,
                  const RowScales& scales);

/// The speed of the fastest body, turning included: √(v² + ω²I/m) [m/s].
template <class M>
double fastest(const System<M>& system, const std::vector<Velocity<M>>& velocities);

/// Clamps λ to its bounds, block by block in solve order.
template <class M>
void hold_within_bounds(const System<M>& system, std::vector<double>& lambda);

/// The largest |x|, NaN if any is.
inline double largest_of(const std::vector<double>& x) {
  double largest = 0;
  for (const double number : x) largest = larger(largest, std::abs(number));
  return largest;
}

/// Where a solve begins: at the start of a step, with no λ or with the last step's; or with the λ that the
/// velocities contain already.
enum class Begin { step, resume };

/// Applies the initial λ of an iterative solver to the velocities.
template <class M>
void begin_sweeps(System<M>& system, bool warm_start, Begin begin, std::vector<Velocity<M>>& velocities) {
  if (begin == Begin::resume) return;
  if (warm_start)
    apply_all(system, system.lambda, velocities);
  else
    std::fill(system.lambda.begin(), system.lambda.end(), 0.0);
}

/// The order in which a sweep solves the rows: as the constraints were added, in reverse, by colour (red–black on
/// a chain), or forth and back, which counts as two sweeps.
enum class SweepOrder { natural, reverse, coloured, symmetric };

/// Passes over all rows in one sweep of this order.
inline int ways(SweepOrder order) { return order == SweepOrder::symmetric ? 2 : 1; }

/// Projected Gauss–Seidel, also called sequential impulses: each block of rows is solved by (17) at the velocities
/// that the blocks before it have left, sweep after sweep.
struct GaussSeidel {
  int sweeps = 10;         // >= 1; a symmetric one is two passes
  bool warm_start = true;  // begin with the λ of the last step
  SweepOrder order = SweepOrder::natural;
  BlockSolve block_solve = BlockSolve::whole;
  double relaxation = 1;  // in (0, 2); other than 1 this is SOR
  double tolerance = 0;   // stop when the residual is at most this share of the largest push, in [0, 1]; 0: do not
                          // look
};

void require_valid(const GaussSeidel& solver);

template <class M>
Solution solve(const GaussSeidel& solver, System<M>& system, std::vector<Velocity<M>>& velocities,
               Prepared<M>& prepared, Begin begin = Begin::step);

/// One sweep over prepared rows in their layout's order; with two `ways` also one back.
template <class M>
void sweep(const System<M>& system, const Prepared<M>& prepared, double* lambda, double* V, int ways = 1);

/// The same; returns the residual of each row at its turn.
template <class M>
Residual watched_sweep(const System<M>& system, const Prepared<M>& prepared, double* lambda, double* V,
                       int ways = 1);

/// At most so many sweeps, until the residual is within the tolerance or not a number. `passes` counts sweeps.
template <class M>
Solution sweep_until(double tolerance, int most, int ways, System<M>& system, const Prepared<M>& prepared,
                     std::vector<Velocity<M>>& velocities);

/// Throws std::invalid_argument for a tolerance outside [0, 1].
inline void require_valid_tolerance(double tolerance) { require_in("tolerance", tolerance, 0, 1); }

}  // namespace byhand
