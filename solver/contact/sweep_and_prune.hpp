#pragma once

#include <array>
#include <utility>
#include <vector>

#include "solver/contact/shape.hpp"

namespace byhand {

/// Two bodies, the one with the smaller index first.
using BodyPair = std::pair<int, int>;

/// Broad phase: finds overlapping bounds. It keeps them sorted from call to call along the axis on which they
/// spread most, looked up now and then, so that where the order changes little, a call takes time in proportion to
/// the number of bounds and of overlaps along that axis.
template <int dim>
class SweepAndPrune {
 public:
  using Bounds = Eigen::AlignedBox<double, dim>;

  /// The pairs of `bounds`, by index, that overlap or touch, in ascending order, whatever was found before. Empty
  /// bounds and bounds that are not numbers overlap nothing. Valid until the next call.
  const std::vector<BodyPair>& overlapping(const std::vector<Bounds>& bounds);

  /// The axis along which the last call sorted.
  int axis() const { return axis_; }

 private:
  struct Entry {
    std::array<double, dim> low, high;
    int index;
  };
  template <int axis>
  void sweep(const std::vector<Bounds>& bounds, bool sorted);

  int axis_ = 0, calls_ = 0;
  std::vector<Entry> sorted_;  // by low[axis_]
  std::vector<BodyPair> pairs_, by_second_;
  std::vector<int> begin_;  // scratch
};

extern template class SweepAndPrune<2>;
extern template class SweepAndPrune<3>;

}  // namespace byhand
