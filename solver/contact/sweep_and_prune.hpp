#pragma once

#include <array>
#include <vector>

#include "solver/contact/shape.hpp"

namespace byhand {

/// Two bodies that may touch: first < second.
struct BodyPair {
  int first, second;
  auto operator<=>(const BodyPair&) const = default;
};

/// Finds the bounds that overlap. It keeps them sorted along one axis from call to call, so that where little has
/// changed order it takes time in proportion to their number and to the pairs that overlap along that axis alone.
/// Bounds without limits along it stand apart and are tried with all others.
template <int dim>
class SweepAndPrune {
 public:
  using Bounds = Eigen::AlignedBox<double, dim>;

  explicit SweepAndPrune(int axis = 0) : axis_(axis) {}

  /// The pairs of `bounds`, by their index, that overlap or touch, in ascending order: the same whatever came
  /// before. Empty bounds, and two without limits, overlap nothing. Valid until the next call.
  const std::vector<BodyPair>& overlapping(const std::vector<Bounds>& bounds);

 private:
  /// The bounds of one body, axes rotated so that the one they are sorted along comes first.
  struct Entry {
    std::array<double, dim> low, high;
    int index;
  };
  enum class Extent : char { none, limited, unlimited };

  void update(const std::vector<Bounds>& bounds);
  void sort_pairs(std::size_t bodies);

  int axis_;
  std::vector<Entry> sorted_, unlimited_;
  std::vector<Extent> extents_;  // by body, to tell whether the order of the last call still serves
  std::vector<BodyPair> found_, by_second_, pairs_;
  std::vector<int> begin_;
};

extern template class SweepAndPrune<2>;
extern template class SweepAndPrune<3>;

}  // namespace byhand
