#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "solver/constraints/anchors.hpp"
#include "solver/row.hpp"

namespace byhand {

/// One constraint's rows, ready to be solved: (17) needs J, M⁻¹Jᵀ and where its numbers stand.
template <class M, int K, Bound B>
struct Block {
  int body1 = 0, body2 = 0;
  bool moves1 = false,
       moves2 = false;  // a fixed body is read, for it has a velocity of zero, but never written
  int row = 0;          // the first of its K rows in λ, bias, γ, …
  int leader = 0;       // for Bound::ball: the row whose λ scales the bound
  Jacobian<M, K> J, W;  // W = M⁻¹Jᵀ, row for row
};

/// A type of block: how many rows it has and what bounds them.
template <int K, Bound B>
struct BlockType {};
template <class... Types>
struct BlockTypes {};

/// The types of block that a model's constraints are made of: single rows, points held along every axis, what
/// leaves a body none, one or (in space) some of its degrees of freedom; limits; contacts and their friction.
template <class M>
struct BlockTypesOf;
template <>
struct BlockTypesOf<PlaneParticle> {
  using type = BlockTypes<BlockType<1, Bound::none>, BlockType<2, Bound::none>, BlockType<1, Bound::interval>,
                          BlockType<1, Bound::ball>>;
};
template <>
struct BlockTypesOf<PlaneBody> {
  using type = BlockTypes<BlockType<1, Bound::none>, BlockType<2, Bound::none>, BlockType<3, Bound::none>,
                          BlockType<1, Bound::interval>, BlockType<1, Bound::ball>, BlockType<3, Bound::face>>;
};
template <>
struct BlockTypesOf<SpaceParticle> {
  using type = BlockTypes<BlockType<1, Bound::none>, BlockType<3, Bound::none>, BlockType<1, Bound::interval>,
                          BlockType<1, Bound::ball>, BlockType<2, Bound::ball>>;
};
template <>
struct BlockTypesOf<SpaceBody> {
  using type = BlockTypes<BlockType<1, Bound::none>, BlockType<3, Bound::none>, BlockType<5, Bound::none>,
                          BlockType<6, Bound::none>, BlockType<1, Bound::interval>, BlockType<1, Bound::ball>,
                          BlockType<2, Bound::ball>>;
};

namespace detail {

template <template <int, Bound> class Element, class Types>
struct PerType;
template <template <int, Bound> class Element, int... K, Bound... B>
struct PerType<Element, BlockTypes<BlockType<K, B>...>> {
  using type = std::tuple<std::vector<Element<K, B>>...>;
};

template <class Type, class... Types>
constexpr int place_of(BlockTypes<Types...>) {
  int place = 0, found = -1;
  ((std::is_same_v<Type, Types> ? void(found = place++) : void(++place)), ...);
  return found;
}

}  // namespace detail

/// Storage for something per block, contiguous by type.
template <class M, template <int, Bound> class Element>
using PerBlock = typename detail::PerType<Element, typename BlockTypesOf<M>::type>::type;

/// The place of blocks of K rows with bound B among the vectors of PerBlock.
template <class M, int K, Bound B>
constexpr int block_type() {
  constexpr int place = detail::place_of<BlockType<K, B>>(typename BlockTypesOf<M>::type());
  static_assert(place >= 0, "this model has no blocks of so many rows with that bound: see BlockTypesOf");
  return place;
}

/// Consecutive blocks of one type and one kind of constraint, in solve order.
struct Run {
  int kind;   // the scene's kind of constraint; the system does not look at it
  int type;   // which vector of PerBlock
  int first;  // the first block in that vector
  int count;
  int row;       // the first row; a run's rows are contiguous
  int drifting;  // how many of a block's rows have a C
};

/// Calls f(std::integral_constant) with the place of a type of block among the vectors of PerBlock.
template <class M, class F>
void for_type(int type, F&& f) {
  [&]<class... Types>(BlockTypes<Types...>) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (void)((static_cast<int>(I) == type && (f(std::integral_constant<std::size_t, I>()), true)) || ...);
    }
    (std::index_sequence_for<Types...>());
  }(typename BlockTypesOf<M>::type());
}

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
  std::vector<double> lambda, C, bias, gamma, rate, lower, upper,
      restitution;          // one number a row; of a ball or face `upper` is μ
  std::vector<int> source;  // for each block in solve order, its constraint's place among those of its kind
  std::vector<int> row_of;  // for each constraint by its number, its first row
  int lasting = 0;          // how many constraints, the first, were added rather than found
  bool bounded = false;     // whether any row is

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

/// Whether row k of a block pushes only, as a contact does: λ >= 0, and C > 0 is no error.
template <class M, int K, Bound B>
bool one_sided(const System<M>& system, const Block<M, K, B>& block, int k) {
  return (B == Bound::interval && system.lower[block.row] == 0) || (B == Bound::face && k < 2);
}

//! [bound]
/// λ held within its bound: an interval, the ball of radius `upper` times the leader's λ, or of a face the two
/// normals at zero or above and friction within `upper` times their sum.
template <int K, Bound B>
Rows<K> bounded(const Rows<K>& lambda, double lower, double upper, double leader) {
  if constexpr (B == Bound::none)
    return lambda;
  else if constexpr (B == Bound::interval)
    return Rows<K>(std::clamp(lambda[0], lower, upper));
  else if constexpr (B == Bound::face) {
    const double first = std::max(0.0, lambda[0]), second = std::max(0.0, lambda[1]);
    const double radius = upper * (first + second);
    return {first, second, std::clamp(lambda[2], -radius, radius)};
  } else {
    const double radius = upper * leader, length = lambda.norm();
    return length > radius ? Rows<K>(lambda * (radius / length)) : lambda;
  }
}
//! [bound]

}  // namespace byhand
