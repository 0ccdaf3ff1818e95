#include "solver/contact/sweep_and_prune.hpp"

#include <algorithm>
#include <limits>

namespace byhand {

template <int dim>
const std::vector<BodyPair>& SweepAndPrune<dim>::overlapping(const std::vector<Bounds>& bounds) {
  update(bounds);
  pairs_.clear();
  for (auto a = sorted_.begin(); a != sorted_.end(); ++a)
    for (auto b = a + 1; b != sorted_.end() && b->low[0] <= a->high[0]; ++b) {
      int all = 1;  // without branches, which could not be predicted
      for (int k = 1; k < dim; ++k) all &= int(a->low[k] <= b->high[k]) & int(b->low[k] <= a->high[k]);
      if (all) pairs_.push_back(std::minmax(a->index, b->index));
    }
  // By counting: by the second body, then stably by the first.
  const auto sort_by = [&](int BodyPair::*body, const std::vector<BodyPair>& from, std::vector<BodyPair>& to) {
    begin_.assign(bounds.size() + 1, 0);
    for (const BodyPair& pair : from) ++begin_[pair.*body + 1];
    for (std::size_t i = 0; i < bounds.size(); ++i) begin_[i + 1] += begin_[i];
    to.resize(from.size());
    for (const BodyPair& pair : from) to[begin_[pair.*body]++] = pair;
  };
  sort_by(&BodyPair::second, pairs_, by_second_);
  sort_by(&BodyPair::first, by_second_, pairs_);
  return pairs_;
}

/// Copies the bounds to the entries and sorts those: by insertion, for few change their order from call to call.
template <int dim>
void SweepAndPrune<dim>::update(const std::vector<Bounds>& bounds) {
  const auto set = [&](Entry& entry, int index) {
    const Bounds& box = bounds[index];
    entry.index = index;
    for (int k = 0; k < dim; ++k) entry.low[k] = box.min()[k], entry.high[k] = box.max()[k];
    if (box.min()[0] <= box.max()[0]) return;
    entry.low.fill(std::numeric_limits<double>::infinity());
    entry.high.fill(std::numeric_limits<double>::quiet_NaN());  // which no comparison holds for
  };
  if (sorted_.size() == bounds.size()) {
    for (auto next = sorted_.begin(); next != sorted_.end(); ++next) {
      Entry moving;
      set(moving, next->index);
      auto to = next;
      for (; to != sorted_.begin() && (to - 1)->low[0] > moving.low[0]; --to) *to = *(to - 1);
      *to = moving;
    }
  } else {
    sorted_.resize(bounds.size());
    for (std::size_t i = 0; i < bounds.size(); ++i) set(sorted_[i], static_cast<int>(i));
    std::ranges::sort(sorted_, {}, [](const Entry& entry) { return entry.low[0]; });
  }
}

template class SweepAndPrune<2>;
template class SweepAndPrune<3>;

}  // namespace byhand
