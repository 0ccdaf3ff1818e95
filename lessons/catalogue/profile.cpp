#include "lessons/catalogue/profile.hpp"

#include <algorithm>
#include <cmath>

namespace byhand {

Profile::Profile(const std::vector<Task>& tasks, std::size_t method) : tasks_(static_cast<double>(tasks.size())) {
  for (const Task& task : tasks) {
    const double best = *std::min_element(task.cost.begin(), task.cost.end());
    if (std::isfinite(task.cost[method])) ratios_.push_back(task.cost[method] / best);
  }
  std::sort(ratios_.begin(), ratios_.end());
}

double Profile::operator()(double tau) const {
  const auto done = std::upper_bound(ratios_.begin(), ratios_.end(), tau) - ratios_.begin();
  return static_cast<double>(done) / tasks_;
}

}  // namespace byhand
