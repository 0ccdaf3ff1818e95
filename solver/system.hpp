#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "solver/row.hpp"
#include "solver/support/stamp.hpp"

namespace byhand {

/// Bounds on the accumulated λ of a block. interval: of a single row. friction: a ball with radius μ times the λ
/// of a normal row in another block. manifold: normals >= 0 and friction within μ times their sum, in one block.
enum class Bound { none, interval, friction, manifold };

/// A block's bodies, constraint and place among the rows.
struct BlockHeader {
  int body1 = 0, body2 = 0;
  bool moves1 = false, moves2 = false;  // the velocity of a fixed body is read but never written
  int row = 0;                          // the first of its K rows in λ, bias, γ, …
  int normal_row = 0;                   // for Bound::friction: the row whose λ scales the bound
  int constraint = 0;                   // index among the constraints of its kind
};

/// The K rows of one constraint: what (17) needs.
template <class M, int K, Bound B>
struct Block : BlockHeader {
  Jacobian<M, K> J, W;  // W = M⁻¹Jᵀ, row for row
};

/// The types of block of a model, as storage for one E per block. Bound::none: up to as many rows as a body has
/// degrees of freedom. Bound::interval: contacts and limits. Then friction and manifolds.
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
  using Storage = std::tuple<std::vector<E<1, Bound::none>>, std::vector<E<2, Bound::none>>,
                             std::vector<E<3, Bound::none>>, std::vector<E<1, Bound::interval>>,
                             std::vector<E<1, Bound::friction>>, std::vector<E<2, Bound::friction>>>;
};
template <template <int, Bound> class E>
struct BlockTypes<SpaceBody, E> {
  using Storage =
      std::tuple<std::vector<E<1, Bound::none>>, std::vector<E<2, Bound::none>>, std::vector<E<3, Bound::none>>,
                 std::vector<E<4, Bound::none>>, std::vector<E<5, Bound::none>>, std::vector<E<6, Bound::none>>,
                 std::vector<E<1, Bound::interval>>, std::vector<E<1, Bound::friction>>,
                 std::vector<E<2, Bound::friction>>>;
};

/// Storage for something per block, a vector for each type of block.
template <class M, template <int, Bound> class E>
using PerBlock = typename BlockTypes<M, E>::Storage;

template <int, Bound>
struct BlockTag {};

/// The rows of a model's largest blocks.
template <class M>
inline constexpr int most_rows = []<int... K, Bound... B>(std::tuple<std::vector<BlockTag<K, B>>...>*) {
  return std::max({K...});
}
(static_cast<PerBlock<M, BlockTag>*>(nullptr));

/// Calls f(std::integral_constant) with the index of a block type among the vectors of PerBlock.
template <class M, int first = 0, int last = std::tuple_size_v<PerBlock<M, BlockTag>>, class F>
[[gnu::always_inline]] inline void for_type(int type, F&& f) {
  constexpr int middle = first + (last - first + 1) / 3;
  if constexpr (middle == first)
    f(std::integral_constant<std::size_t, first>());
  else
    type < middle ? for_type<M, first, middle>(type, f) : for_type<M, middle, last>(type, f);
}

/// The index of blocks of K rows with bound B among the vectors of PerBlock.
template <class M, int K, Bound B>
constexpr int block_type() {
  constexpr int place = []<class... Tags>(std::tuple<Tags...>*) {
    int index = 0, found = -1;
    ((std::is_same_v<std::vector<BlockTag<K, B>>, Tags> ? void(found = index++) : void(++index)), ...);
    return found;
  }(static_cast<PerBlock<M, BlockTag>*>(nullptr));
  static_assert(place >= 0,
                "a kind has from 1 to M::dof rows without a bound, or a single row with Bound::interval");
  return place;
}

/// Consecutive blocks of one type and one kind of constraint, in solve order.
struct Run {
  bool found;        // of contacts that were found, not of the scene's own constraints; unused by the system, like
  int kind;          // the index of the store among theirs
  int type;          // index of the vector in PerBlock
  int first, count;  // the blocks in that vector
  int row;           // first row; a run's rows are contiguous
  int position_rows;  // the first rows of each block have a C; the others only a rate
};

/// The elements of a run in a vector for its type.
template <class Vector>
auto part(Vector& all, const Run& run) {
  return std::span(all.data() + run.first, static_cast<std::size_t>(run.count));
}
/// The elements of a run in PerBlock storage.
template <std::size_t type, class Storage>
auto part(Storage& storage, const Run& run) {
  return part(std::get<type>(storage), run);
}

/// The linear system of one step: (JM⁻¹Jᵀ + γ)λ = -(JV + b) within bounds, as blocks in solve order. Independent
/// of scenes and kinds of constraint.
template <class M>
struct System {
  using model = M;
  template <int K, Bound B>
  using BlockOf = Block<M, K, B>;

  PerBlock<M, BlockOf> blocks;
  std::vector<Run> runs;                           // in solve order
  std::vector<InverseMass<M>> inverse_mass;        // by body
  std::vector<InverseInertia<M>> inverse_inertia;  // by body, in the world, at the poses of the rows
  // One number a row; with friction `upper` is μ.
  std::vector<double> lambda, C, bias, gamma, target_rate, lower, upper, restitution;
  std::vector<double> stiffness;  // k of AVBD, else empty; a new layout keeps it, and λ, of constraints that stay
  std::vector<int> row_of;        // first row of each constraint: the scene's in natural order, then contacts
  std::vector<std::uint64_t> stamp_of;  // stamp of each constraint of the scene, in natural order, ascending
  std::uint64_t layout = 0;             // stamp of the layout
  bool bounded = false;                 // whether any row has a bound

  int rows() const { return static_cast<int>(lambda.size()); }

  /// Calls f(std::span of blocks) for each run in solve order; f is a template over the type of block.
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

/// Calls f(block, run) for each block of a System in solve order; f is a template over the type of block, or takes
/// a BlockHeader.
template <class AnySystem, class F>
void for_each_block(AnySystem& system, F&& f) {
  for (const Run& run : system.runs)
    for_type<typename AnySystem::model>(run.type, [&](auto type) {
      for (auto& block : part<type>(system.blocks, run)) f(block, run);
    });
}

/// Number of rows of a block that are contact normals: its first ones.
template <int K, Bound B>
inline constexpr int normals = B == Bound::manifold ? K - 1 : 0;

/// Whether row k of a block only pushes, like a contact: λ >= 0, and C > 0 is no error.
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
    const double first = larger(0, lambda[0]), second = larger(0, lambda[1]);
    const double radius = upper * (first + second);
    return {first, second, std::clamp(lambda[2], -radius, radius)};
  } else {
    const double radius = upper * normal, length = lambda.norm();
    return length > radius ? Rows<K>(lambda * (radius / length)) : lambda;
  }
}
//! [bound]

/// Inverse of a symmetric positive semidefinite K × K matrix by symmetric sweeps. A pivot that vanishes relative
/// to its diagonal gets a zero row: rows without effect (two fixed bodies, J = 0, a repeated row) get no impulse.
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
