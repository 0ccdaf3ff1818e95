#include "lessons/09_what_accuracy_costs/survey.hpp"

#include <fmt/format.h>
#include <map>

#include "lessons/catalogue/tidy.hpp"
#include "lessons/catalogue/tuning.hpp"

namespace byhand::accuracy {

std::string description(const Problem& problem) {
  return problem.scene().title + ": " + described_parameters(problem);
}

std::vector<byhand::Point> Survey::points() const {
  std::vector<byhand::Point> all;
  for (const auto& family : runs) all.insert(all.end(), family.begin(), family.end());
  return all;
}

std::vector<byhand::Point> Survey::front(const Family& family, Error error) const {
  return pareto_front(runs[static_cast<std::size_t>(&family - families().data())], error);
}

std::optional<byhand::Point> Survey::best(const Family& family, Error error, double at_most) const {
  std::optional<byhand::Point> cheapest;
  for (const byhand::Point& point : front(family, error))
    if (point[error] <= at_most) cheapest = point;
  return cheapest;
}

const Survey& survey(const course::Page& page, const Problem& problem, std::vector<Error> watched, double most,
                     int runs) {
  static std::map<std::string, Survey> known;
  std::string name = fmt::format("{} {} {} {}", description(problem), problem.model(), most, runs);
  for (const Error error : watched) name += name_of(error);
  if (const auto found = known.find(name); found != known.end()) return found->second;
  problem.reference();  // before the threads, which would wait for it
  const auto& all = families();
  const bool algebraic = std::find(watched.begin(), watched.end(), Error::algebraic) != watched.end();
  auto points = page.side_by_side(static_cast<int>(all.size()), [&](int i) {
    Runs tried(problem, all[static_cast<std::size_t>(i)], {.algebraic = algebraic, .most = most});
    explore(tried, watched, runs);
    return tried.points();
  });
  return known.emplace(name, Survey{problem, std::move(watched), std::move(points)}).first->second;
}

std::vector<byhand::Point> refined(const Problem& problem, std::string_view family, Knobs knobs, int last) {
  std::vector<byhand::Point> points;
  for (; knobs.substeps <= last; knobs.substeps *= 2)
    points.push_back(measure(problem, family_named(family), knobs));
  return points;
}

std::string failures(const Survey& survey) {
  std::string text;
  for (const auto& runs : survey.runs) {
    if (runs.empty()) continue;
    std::map<std::string, int> ends;
    const byhand::Point* refused = nullptr;
    int good = 0, failed = 0;
    for (const byhand::Point& point : runs) {
      good += point.outcome == Outcome::good;
      if (point.outcome == Outcome::refused) refused = &point;
      failed += point.outcome != Outcome::good && point.outcome != Outcome::too_slow;
      if (point.outcome != Outcome::good) ++ends[std::string(name_of(point.outcome, survey.problem.scene().duty))];
    }
    if (failed == 0) continue;
    text += fmt::format("\n- {}: ", runs.front().family->name);
    if (refused && good == 0) {
      text += refused->reason;
      continue;
    }
    text +=
        fmt::format("of {} runs {} {}", runs.size(), good, name_of(Outcome::good, survey.problem.scene().duty));
    for (const auto& [end, count] : ends) text += fmt::format(", {} {}", count, end);
  }
  return text;
}

double least_cost(const Survey& survey, Error error, double at_most,
                  const std::vector<std::string_view>& families) {
  double least = INFINITY;
  for (const std::string_view name : families)
    least = std::min(least, cost_to_reach(survey.front(family_named(name), error), error, at_most));
  return least;
}

}  // namespace byhand::accuracy
