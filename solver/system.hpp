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

namespace detail {

template <template <int, Bound> class Element, int linear>
struct PerBlock;
template <template <int, Bound> class Element>
struct PerBlock<Element, 2> {
  using type = std::tuple<std::vector<Element<1, Bound::none>>, std::vector<Element<2, Bound::none>>,
                          std::vector<Element<1, Bound::interval>>, std::vector<Element<1, Bound::ball>>>;
};
template <template <int, Bound> class Element>
struct PerBlock<Element, 3> {
  using type = std::tuple<std::vector<Element<1, Bound::none>>, std::vector<Element<3, Bound::none>>,
                          std::vector<Element<1, Bound::interval>>, std::vector<Element<1, Bound::ball>>,
                          std::vector<Element<2, Bound::ball>>>;
};

}  // namespace detail

/// Storage for something per block, contiguous by (K, bound): unbounded rows one by one or as many as there are
/// axes, single rows with an interval, and friction in one axis or, in space, two.
template <class M, template <int, Bound> class Element>
using PerBlock = typename detail::PerBlock<Element, M::linear>::type;

/// The place of blocks of K rows with bound B among the vectors of PerBlock.
template <class M, int K, Bound B>
constexpr int block_type() {
  static_assert(B != Bound::none || K == 1 || K == M::linear,
                "PerBlock has no blocks of this many unbounded rows");
  if constexpr (B == Bound::none)
    return K == 1 ? 0 : 1;
  else if constexpr (B == Bound::interval)
    return 2;
  else
    return 2 + K;
}

/// Consecutive blocks of one type and one kind of constraint, in solve order.
struct Run {
  int kind;   // the scene's kind of constraint; the system does not look at it
  int type;   // which vector of PerBlock
  int first;  // the first block in that vector
  int count;
  int row;  // the first row; a run's rows are contiguous
};

/// Calls f(std::integral_constant) with the place of a type of block among the vectors of PerBlock.
template <class M, class F>
void for_type(int type, F&& f) {
  constexpr std::size_t types = M::linear + 2;
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (void)((static_cast<int>(I) == type && (f(std::integral_constant<std::size_t, I>()), true)) || ...);
  }
  (std::make_index_sequence<types>());
}

/// A run's elements in any PerBlock storage.
template <std::size_t type, class Storage>
auto part(Storage& storage, const Run& run) {
  return std::span(std::get<type>(storage)).subspan(run.first, run.count);
}

/// The linear system of one step: (JM⁻¹Jᵀ + γ)λ = -(JV + b) within bounds, as blocks in solve order. It knows
/// the model, but no scene and no kind of constraint.
template <class M>
struct System {
  template <int K, Bound B>
  using BlockOf = Block<M, K, B>;

  PerBlock<M, BlockOf> blocks;
  std::vector<Run> runs;                                     // in solve order
  std::vector<double> lambda, C, bias, gamma, lower, upper;  // one number a row; `upper` of a ball is μ
  std::vector<int> source;  // for each block in solve order, its constraint's place among those of its kind
  std::vector<int> row_of;  // for each constraint by its number, its first row
  bool bounded = false;     // whether any row is

  int rows() const { return static_cast<int>(lambda.size()); }

  /// Calls f(std::span of blocks) for each run in solve order; each type of block has its own overload or
  /// template.
  template <class F>
  void for_each_run(F&& f) const {
    for (const Run& run : runs) for_type<M>(run.type, [&](auto type) { f(part<type>(blocks, run)); });
  }
};

//! [bound]
/// λ held within its bound: an interval, or the ball of radius `upper` times the leader's λ.
template <int K, Bound B>
Rows<K> bounded(const Rows<K>& lambda, double lower, double upper, double leader) {
  if constexpr (B == Bound::none)
    return lambda;
  else if constexpr (B == Bound::interval)
    return Rows<K>(std::clamp(lambda[0], lower, upper));
  else {
    const double radius = upper * leader, length = lambda.norm();
    return length > radius ? Rows<K>(lambda * (radius / length)) : lambda;
  }
}
//! [bound]

}  // namespace byhand
