#include "lessons/catalogue/wish.hpp"

#include <algorithm>

namespace byhand {

double budget_of(const Wish& wish, const Family& family) { return wish.budget ? wish.budget(family) : INFINITY; }

void require_valid(const Problem& problem, const Wish& wish) {
  require(!wish.limits.empty() || wish.budget, "wish", "empty", "an accuracy or a budget");
  if (wish.budget)
    for (const Family& family : families())
      if (const double budget = wish.budget(family); std::isfinite(budget))
        require_positive("budget", budget, "instructions");
  for (const auto& [error, limit] : wish.limits) {
    require_positive("accuracy", limit, unit_of(error));
    require(has(problem.scene(), error), "error", name_of(error),
            "one that can be measured here: a " + problem.scene().title + " does not have it");
  }
}

namespace {

bool asks_for_reference(Error error) { return needs_truth(error) || error == Error::algebraic; }

}  // namespace

bool asks_for_reference(const std::map<Error, double>& limits) {
  return std::ranges::any_of(limits, [](const auto& one) { return asks_for_reference(one.first); });
}

double work_of_truth(const Problem& problem, const std::map<Error, double>& limits) {
  const auto& work = problem.scene().reference_work;
  return work && asks_for_reference(limits) ? work->load() : 0;
}

Wish without_reference(Wish wish) {
  std::erase_if(wish.limits, [](const auto& one) { return asks_for_reference(one.first); });
  return wish;
}

double excess(const Point& point, const std::map<Error, double>& limits) {
  double most = point.outcome == Outcome::good ? 0 : INFINITY;
  for (const auto& [error, limit] : limits) {
    const double unknown = error == Error::trajectory ? point.uncertainty : 0;
    most = std::max(most, point.has(error) ? (point[error] + unknown) / limit : INFINITY);
  }
  return most;
}

bool well_known(double uncertainty, const std::map<Error, double>& limits) {
  const auto limit = limits.find(Error::trajectory);
  return limit == limits.end() || uncertainty < 0.25 * limit->second;
}

Point whole_run(const Problem& problem, const Family& family, const Knobs& knobs, const Wish& wish,
                bool all_errors) {
  return measure(problem, family, knobs, {.reference = all_errors || asks_for_reference(wish.limits)});
}

double screening(const Problem& problem) {
  const double rows = std::max(1, problem.start().degrees_of_freedom()), duration = problem.scene().duration;
  return std::clamp(duration * 40 / rows, std::min(std::max(4.0, problem.scene().time), duration), duration);
}

bool preferred(const Candidate& a, const Candidate& b, const Wish& wish) {
  if (a.reached != b.reached) return a.reached;
  if (a.reached && (!wish.limits.empty() || a.excess == b.excess)) return a.point.cost < b.point.cost;
  return a.excess < b.excess;
}

}  // namespace byhand
