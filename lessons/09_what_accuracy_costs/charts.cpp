// How a work–precision chart is drawn.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "lessons/09_what_accuracy_costs/survey.hpp"

namespace byhand::accuracy {
namespace {

using namespace renderer;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-16;  // where an error of zero is drawn

std::string axis_label(Error error) {
  switch (error) {
    case Error::drift: return "drift: largest separation or overlap (m)";
    case Error::trajectory: return "trajectory: farthest body from the reference (m)";
    case Error::energy: return "energy: largest change over its scale (1)";
    case Error::momentum: return "angular momentum: largest relative change (1)";
    case Error::reaction: return "reaction force: error over the force (1)";
    case Error::algebraic: return "algebraic: velocities from the direct solve's (m/s)";
  }
  return "";
}

std::string axis_label(Cost cost) {
  return cost == Cost::row_solves ? "cost (row-solves a frame)" : "cost (µs a frame)";
}

double on_axis(double cost, Cost which) { return which == Cost::row_solves ? cost : cost / 1000; }

/// A configuration has its colour in all charts, and with defaults that of the tuned one.
Colour colour_of(const Configuration& configuration) {
  int tuned = 0;
  for (const Configuration& other : configurations()) {
    if (other.defaults) continue;
    if (configuration.name.starts_with(other.name)) return palette::series(tuned);
    ++tuned;
  }
  return palette::ink;
}

/// Whether the error falls from knob to knob, or it has no order that is worth a number.
bool keeps_falling(const std::vector<byhand::Point>& points, Error error) {
  double last = infinity;
  int falls = 0;
  for (const byhand::Point& point : points) {
    if (!point.has(error)) continue;
    if (point[error] >= last) return false;
    falls += std::isfinite(last);
    last = point[error];
  }
  return falls >= 2;
}

std::string label_of(const Series& series, Error error) {
  const Configuration& configuration = *series.configuration;
  std::string label = configuration.name;
  if (!configuration.tuning.empty() && !configuration.defaults)
    label += fmt::format(", {} {:g}", configuration.tuning, series.tuning);
  if (series.points.empty()) return label;
  if (series.points.front().outcome == Outcome::refused) return label + ": cannot";
  const double order = fitted_order(series.points, error);
  if (std::isfinite(order) && keeps_falling(series.points, error)) label += fmt::format(", order {:.1f}", order);
  return label;
}

/// "it blew up after 0.3 s" at a cross, in the few words that fit there.
std::string reason_of(const byhand::Point& point) {
  std::string reason = point.reason.substr(0, point.reason.find(':'));
  if (reason.starts_with("it ")) reason.erase(0, 3);
  return fmt::format("{}: {}", point.knob, reason);
}

using Place = std::pair<double, double>;

Place place_of(const byhand::Point& point, Error error, Cost cost) {
  const double spent = on_axis(cost_of(point, cost), cost);
  if (!point.has(error)) return {infinity, std::isfinite(spent) ? spent : infinity};
  return {std::max(point[error], rounding), spent};
}

}  // namespace

std::string title_of(const Problem& problem) {
  std::string title;
  for (const char c : description(problem)) title += c == '_' ? "\\_" : std::string(1, c);
  return title;
}

Chart work_precision(const Survey& survey, Error error, Cost cost) {
  const std::vector<byhand::Point> all = survey.points();
  const std::vector<byhand::Point> front = pareto_front(all, error, cost);
  Chart chart{.title = title_of(survey.problem),
              .x = {.label = axis_label(error), .scale = Scale::logarithmic},
              .y = {.label = axis_label(cost), .scale = Scale::logarithmic}};

  Curve best{.label = "front: no other beats these in both", .style = CurveStyle::front};
  std::set<Place> on_front;
  for (const byhand::Point& point : front) {
    const Place place = place_of(point, error, cost);
    best.x.push_back(place.first), best.y.push_back(place.second);
    on_front.insert(place);
  }
  chart.curves.push_back(std::move(best));

  for (const Series& series : survey.series) {
    Curve curve{.label = label_of(series, error),
                .style = series.configuration->defaults ? CurveStyle::markers : CurveStyle::line_and_markers,
                .colour = colour_of(*series.configuration)};
    bool failed = false;
    for (const byhand::Point& point : series.points) {
      // Where the error has no meaning in this scene there is nothing to draw.
      if (point.outcome == Outcome::refused || (point.outcome == Outcome::finished && !point.has(error))) continue;
      const Place place = place_of(point, error, cost);
      curve.x.push_back(place.first), curve.y.push_back(place.second);
      const bool ends = &point == &series.points.front() || &point == &series.points.back();
      if (point.outcome == Outcome::failed)
        curve.point_labels.push_back(std::exchange(failed, true) ? "" : reason_of(point));
      else
        curve.point_labels.push_back(!series.configuration->defaults && (ends || on_front.contains(place))
                                         ? std::to_string(point.knob)
                                         : "");
    }
    if (!series.points.empty()) chart.curves.push_back(std::move(curve));
  }
  if (error == Error::trajectory)
    chart.references.push_back({.axis = renderer::Reference::Across::x,
                                .value = std::max(survey.problem.reference().uncertainty, rounding),
                                .label = "uncertainty of the reference"});
  return chart;
}

void show(tutor::Page& page, const std::string& name, const Survey& survey, Error error) {
  const NamedScene& scene = survey.problem.scene();
  std::string caption =
      error == Error::trajectory
          ? tutor::say("Trajectory after @ s, held against a reference: @, uncertain by @ m.", scene.time,
                       scene.reference, tutor::Value(survey.problem.reference().uncertainty, 2))
      : error == Error::reaction
          ? tutor::say(
                "Force of what holds the scene, mean over the last frame before @ s, held against the "
                "reference (@).",
                scene.time, scene.reference)
          : tutor::say("@ over @ s.", error == Error::drift ? "Drift, the largest" : "The largest change",
                       scene.duration);
  caption +=
      tutor::say(" At the points: the swept knob. Tuned for least @; defaults as dots. Crosses: runs that failed.",
                 std::string(name_of(survey.tuned_for)));
  page.figure(name, caption, work_precision(survey, error));
}

void show_clocked(tutor::Page& page, const std::string& name, const Survey& survey, Error error) {
  page.clocked(name,
               "The same against wall time, median of a frame, measured on the machine and at the moment of the "
               "run while nothing else of the lesson ran.",
               [survey = Survey(survey), error]() mutable {
                 for (Series& series : survey.series)
                   for (byhand::Point& point : series.points)
                     if (point.outcome == Outcome::finished)
                       point.nanoseconds = nanoseconds_a_frame(
                           survey.problem, series.configuration->setting(point.knob, series.tuning), 0.02);
                 return work_precision(survey, error, Cost::wall_time);
               });
}

}  // namespace byhand::accuracy
