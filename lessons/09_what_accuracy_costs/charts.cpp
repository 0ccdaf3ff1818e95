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

/// Its name without its knob, where no other would then be called the same.
std::string short_name(const Configuration& configuration) {
  const auto bare = [](const Configuration& c) { return c.name.substr(0, c.name.find(',')); };
  for (const Configuration& other : configurations())
    if (bare(other) == bare(configuration) && other.knob != configuration.knob) return configuration.name;
  return bare(configuration) + (configuration.defaults ? ", defaults" : "");
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
  std::string label = short_name(configuration);
  if (!configuration.tuning.empty() && !configuration.defaults)
    label += fmt::format(" ({} {:g})", configuration.tuning, series.tuning);
  if (series.points.empty()) return label;
  if (series.points.front().outcome == Outcome::refused) return label + ": cannot";
  const double order = fitted_order(series.points, error);
  if (std::isfinite(order) && keeps_falling(series.points, error)) label += fmt::format(", order {:.1f}", order);
  return label;
}

/// "RATTLE 4"
std::string named(const byhand::Point& point) {
  const std::string& name = point.configuration->name;
  return fmt::format("{} {}", name.substr(0, name.find(',')), point.knob);
}

/// Why a run failed, in the few words that fit at a cross; the page has the whole sentence.
std::string reason_of(const byhand::Point& point) {
  if (point.reason.find("blew up") != std::string::npos) return fmt::format("{}: blows up", point.knob);
  if (std::isfinite(point.row_solves)) return fmt::format("{}: no solution", point.knob);
  return point.configuration->name.substr(0, point.configuration->name.find(',')) + ": no solution";
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
  for (const char c : description(problem)) title += c == '_' ? ' ' : c;
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
  const Configuration* last = nullptr;
  for (const byhand::Point& point : front) {
    const Place place = place_of(point, error, cost);
    best.x.push_back(place.first), best.y.push_back(place.second);
    const bool same = std::exchange(last, point.configuration) == point.configuration;
    best.point_labels.push_back(same ? std::to_string(point.knob) : named(point));
    best.point_names.push_back(point.described());
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
      curve.point_names.push_back(std::to_string(point.knob));
      const bool ends = &point == &series.points.front() || &point == &series.points.back();
      if (point.outcome == Outcome::failed && !series.configuration->defaults)
        curve.point_labels.push_back(std::exchange(failed, true) ? std::to_string(point.knob) : reason_of(point));
      else
        curve.point_labels.push_back(ends && !series.configuration->defaults && !on_front.contains(place)
                                         ? std::to_string(point.knob)
                                         : "");
    }
    if (!series.points.empty()) chart.curves.push_back(std::move(curve));
  }
  // Far below all errors it would only make the chart narrow; the caption names it too.
  const double uncertainty = survey.problem.reference().uncertainty;
  if (error == Error::trajectory && !front.empty() && uncertainty > front.front()[error] / 100)
    chart.references.push_back(
        {.axis = renderer::Reference::Across::x, .value = uncertainty, .label = "uncertainty of the reference"});
  return chart;
}

void show(tutor::Page& page, const std::string& name, const Survey& survey, Error error) {
  const NamedScene& scene = survey.problem.scene();
  const double uncertainty = survey.problem.reference().uncertainty;
  std::string caption =
      error == Error::trajectory
          ? tutor::say("Trajectory after @ s, held against a reference: @, @.", scene.time, scene.reference,
                       uncertainty > 1e-11 ? tutor::say("uncertain by @ m", tutor::Value(uncertainty, 2))
                       : uncertainty > 0   ? std::string("known to rounding")
                                           : std::string("which is exact"))
      : error == Error::reaction
          ? tutor::say(
                R"(Force of what holds the scene, mean over the last frame before @ s, held against the reference
                (@).)",
                scene.time, scene.reference)
      : error == Error::algebraic
          ? tutor::say("Velocities after one step at @ s, against those of the direct solve of the same step.",
                       scene.time)
          : tutor::say("@ over @ s.", error == Error::drift ? "Drift, the largest" : "The largest change",
                       scene.duration);
  caption += tutor::say(
      R"( At the points: the swept knob, substeps or sweeps a frame. Tuned for least @; marks without a line:
      defaults. Crosses at the edge: runs that failed.)",
      std::string(name_of(survey.tuned_for)));
  page.figure(name, caption, work_precision(survey, error));
}

void show(tutor::Page& page, const std::string& prefix, const Survey& survey,
          std::initializer_list<Error> errors) {
  for (const Error error : errors) show(page, fmt::format("{}_{}", prefix, name_of(error)), survey, error);
}

void show_clocked(tutor::Page& page, const std::string& name, const Survey& survey, Error error) {
  page.clocked(name,
               R"(The same against wall time, median of a frame, measured on the machine and at the moment of the
               run while nothing else of the lesson ran.)",
               [survey = Survey(survey), error]() mutable {
                 for (Series& series : survey.series)
                   for (byhand::Point& point : series.points)
                     if (point.outcome == Outcome::finished)
                       point.nanoseconds = nanoseconds_a_frame(
                           survey.problem, series.configuration->setting(point.knob, series.tuning), 0.02);
                 return work_precision(survey, error, Cost::wall_time);
               });
}

void claim_first_order(tutor::Page& page, const std::string& scene, const Survey& survey,
                       const std::string& source) {
  page.claim({.quantity = scene + ": order of the direct solve with substeps",
              .unit = "1",
              .expected = 1,
              .source = source,
              .measured = fitted_order(survey.find("direct, substeps")->points, Error::trajectory),
              .tolerance = tutor::absolute(0.25)});
}

}  // namespace byhand::accuracy
