#include "solver/contact/sweep_and_prune.hpp"

#include <algorithm>
#include <limits>

namespace byhand {
namespace {

/// The axis on which the centres of the bounds vary most: columns are sorted by height, rows by width. The present
/// axis stays unless another varies twice as much, because a change sorts anew.
template <int dim>
int widest_axis(const std::vector<Eigen::AlignedBox<double, dim>>& bounds, int present) {
  using Vector = Eigen::Matrix<double, dim, 1>;
  Vector first = Vector::Zero(), sum = Vector::Zero(), squares = Vector::Zero();
  int count = 0;
  for (const auto& box : bounds) {
    const Vector centre = 0.5 * (box.min() + box.max());
    if (box.isEmpty() || !centre.allFinite()) continue;  // half-spaces are infinite
    if (count++ == 0) first = centre;
    const Vector away = centre - first;
    sum += away;
    squares += away.cwiseProduct(away);
  }
  if (count == 0) return present;
  const Vector variance = squares / count - (sum / count).cwiseProduct(sum / count);
  int axis = 0;
  variance.maxCoeff(&axis);
  return variance[axis] > 2 * variance[present] ? axis : present;
}

}  // namespace

template <int dim>
const std::vector<BodyPair>& SweepAndPrune<dim>::overlapping(const std::vector<Bounds>& bounds) {
  bool sorted = sorted_.size() == bounds.size();
  constexpr int calls_with_one_axis = 64;
  if (!sorted || ++calls_ == calls_with_one_axis) {
    const int axis = widest_axis<dim>(bounds, axis_);
    sorted = sorted && axis == axis_;
    axis_ = axis;
    calls_ = 0;
  }
  sorted_.resize(bounds.size());
  if (axis_ == 0) sweep<0>(bounds, sorted);
  if (axis_ == 1) sweep<1>(bounds, sorted);
  if (axis_ == 2) sweep<dim - 1>(bounds, sorted);
  // By counting: by the second body, then stably by the first.
  const auto sort_by = [&]<int BodyPair::*body>(const std::vector<BodyPair>& from, std::vector<BodyPair>& to) {
    begin_.assign(bounds.size() + 1, 0);
    int* const begin = begin_.data();
    for (const BodyPair& pair : from) ++begin[pair.*body + 1];
    for (std::size_t i = 0; i < bounds.size(); ++i) begin[i + 1] += begin[i];
    to.resize(from.size());
    for (const BodyPair& pair : from) to[begin[pair.*body]++] = pair;
  };
  sort_by.template operator()<&BodyPair::second>(pairs_, by_second_);
  sort_by.template operator()<&BodyPair::first>(by_second_, pairs_);
  return pairs_;
}

/// Copies the bounds to the entries, sorts those along an axis, and notes the pairs that overlap. Entries that
/// were `sorted` are sorted by insertion, because few change their order from call to call.
template <int dim>
template <int axis>
void SweepAndPrune<dim>::sweep(const std::vector<Bounds>& bounds, bool sorted) {
  const auto set = [&](Entry& entry, int index) {
    const Bounds& box = bounds[index];
    entry.index = index;
    for (int k = 0; k < dim; ++k) entry.low[k] = box.min()[k], entry.high[k] = box.max()[k];
    if (box.min()[axis] <= box.max()[axis]) return;
    entry.low.fill(std::numeric_limits<double>::infinity());
    entry.high.fill(std::numeric_limits<double>::quiet_NaN());  // which no comparison holds for
  };
  if (sorted) {
    for (auto next = sorted_.begin(); next != sorted_.end(); ++next) {
      Entry moving;
      set(moving, next->index);
      auto to = next;
      for (; to != sorted_.begin() && (to - 1)->low[axis] > moving.low[axis]; --to) *to = *(to - 1);
      *to = moving;
    }
  } else {
    for (std::size_t i = 0; i < bounds.size(); ++i) set(sorted_[i], static_cast<int>(i));
    std::ranges::sort(sorted_, {}, [](const Entry& entry) { return entry.low[axis]; });
  }

  pairs_.clear();
  const Entry* const end = sorted_.data() + sorted_.size();
  for (const Entry* a = sorted_.data(); a != end; ++a) {
    const double high = a->high[axis];
    for (const Entry* b = a + 1; b != end && b->low[axis] <= high; ++b) {
      int all = 1;  // without branches, which could not be predicted
      for (int k = 0; k < dim; ++k)
        if (k != axis) all &= int(a->low[k] <= b->high[k]) & int(b->low[k] <= a->high[k]);
      if (all) pairs_.push_back(std::minmax(a->index, b->index));
    }
  }
}

template class SweepAndPrune<2>;
template class SweepAndPrune<3>;

}  // namespace byhand
