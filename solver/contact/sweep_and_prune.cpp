#include "solver/contact/sweep_and_prune.hpp"

#include <algorithm>
#include <cmath>

namespace byhand {

template <int dim>
const std::vector<BodyPair>& SweepAndPrune<dim>::overlapping(const std::vector<Bounds>& bounds) {
  update(bounds);
  found_.clear();
  const auto add = [this](const Entry& a, const Entry& b) {
    found_.push_back({std::min(a.index, b.index), std::max(a.index, b.index)});
  };
  const auto overlap_from = [](int axis, const Entry& a, const Entry& b) {
    int all = 1;  // no branches: which bounds overlap cannot be foretold
    for (; axis < dim; ++axis) all &= int(a.low[axis] <= b.high[axis]) & int(b.low[axis] <= a.high[axis]);
    return all != 0;
  };
  for (auto a = sorted_.begin(); a != sorted_.end(); ++a)
    for (auto b = a + 1; b != sorted_.end() && b->low[0] <= a->high[0]; ++b)
      if (overlap_from(1, *a, *b)) add(*a, *b);
  for (const Entry& a : unlimited_)
    for (const Entry& b : sorted_)
      if (overlap_from(0, a, b)) add(a, b);
  sort_pairs(bounds.size());
  return pairs_;
}

/// Takes in where the bounds are now, in the order of the last call, and mends that order.
template <int dim>
void SweepAndPrune<dim>::update(const std::vector<Bounds>& bounds) {
  const auto entry = [&](int i) {
    Entry result{{}, {}, i};
    for (int k = 0; k < dim; ++k) {
      result.low[k] = bounds[i].min()[(axis_ + k) % dim];
      result.high[k] = bounds[i].max()[(axis_ + k) % dim];
    }
    return result;
  };
  const auto extent = [this](const Bounds& box) {
    if (box.isEmpty()) return Extent::none;
    return std::isfinite(box.min()[axis_]) && std::isfinite(box.max()[axis_]) ? Extent::limited
                                                                              : Extent::unlimited;
  };
  const int bodies = static_cast<int>(bounds.size());
  bool as_before = extents_.size() == bounds.size();
  extents_.resize(bounds.size());
  for (int i = 0; i < bodies; ++i) {
    const Extent now = extent(bounds[i]);
    as_before = as_before && extents_[i] == now;
    extents_[i] = now;
  }

  if (as_before) {
    for (Entry& unlimited : unlimited_) unlimited = entry(unlimited.index);
    for (auto next = sorted_.begin(); next != sorted_.end(); ++next) {
      const Entry moving = entry(next->index);
      auto to = next;
      for (; to != sorted_.begin() && (to - 1)->low[0] > moving.low[0]; --to) *to = *(to - 1);
      *to = moving;
    }
  } else {
    sorted_.clear();
    unlimited_.clear();
    for (int i = 0; i < bodies; ++i) {
      if (extents_[i] == Extent::limited) sorted_.push_back(entry(i));
      if (extents_[i] == Extent::unlimited) unlimited_.push_back(entry(i));
    }
    std::ranges::sort(sorted_, {}, [](const Entry& limited) { return limited.low[0]; });
  }
}

/// By counting, first by the one body and then, in this order, by the other.
template <int dim>
void SweepAndPrune<dim>::sort_pairs(std::size_t bodies) {
  const auto sort_by = [&](int BodyPair::*body, const std::vector<BodyPair>& from, std::vector<BodyPair>& to) {
    begin_.assign(bodies + 1, 0);
    for (const BodyPair& pair : from) ++begin_[pair.*body + 1];
    for (std::size_t i = 0; i < bodies; ++i) begin_[i + 1] += begin_[i];
    to.resize(from.size());
    for (const BodyPair& pair : from) to[begin_[pair.*body]++] = pair;
  };
  sort_by(&BodyPair::second, found_, by_second_);
  sort_by(&BodyPair::first, by_second_, pairs_);
}

template class SweepAndPrune<2>;
template class SweepAndPrune<3>;

}  // namespace byhand
