#include "lessons/09_what_accuracy_costs/survey.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace byhand::accuracy {
namespace {

/// The same with those values of its knob at which a run costs at most so many row-solves. Costs rise with the
/// knob, so one run tells.
Configuration affordable(const Problem& problem, const Configuration& configuration, double most) {
  Configuration cheaper = configuration;
  const int first = configuration.values.front();
  const double tuning = configuration.tunings.empty() ? 0 : configuration.tunings.back();
  const double cost = measure(problem, configuration, first, tuning).row_solves * problem.scene().duration / frame;
  while (cheaper.values.size() > 1 && cost * cheaper.values.back() / first > most) cheaper.values.pop_back();
  return cheaper;
}

Series run(const Problem& problem, const Configuration& configuration, Error tuned_for, double most) {
  const Configuration cheaper = affordable(problem, configuration, most);
  Series series{&configuration, best_tuning(problem, cheaper, tuned_for), {}};
  for (const int knob : cheaper.values) {
    series.points.push_back(
        measure(problem, configuration, knob, series.tuning, {.algebraic = tuned_for == Error::algebraic}));
    const byhand::Point& now = series.points.back();
    // What fails before its first frame is over fails with every knob; and what fell down at first was cheap then.
    const bool at_once = now.outcome == Outcome::failed && !std::isfinite(now.row_solves);
    if (now.outcome == Outcome::refused || at_once || now.row_solves * problem.scene().duration / frame > most)
      break;
  }
  return series;
}

std::string key(const Problem& problem, Error tuned_for, double most) {
  return fmt::format("{} {} {} {}", description(problem), problem.model(), static_cast<int>(tuned_for), most);
}

}  // namespace

std::string description(const Problem& problem) {
  std::string text = problem.scene().title;
  const char* before = ": ";
  for (const SceneParameter& parameter : problem.scene().parameters) {
    if (parameter.name == "gravity") continue;
    text += fmt::format("{}{} = {:.4g}", before, parameter.name, problem[parameter.name]);
    if (parameter.unit != "1") text += " " + parameter.unit;
    before = ", ";
  }
  return text;
}

std::vector<byhand::Point> Survey::points() const {
  std::vector<byhand::Point> all;
  for (const Series& one : series) all.insert(all.end(), one.points.begin(), one.points.end());
  return all;
}

const Series* Survey::find(std::string_view configuration) const {
  for (const Series& one : series)
    if (one.configuration->name == configuration) return &one;
  return nullptr;
}

const Survey& survey(const tutor::Page& page, const Problem& problem, Error tuned_for, double most) {
  static std::map<std::string, Survey> known;
  const std::string name = key(problem, tuned_for, most);
  if (const auto found = known.find(name); found != known.end()) return found->second;
  const auto& all = configurations();
  problem.reference();  // before the threads, which would wait for it
  auto series = page.side_by_side(static_cast<int>(all.size()), [&](int i) {
    return run(problem, all[static_cast<std::size_t>(i)], tuned_for, most);
  });
  return known.emplace(name, Survey{problem, tuned_for, std::move(series)}).first->second;
}

std::string failures(const Survey& survey) {
  std::string text;
  for (const Series& series : survey.series) {
    std::string knobs, reason;
    for (const byhand::Point& point : series.points) {
      if (point.outcome == Outcome::finished) continue;
      if (point.outcome == Outcome::failed) knobs += fmt::format("{}{}", knobs.empty() ? " " : ", ", point.knob);
      if (reason.empty()) reason = point.reason;
    }
    if (reason.empty()) continue;
    text += fmt::format("\n- {}{}{}: {}", series.configuration->name, knobs.empty() ? "" : " =", knobs, reason);
  }
  return text;
}

double least_cost(const Survey& survey, Error error, double at_most,
                  const std::function<bool(const Configuration&)>& counts) {
  double least = std::numeric_limits<double>::infinity();
  for (const Series& series : survey.series) {
    if (!counts(*series.configuration)) continue;
    const byhand::Point* before = nullptr;  // the last one whose error is too large
    for (const byhand::Point& point : series.points) {
      if (!point.has(error)) continue;
      if (point[error] > at_most) {
        before = &point;
        continue;
      }
      const double share = before ? std::log((*before)[error] / at_most) /
                                        std::log((*before)[error] / std::max(point[error], at_most / 1e6))
                                  : 1;
      const double cost =
          before ? before->row_solves * std::pow(point.row_solves / before->row_solves, share) : point.row_solves;
      least = std::min(least, cost);
      break;
    }
  }
  return least;
}

}  // namespace byhand::accuracy
