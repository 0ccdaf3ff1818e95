#include "solver/collide/sweep_and_prune.hpp"

#include <algorithm>
#include <cmath>

namespace byhand {

template <int dim>
const std::vector<BodyPair>& SweepAndPrune<dim>::overlapping(const std::vector<Bounds>& bounds) {
  update(bounds);
  found_.clear();
  const auto try_pair = [&](const Bounds& a, int i, const Bounds& b, int j) {
    if ((a.min().array() <= b.max().array()).all() && (b.min().array() <= a.max().array()).all())
      found_.push_back({std::min(i, j), std::max(i, j)});
  };
  for (std::size_t i = 0; i < sorted_.size(); ++i) {
    const Entry& a = sorted_[i];
    for (std::size_t j = i + 1; j < sorted_.size() && sorted_[j].bounds.min()[axis_] <= a.bounds.max()[axis_]; ++j)
      try_pair(a.bounds, a.index, sorted_[j].bounds, sorted_[j].index);
  }
  for (const int i : unlimited_)
    for (const Entry& b : sorted_) try_pair(bounds[i], i, b.bounds, b.index);
  sort_pairs(static_cast<int>(bounds.size()));
  return pairs_;
}

/// Takes in where the bounds are now, in the order of the last call, and mends that order.
template <int dim>
void SweepAndPrune<dim>::update(const std::vector<Bounds>& bounds) {
  const auto lower = [this](const Entry& entry) { return entry.bounds.min()[axis_]; };
  const auto extent = [this](const Bounds& box) {
    if (box.isEmpty()) return Extent::none;
    return std::isfinite(box.min()[axis_]) && std::isfinite(box.max()[axis_]) ? Extent::limited
                                                                              : Extent::unlimited;
  };
  bool as_before = extents_.size() == bounds.size();
  extents_.resize(bounds.size());
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const Extent now = extent(bounds[i]);
    as_before = as_before && extents_[i] == now;
    extents_[i] = now;
  }

  if (as_before) {
    for (Entry& entry : sorted_) entry.bounds = bounds[entry.index];
    for (std::size_t i = 1; i < sorted_.size(); ++i) {
      const Entry moving = sorted_[i];
      std::size_t to = i;
      for (; to > 0 && lower(sorted_[to - 1]) > lower(moving); --to) sorted_[to] = sorted_[to - 1];
      sorted_[to] = moving;
    }
  } else {
    sorted_.clear();
    unlimited_.clear();
    for (int i = 0; i < static_cast<int>(bounds.size()); ++i) {
      if (extents_[i] == Extent::limited) sorted_.push_back({bounds[i], i});
      if (extents_[i] == Extent::unlimited) unlimited_.push_back(i);
    }
    std::ranges::sort(sorted_, {}, lower);
  }
}

/// By counting: `found_` in order of the first body, then each body's few partners.
template <int dim>
void SweepAndPrune<dim>::sort_pairs(int bodies) {
  begin_.assign(bodies + 1, 0);
  for (const BodyPair& pair : found_) ++begin_[pair.first + 1];
  for (int i = 0; i < bodies; ++i) begin_[i + 1] += begin_[i];
  pairs_.resize(found_.size());
  for (const BodyPair& pair : found_) pairs_[begin_[pair.first]++] = pair;
  auto from = pairs_.begin();
  for (int i = 0; i < bodies; ++i) {
    const auto to = pairs_.begin() + begin_[i];
    std::sort(from, to);
    from = to;
  }
}

template class SweepAndPrune<2>;
template class SweepAndPrune<3>;

}  // namespace byhand
