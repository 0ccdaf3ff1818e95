#pragma once

#include <array>
#include <utility>
#include <vector>

#include "solver/contact/shape.hpp"

namespace byhand {

/// Two bodies, the one with the smaller index first.
using BodyPair = std::pair<int, int>;

/// Broad phase: finds overlapping bounds. It keeps them sorted along the first axis from call to call, so that
/// where the order changes little, a call takes time in proportion to the number of bounds and of overlaps along
/// that axis. Bounds without limits along it are tested against all others.
template <int dim>
class SweepAndPrune {
 public:
  using Bounds = Eigen::AlignedBox<double, dim>;

  /// The pairs of `bounds`, by index, that overlap or touch, in ascending order, whatever was found before. Empty
  /// bounds overlap nothing, nor do two without limits each other. Valid until the next call.
  const std::vector<BodyPair>& overlapping(const std::vector<Bounds>& bounds);

 private:
  struct Entry {
    std::array<double, dim> low, high;
    int index;
  };
  enum class Extent : char { none, limited, unlimited };

  void update(const std::vector<Bounds>& bounds);
  void sort_pairs(std::size_t bodies);

  std::vector<Entry> sorted_, unlimited_;
  std::vector<Extent> extents_;  // by body; while they are the same, so are the members of the two lists above
  std::vector<BodyPair> found_, by_second_, pairs_;
  std::vector<int> begin_;
};

extern template class SweepAndPrune<2>;
extern template class SweepAndPrune<3>;

}  // namespace byhand
