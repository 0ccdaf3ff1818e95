#include "solver/contact/sweep_and_prune.hpp"

#include <algorithm>
#include <cmath>

namespace byhand {

template <int dim>
const std::vector<BodyPair>& SweepAndPrune<dim>::overlapping(const std::vector<Bounds>& bounds) {
  update(bounds);
  found_.clear();
  const auto add_overlap = [this](int axis, const Entry& a, const Entry& b) {
    int all = 1;  // without branches, which could not be predicted
    for (; axis < dim; ++axis) all &= int(a.low[axis] <= b.high[axis]) & int(b.low[axis] <= a.high[axis]);
    if (all) found_.push_back(std::minmax(a.index, b.index));
  };
  for (auto a = sorted_.begin(); a != sorted_.end(); ++a)
    for (auto b = a + 1; b != sorted_.end() && b->low[0] <= a->high[0]; ++b) add_overlap(1, *a, *b);
  for (const Entry& a : unlimited_)
    for (const Entry& b : sorted_) add_overlap(0, a, b);
  sort_pairs(bounds.size());
  return pairs_;
}

/// Copies the new bounds to the entries and sorts those: by insertion, for few have changed their order.
template <int dim>
void SweepAndPrune<dim>::update(const std::vector<Bounds>& bounds) {
  const auto entry = [&](int i) {
    Entry result{{}, {}, i};
    for (int k = 0; k < dim; ++k) result.low[k] = bounds[i].min()[k], result.high[k] = bounds[i].max()[k];
    return result;
  };
  const auto extent = [](const Bounds& box) {
    if (box.isEmpty()) return Extent::none;
    return std::isfinite(box.min()[0]) && std::isfinite(box.max()[0]) ? Extent::limited : Extent::unlimited;
  };
  if (std::ranges::equal(bounds, extents_, {}, extent)) {
    for (Entry& unlimited : unlimited_) unlimited = entry(unlimited.index);
    for (auto next = sorted_.begin(); next != sorted_.end(); ++next) {
      const Entry moving = entry(next->index);
      auto to = next;
      for (; to != sorted_.begin() && (to - 1)->low[0] > moving.low[0]; --to) *to = *(to - 1);
      *to = moving;
    }
    return;
  }
  extents_.clear();
  sorted_.clear();
  unlimited_.clear();
  for (const Bounds& box : bounds) {
    const int i = static_cast<int>(extents_.size());
    extents_.push_back(extent(box));
    if (extents_[i] == Extent::limited) sorted_.push_back(entry(i));
    if (extents_[i] == Extent::unlimited) unlimited_.push_back(entry(i));
  }
  std::ranges::sort(sorted_, {}, [](const Entry& limited) { return limited.low[0]; });
}

/// Sorts by counting: by the second body, then stably by the first.
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
