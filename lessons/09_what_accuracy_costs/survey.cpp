#include "lessons/09_what_accuracy_costs/survey.hpp"

#include <fmt/format.h>
#include <map>

#include "lessons/catalogue/tidy.hpp"
#include "lessons/catalogue/tuning.hpp"

namespace byhand::accuracy {
namespace {

constexpr int may_miss = starts - static_cast<int>(kept_share * starts), starts_at_once = 4;
static_assert(starts % starts_at_once == 0);

}  // namespace

std::string description(const Problem& problem) {
  std::string text;
  for (const SceneParameter& parameter : problem.scene().parameters) {
    if (parameter.name == "gravity") continue;
    text += course::say("@@ = @@", text.empty() ? ": " : ", ", parameter.name, problem[parameter.name],
                        parameter.unit == "1"   ? ""
                        : parameter.unit == "°" ? parameter.unit
                                                : " " + parameter.unit);
  }
  return problem.scene().title + text;
}

std::vector<byhand::Point> Survey::points() const {
  std::vector<byhand::Point> all;
  for (const auto& family : runs) all.insert(all.end(), family.begin(), family.end());
  return all;
}

std::vector<byhand::Point> Survey::front(const Family& family, Error error) const {
  return pareto_front(runs[static_cast<std::size_t>(&family - families().data())], error);
}

bool kept(const course::Page& page, const Survey& survey, const byhand::Point& point, Error error,
          double at_most) {
  // Without the reference where none is asked for, which may take longer than all runs.
  const bool reference = error != Error::drift && error != Error::energy && error != Error::momentum;
  using Key = std::tuple<std::string, const Family*, Knobs, bool, bool>;
  static std::map<Key, std::vector<byhand::Point>> known;
  static std::map<std::string, std::vector<Problem>> varied;
  const std::string name = description(survey.problem) + survey.problem.model();
  std::vector<Problem>& problems = varied[name];
  for (int i = static_cast<int>(problems.size()); i < starts; ++i)
    problems.push_back(survey.problem.variation(i + 1));
  const Watch watch{.reference = reference, .algebraic = error == Error::algebraic};
  auto& runs = known[{name, point.family, point.knobs, watch.reference, watch.algebraic}];
  const auto missed = [&] {
    return std::count_if(runs.begin(), runs.end(),
                         [&](const byhand::Point& run) { return !run.has(error) || run[error] > at_most; });
  };
  // Few at a time: most choices that do not keep the error miss it at once.
  while (missed() <= may_miss && std::ssize(runs) < starts) {
    const auto first = runs.size();
    const auto more = page.side_by_side(starts_at_once, [&](int i) {
      return measure(problems[first + static_cast<std::size_t>(i)], *point.family, point.knobs, watch);
    });
    runs.insert(runs.end(), more.begin(), more.end());
  }
  return missed() <= may_miss;
}

std::optional<byhand::Point> best(const course::Page& page, const Survey& survey, const Family& family,
                                  Error error, double at_most) {
  std::vector<byhand::Point> reached;
  for (const byhand::Point& point : survey.runs[static_cast<std::size_t>(&family - families().data())])
    if (point.has(error) && point[error] <= at_most) reached.push_back(point);
  std::stable_sort(reached.begin(), reached.end(), [](const auto& a, const auto& b) { return a.cost < b.cost; });
  for (const byhand::Point& point : reached)
    if (kept(page, survey, point, error, at_most)) return point;
  return {};
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

std::string without_contacts() {
  int count = 0;
  const AnyScene stack = Problem("stack").start();
  for (const Family& family : families())
    count += !stack.refusal(family.setting(with_cure({}, family.cures.front())).method).empty();
  return course::say("the @ methods without contacts (step 1a)", count);
}

std::string failures(const Survey& survey) {
  std::string text, always;                                   // who failed at times, and who never
  std::vector<std::pair<std::string, std::string>> refusals;  // why, and who
  for (const auto& runs : survey.runs) {
    if (runs.empty()) continue;
    std::map<std::string, int> ends;
    const byhand::Point* refused = nullptr;
    int good = 0, failed = 0;
    for (const byhand::Point& point : runs) {
      good += point.outcome == Outcome::good;
      if (point.outcome == Outcome::refused) refused = &point;
      failed += point.outcome != Outcome::good && point.outcome != Outcome::too_slow;
      if (point.outcome != Outcome::good)
        ++ends[point.outcome == Outcome::too_slow
                   ? "over the limit"
                   : std::string(name_of(point.outcome, survey.problem.scene().duty))];
    }
    const std::string& name = runs.front().family->name;
    if (failed == 0) {
      if (good > 0) always += (always.empty() ? "" : ", ") + name;
      continue;
    }
    if (refused && good == 0) {
      const auto same = std::find_if(refusals.begin(), refusals.end(),
                                     [&](const auto& one) { return one.first == refused->reason; });
      if (same == refusals.end())
        refusals.emplace_back(refused->reason, name);
      else
        same->second += ", " + name;
      continue;
    }
    text += fmt::format("\n- {}: of {} runs {} {}", name, runs.size(), good,
                        name_of(Outcome::good, survey.problem.scene().duty));
    for (const auto& [end, count] : ends) text += fmt::format(", {} {}", count, end);
  }
  if (!always.empty())
    text += fmt::format("\n- {}: all runs {}", always, name_of(Outcome::good, survey.problem.scene().duty));
  if (survey.problem.scene().duty != Duty::hold && !refusals.empty())
    return text + "\n- left out: " + without_contacts();
  for (const auto& [why, who] : refusals) text += fmt::format("\n- {}: {}", who, why);
  return text;
}

double least_cost(const course::Page& page, const Survey& survey, Error error, double at_most,
                  const std::vector<std::string_view>& families) {
  double least = INFINITY;
  for (const std::string_view name : families)
    if (const auto found = best(page, survey, family_named(name), error, at_most))
      least = std::min(least, found->cost);
  return least;
}

}  // namespace byhand::accuracy
