// How a work–precision chart is drawn.

#include <fmt/format.h>

#include <string_view>

#include "lessons/09_what_accuracy_costs/survey.hpp"
#include "lessons/catalogue/tidy.hpp"

namespace byhand::accuracy {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-16;  // where an error of zero is drawn
constexpr std::size_t most_curves = 7;
constexpr double budget = 6e10;  // instructions of a chart's runs from all initial conditions

std::string axis_label(Error error) {
  switch (error) {
    case Error::drift: return "drift: largest separation or overlap (m)";
    case Error::trajectory: return "trajectory: farthest body from the reference (m)";
    case Error::energy: return "energy: largest change over its scale";
    case Error::momentum: return "angular momentum: largest relative change";
    case Error::reaction: return "reaction force: error over the force";
    case Error::contact: return "contacts: residual of complementarity and cone (m/s)";
    case Error::algebraic: return "algebraic: velocities from the direct solve's (m/s)";
  }
  return "";
}

std::string axis_label(Cost cost) {
  return cost == Cost::wall_time ? "cost (µs per frame)" : "cost (instructions per frame)";
}

double on_axis(const byhand::Point& point, Cost cost) {
  return cost == Cost::wall_time ? point.nanoseconds / 1000 : cost_of(point, cost);
}

bool needs_reference(Error error) {
  return error != Error::drift && error != Error::energy && error != Error::momentum;
}

/// A front without points that cost less than `spacing` times as much as the one before.
std::vector<byhand::Point> thinned(const std::vector<byhand::Point>& front, double spacing = 1.3) {
  std::vector<byhand::Point> kept;
  for (auto point = front.rbegin(); point != front.rend(); ++point)
    if (kept.empty() || point->cost > spacing * kept.back().cost || &*point == &front.front())
      kept.push_back(*point);
  return kept;
}

/// The families that are drawn in colour: the article's own, those with most points on the front of all, and then
/// one of each kind.
std::vector<const Family*> chosen(const Survey& survey, Error error) {
  std::vector<const Family*> drawn;
  const auto add = [&](const Family& family) {
    if (drawn.size() < most_curves && std::find(drawn.begin(), drawn.end(), &family) == drawn.end() &&
        !survey.front(family, error).empty())
      drawn.push_back(&family);
  };
  add(family_named("Gauss–Seidel"));
  const std::vector<byhand::Point> front = pareto_front(survey.points(), error);
  std::vector<std::pair<std::ptrdiff_t, const Family*>> on_front;
  for (const Family& family : families())
    if (const auto count =
            std::count_if(front.begin(), front.end(), [&](const auto& point) { return point.family == &family; });
        count > 0)
      on_front.emplace_back(count, &family);
  std::stable_sort(on_front.begin(), on_front.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  for (const auto& [count, family] : on_front) add(*family);
  for (const char* name :
       {"direct", "RATTLE", "XPBD", "conjugate sweeps", "AVBD", "RK4", "implicit midpoint", "Jacobi"})
    add(family_named(name));
  return drawn;
}

/// A front and its errors over the initial conditions.
struct Spread {
  const Family* family;
  std::vector<byhand::Point> points;
  std::vector<std::vector<double>> errors;  // by point, ascending; infinite where a run failed
};

/// What that share of all keeps.
double quantile(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size()))) - 1];
}

/// The fronts that are drawn, and from how many initial conditions.
struct Drawn {
  std::vector<Spread> spreads;
  int starts = 1;
};

/// As many points as can be run from twenty initial conditions within a budget of counted cost; from the scene's
/// own alone where each reference would take longer than all runs.
Drawn drawn_of(const Survey& survey, Error error) {
  const double duration = survey.problem.scene().duration,
               bodies = survey.problem.start().degrees_of_freedom() / 3.0;
  const bool alone = needs_reference(error) && survey.problem.scene().chaotic && bodies * duration > 60;
  const int most = alone ? 1 : starts;
  Drawn drawn;
  for (const double spacing : {1.3, 2.0, 4.0}) {
    drawn.spreads.clear();
    double work = 0;
    for (const Family* family : chosen(survey, error)) {
      drawn.spreads.push_back({family, thinned(survey.front(*family, error), spacing), {}});
      for (const byhand::Point& point : drawn.spreads.back().points) work += point.cost * duration / frame;
    }
    drawn.starts = std::clamp(static_cast<int>(budget / work), 1, most);
    if (drawn.starts == most) break;
  }
  return drawn;
}

Drawn spread_of(const course::Page& page, const Survey& survey, Error error, std::string* data) {
  Drawn drawn = drawn_of(survey, error);
  auto& [spreads, starts] = drawn;
  struct Job {
    std::size_t spread, point;
  };
  std::vector<Job> jobs;
  for (std::size_t s = 0; s < spreads.size(); ++s)
    for (std::size_t i = 0; i < spreads[s].points.size(); ++i) jobs.push_back({s, i});
  std::vector<Problem> problems;
  for (int i = 0; i < starts; ++i) problems.push_back(survey.problem.variation(starts == 1 ? 0 : i + 1));
  const Watch watch{.reference = needs_reference(error), .algebraic = error == Error::algebraic};
  const auto runs = page.side_by_side(static_cast<int>(jobs.size()), [&](int i) {
    const Job& job = jobs[static_cast<std::size_t>(i)];
    const byhand::Point& point = drawn.spreads[job.spread].points[job.point];
    std::vector<byhand::Point> all;
    for (const Problem& problem : problems) all.push_back(measure(problem, *point.family, point.knobs, watch));
    return all;
  });
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    std::vector<double> found;
    for (int start = 0; start < starts; ++start) {
      const byhand::Point& point = runs[i][static_cast<std::size_t>(start)];
      found.push_back(point.has(error) ? std::max(point[error], rounding) : infinity);
      if (starts > 1)
        *data +=
            tidy_rows(problems[static_cast<std::size_t>(start)], std::span(&point, 1), survey.watched, start + 1);
    }
    std::sort(found.begin(), found.end());
    spreads[jobs[i].spread].errors.push_back(std::move(found));
  }
  return drawn;
}

/// Where an error of rounding is drawn: at the next decade below all others, so that none are empty.
double floor_of(const Survey& survey, const std::vector<Spread>& spreads, Error error) {
  std::vector<double> all;
  for (const Family& family : families())
    for (const byhand::Point& point : survey.front(family, error))
      if (std::none_of(spreads.begin(), spreads.end(), [&](const Spread& s) { return s.family == &family; }))
        all.push_back(std::max(point[error], rounding));
  for (const Spread& spread : spreads)
    for (const std::vector<double>& errors : spread.errors)
      if (const double kept = quantile(errors, kept_share); std::isfinite(kept)) all.push_back(kept);
  std::sort(all.begin(), all.end());
  double floor = rounding;
  for (std::size_t i = 1; i < all.size(); ++i)
    if (all[i - 1] < 1e-9 && all[i] > 1e3 * all[i - 1]) floor = std::pow(10, std::floor(std::log10(0.5 * all[i])));
  return error == Error::trajectory ? std::max(floor, survey.problem.reference().uncertainty) : floor;
}

Chart work_precision(const Survey& survey, const std::vector<Spread>& spreads, Error error, Cost cost) {
  Chart chart{.title = title_of(survey.problem),
              .x = {.label = axis_label(error), .scale = Scale::logarithmic},
              .y = {.label = axis_label(cost), .scale = Scale::logarithmic}};
  const double floor = floor_of(survey, spreads, error);
  bool named = false;
  for (const Family& family : families()) {
    if (std::any_of(spreads.begin(), spreads.end(), [&](const Spread& s) { return s.family == &family; }))
      continue;
    Curve pale{.label = named ? "" : "other methods", .colour = fade(palette::ink, 0.18)};
    for (const byhand::Point& point : survey.front(family, error))
      pale.x.push_back(std::max(point[error], floor)), pale.y.push_back(on_axis(point, cost));
    if (pale.x.empty()) continue;
    named = true;
    chart.curves.push_back(std::move(pale));
  }
  for (const Spread& spread : spreads) {
    Curve kept{.label = spread.family->name,
               .style = CurveStyle::line_and_markers,
               .place = pictures::place_of(spread.family->name)};
    for (std::size_t i = 0; i < spread.points.size(); ++i) {
      const byhand::Point& point = spread.points[i];
      const double error_kept = quantile(spread.errors[i], kept_share);
      kept.x.push_back(std::max(error_kept, floor));
      kept.y.push_back(std::isfinite(error_kept) ? on_axis(point, cost) : NAN);
      const bool ends = i == 0 || i + 1 == spread.points.size();
      const std::string knobs = spread.family->pass.empty()
                                    ? std::to_string(point.knobs.substeps)
                                    : fmt::format("{}×{}", point.knobs.substeps, point.knobs.passes);
      const bool all_one = point.knobs.substeps == 1 && (spread.family->pass.empty() || point.knobs.passes == 1);
      kept.point_labels.push_back(ends && !all_one ? knobs : "");
    }
    chart.curves.push_back(std::move(kept));
  }
  const bool at_the_floor = std::any_of(chart.curves.begin(), chart.curves.end(), [=](const Curve& curve) {
    return std::find(curve.x.begin(), curve.x.end(), floor) != curve.x.end();
  });
  // Far below all errors it would only make the chart narrow; the caption names it too.
  const double uncertainty = survey.problem.reference().uncertainty;
  const auto front = pareto_front(survey.points(), error);
  if (at_the_floor && floor > uncertainty)
    chart.references.push_back({.axis = renderer::Reference::Across::x, .value = floor, .label = "or less"});
  else if (error == Error::trajectory && !front.empty() && uncertainty > front.front()[error] / 100)
    chart.references.push_back(
        {.axis = renderer::Reference::Across::x, .value = uncertainty, .label = "uncertainty of the reference"});
  return chart;
}

std::string caption_of(const Survey& survey, Error error, int starts, bool explained) {
  const NamedScene& scene = survey.problem.scene();
  const double uncertainty = survey.problem.reference().uncertainty, time = survey.problem.compared_at();
  std::string caption =
      error == Error::trajectory
          ? course::say("Trajectory after @ s. Reference: @, @.", time, scene.reference,
                        uncertainty > 1e-11 ? course::say("uncertain by @ m", course::Value(uncertainty, 2))
                        : uncertainty > 0   ? std::string("known to rounding")
                                            : std::string("which is exact"))
      : error == Error::reaction
          ? course::say(R"(Force of what holds the scene, mean over the last frame before @ s. Reference: @.)",
                        time, scene.reference)
      : error == Error::algebraic
          ? course::say("Velocities after one step at @ s, against those of the direct solve of the same step.",
                        time)
      : error == Error::contact
          ? course::say("Largest residual of complementarity and friction cone after a step at @ s.", time)
          : course::say("@ over @ s.", error == Error::drift ? "Drift, the largest" : "The largest change",
                        scene.duration);
  if (const double growth = survey.problem.reference().lyapunov_time; std::isfinite(growth))
    caption += course::say(" A small disturbance grows e-fold in @ s.", course::Value(growth, 2));
  const int kept = static_cast<int>(std::ceil(kept_share * starts));
  if (!explained)
    return caption + (starts == byhand::accuracy::starts ? std::string(" Curves as in step 2.")
                      : starts == 1                      ? std::string(" Curves as in step 2, from one start.")
                                    : course::say(" Curves as in step 2, from @ of @ starts.", kept, starts));
  return caption +
         course::say(
             R"( Each curve is the best found for a method: the error not exceeded from @ of @ initial conditions, none
             used for tuning. At its ends: substeps per frame × sweeps, iterations or digits of
             the tolerance in each; without a number, one.
             All runs are in the data.)",
             kept, starts);
}

}  // namespace

std::string title_of(const Problem& problem) {
  std::string title;
  for (const char c : description(problem)) title += c == '_' ? ' ' : c;
  return title;
}

void show(course::Page& page, const std::string& name, const Survey& survey, Error error, bool explained) {
  std::string data = tidy_head() + tidy_rows(survey.problem, survey.points(), survey.watched);
  const Drawn drawn = spread_of(page, survey, error, &data);
  page.figure(name, caption_of(survey, error, drawn.starts, explained),
              work_precision(survey, drawn.spreads, error, Cost::counted), std::move(data));
}

void show(course::Page& page, const std::string& prefix, const Survey& survey,
          std::initializer_list<Error> errors) {
  for (const Error error : errors) show(page, fmt::format("{}_{}", prefix, name_of(error)), survey, error);
}

void claim_first_order(course::Page& page, const Problem& problem, const std::string& source) {
  const auto order =
      fitted_order(refined(problem, "direct", with_cure({}, Cure::baumgarte), 64), Error::trajectory);
  page.claim(problem.scene().title + ": order of the direct solve with substeps", order ? order->slope : NAN, "1",
             is(1, source, course::absolute(0.25)));
}

}  // namespace byhand::accuracy
