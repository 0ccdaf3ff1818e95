#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "solver/row.hpp"

namespace byhand {

/// What bounds the accumulated λ of a block: nothing; an interval, for single rows; friction, a ball whose radius
/// is μ times the λ of a normal row in another block; or, for a contact manifold, both: normals at zero or above
/// and friction within μ times their sum.
enum class Bound { none, interval, friction, manifold };

/// Which constraint a block holds, and where it stands.
struct BlockHeader {
  int body1 = 0, body2 = 0;
  bool moves1 = false, moves2 = false;  // a fixed body is read, for it has a velocity of zero, but never written
  int row = 0;                          // the first of its K rows in λ, bias, γ, …
  int normal_row = 0;                   // for Bound::friction: the row whose λ scales the bound
  int constraint = 0;                   // its index among those of its kind
};

/// One constraint's rows, ready to be solved: (17) needs J and M⁻¹Jᵀ.
template <class M, int K, Bound B>
struct Block : BlockHeader {
  Jacobian<M, K> J, W;  // W = M⁻¹Jᵀ, row for row
};

/// The types of block that a model's constraints are made of, as storage for something per block: single rows,
/// points held along every axis, what leaves a body none, one or (in space) some of its degrees of freedom;
/// limits; friction and contact manifolds.
template <class M, template <int, Bound> class E>
struct BlockTypes;
template <template <int, Bound> class E>
struct BlockTypes<PlaneParticle, E> {
  using Storage = std::tuple<std::vector<E<1, Bound::none>>, std::vector<E<2, Bound::none>>,
                             std::vector<E<1, Bound::interval>>, std::vector<E<1, Bound::friction>>>;
};
template <template <int, Bound> class E>
struct BlockTypes<PlaneBody, E> {
  using Storage = std::tuple<std::vector<E<1, Bound::none>>, std::vector<E<2, Bound::none>>,
                             std::vector<E<3, Bound::none>>, std::vector<E<1, Bound::interval>>,
                             std::vector<E<1, Bound::friction>>, std::vector<E<3, Bound::manifold>>>;
};
template <template <int, Bound> class E>
struct BlockTypes<SpaceParticle, E> {
  using Storage = std::tuple<std::vector<E<1, Bound::none>>, std::vector<E<3, Bound::none>>,
                             std::vector<E<1, Bound::interval>>, std::vector<E<1, Bound::friction>>,
                             std::vector<E<2, Bound::friction>>>;
};
template <template <int, Bound> class E>
struct BlockTypes<SpaceBody, E> {
  using Storage =
      std::tuple<std::vector<E<1, Bound::none>>, std::vector<E<3, Bound::none>>, std::vector<E<5, Bound::none>>,
                 std::vector<E<6, Bound::none>>, std::vector<E<1, Bound::interval>>,
                 std::vector<E<1, Bound::friction>>, std::vector<E<2, Bound::friction>>>;
};

/// Storage for something per block, a vector for each type of block.
template <class M, template <int, Bound> class E>
using PerBlock = typename BlockTypes<M, E>::Storage;

template <int, Bound>
struct BlockTag {};

/// Calls f(std::integral_constant) with the place of a type of block among the vectors of PerBlock.
template <class M, class F>
void for_type(int type, F&& f) {
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (void)((static_cast<int>(I) == type && (f(std::integral_constant<std::size_t, I>()), true)) || ...);
  }
  (std::make_index_sequence<std::tuple_size_v<PerBlock<M, BlockTag>>>());
}

/// The place of blocks of K rows with bound B among the vectors of PerBlock.
template <class M, int K, Bound B>
constexpr int block_type() {
  constexpr int place = []<class... Tags>(std::tuple<Tags...>*) {
    int index = 0, found = -1;
    ((std::is_same_v<std::vector<BlockTag<K, B>>, Tags> ? void(found = index++) : void(++index)), ...);
    return found;
  }(static_cast<PerBlock<M, BlockTag>*>(nullptr));
  static_assert(place >= 0, "this model has no blocks of so many rows with that bound: see BlockTypes");
  return place;
}

/// Consecutive blocks of one type and one kind of constraint, in solve order.
struct Run {
  int kind;   // the scene's kind of constraint; the system does not look at it
  int type;   // which vector of PerBlock
  int first;  // the first block in that vector
  int count;
  int row;            // the first row; a run's rows are contiguous
  int position_rows;  // how many of a block's rows, the first, have a C; the others have only a rate
};

/// A run's elements of all of its type.
template <class Element>
std::span<Element> part(std::vector<Element>& all, const Run& run) {
  return {all.data() + run.first, static_cast<std::size_t>(run.count)};
}
template <class Element>
std::span<const Element> part(const std::vector<Element>& all, const Run& run) {
  return {all.data() + run.first, static_cast<std::size_t>(run.count)};
}
/// A run's elements in any PerBlock storage.
template <std::size_t type, class Storage>
auto part(Storage& storage, const Run& run) {
  return part(std::get<type>(storage), run);
}

/// The linear system of one step: (JM⁻¹Jᵀ + γ)λ = -(JV + b) within bounds, as blocks in solve order. It knows
/// the model, but no scene and no kind of constraint.
template <class M>
struct System {
  template <int K, Bound B>
  using BlockOf = Block<M, K, B>;

  PerBlock<M, BlockOf> blocks;
  std::vector<Run> runs;  // in solve order
  // One number a row; with friction `upper` is μ.
  std::vector<double> lambda, C, bias, gamma, rate, lower, upper, restitution;
  std::vector<double> stiffness;  // of methods that have one, else empty; kept from layout to layout as λ is
  // By constraint in natural order:
  std::vector<int> row_of;              // its first row
  std::vector<std::uint64_t> stamp_of;  // its stamp; in ascending order
  std::uint64_t layout = 0;             // changes with every layout
  bool bounded = false;                 // whether any row is

  int rows() const { return static_cast<int>(lambda.size()); }

  /// Calls f(std::span of blocks) for each run in solve order; each type of block has its own overload or
  /// template.
  template <class F>
  void for_each_run(F&& f) const {
    for (const Run& run : runs) for_type<M>(run.type, [&](auto type) { f(part<type>(blocks, run)); });
  }

  /// Calls f(all blocks of a type) for each type.
  template <class F>
  void for_each_type(F&& f) const {
    std::apply([&](const auto&... of_a_type) { (f(of_a_type), ...); }, blocks);
  }
};

/// How many rows of a block, the first, are normals of a contact, which push only.
template <int K, Bound B>
inline constexpr int normals = B == Bound::manifold ? K - 1 : 0;

/// Whether row k of a block pushes only, as a contact does: λ >= 0, and C > 0 is no error.
template <class M, int K, Bound B>
bool one_sided(const System<M>& system, const Block<M, K, B>& block, int k) {
  return (B == Bound::interval && system.lower[block.row] == 0) || k < normals<K, B>;
}

//! [bound]
/// λ held within its bound: an interval, the ball of radius `upper` times the λ of the normal row, or of a
/// manifold the normals at zero or above and friction within `upper` times their sum.
template <int K, Bound B>
Rows<K> bounded(const Rows<K>& lambda, double lower, double upper, double normal) {
  if constexpr (B == Bound::none)
    return lambda;
  else if constexpr (B == Bound::interval)
    return Rows<K>(std::clamp(lambda[0], lower, upper));
  else if constexpr (B == Bound::manifold) {
    const double first = std::max(0.0, lambda[0]), second = std::max(0.0, lambda[1]);
    const double radius = upper * (first + second);
    return {first, second, std::clamp(lambda[2], -radius, radius)};
  } else {
    const double radius = upper * normal, length = lambda.norm();
    return length > radius ? Rows<K>(lambda * (radius / length)) : lambda;
  }
}
//! [bound]

/// Whether λ of a block has any bound.
template <class M, int K, Bound B>
constexpr bool is_bounded(const Block<M, K, B>&) {
  return B != Bound::none;
}

// What the row solvers share: (17) for a block of rows, Δλ = -E(JV + b + γλ) with E = (JM⁻¹Jᵀ + γ)⁻¹, multiplied
// out beforehand so that the inner loop is two short sums. A sweep then costs half of what it costs with E, J and
// W apart.

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

/// A number that no other call returns: equal stamps mean that nothing has changed since.
std::uint64_t new_stamp();

}  // namespace byhand
