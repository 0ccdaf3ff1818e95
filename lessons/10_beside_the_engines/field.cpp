#include "lessons/10_beside_the_engines/field.hpp"

#include <numeric>

namespace byhand::beside {

namespace {
constexpr double rounding = 1e-9;  // [m, rad]: smaller errors are drawn there
}

std::string in_millimetres(double metres) {
  if (!std::isfinite(metres)) return "failed";
  if (metres < rounding) return "rounding";
  return say("@ mm", Value(1000 * metres, 2));
}

Chart by_name(const std::vector<std::string>& names, std::vector<Curve> curves, const std::string& label) {
  Chart chart{.y = {.label = label, .scale = Scale::logarithmic}, .curves = std::move(curves)};
  chart.x.range = {{-0.5, static_cast<double>(names.size()) - 0.5}};
  for (std::size_t i = 0; i < names.size(); ++i) chart.x.ticks.push_back({static_cast<double>(i), names[i]});
  for (Curve& curve : chart.curves) {
    curve.style = CurveStyle::markers;
    for (std::size_t i = 0; i < curve.y.size(); ++i) curve.x.push_back(static_cast<double>(i));
  }
  return chart;
}

Chart compared(const std::vector<Errors>& all, const std::string& label) {
  std::vector<std::string> names;
  Curve usual{.label = "by default"}, least{.label = "best of its settings"};
  bool several_settings = false;
  for (const Errors& errors : all) {
    names.push_back(errors.name);
    usual.y.push_back(std::max(errors.usual(), rounding));
    least.y.push_back(std::max(errors.least(), rounding));
    several_settings = several_settings || errors.by_setting.size() > 1;
  }
  std::vector<Curve> curves{usual};
  if (several_settings) curves.push_back(least);
  return by_name(names, curves, label);
}

namespace {

/// How the course's settings compare with the engine that is fastest by default and did not fail.
struct Comparison {
  std::string engine;       // empty: none
  double error = INFINITY;  // the least in no more than its time, over its error
  double time = INFINITY;   // the least for no more than its error, over its time
  bool exact = false;       // that error is rounding only
};

/// `seconds` has a time for each setting of each entrant.
Comparison beside_the_fastest(const std::vector<Errors>& all, const std::vector<double>& seconds) {
  Comparison result;
  double its_time = INFINITY, its_error = 0;
  const double* time = seconds.data() + all[0].by_setting.size();
  for (std::size_t i = 1; i < all.size(); time += all[i++].by_setting.size())
    if (std::isfinite(all[i].usual()) && *time < its_time)
      its_time = *time, its_error = all[i].usual(), result.engine = all[i].name;
  for (std::size_t i = 0; i < all[0].by_setting.size(); ++i) {
    const double error = all[0].by_setting[i];
    if (seconds[i] <= its_time) result.error = std::min(result.error, error / its_error);
    if (error <= its_error) result.time = std::min(result.time, seconds[i] / its_time);
  }
  result.exact = result.error * its_error < rounding;
  return result;
}

std::string verdict(const Comparison& found) {
  const std::string in_its_time = !std::isfinite(found.error) ? "never as fast"
                                  : found.exact               ? "in its time only rounding"
                                                : say("in its time @ of its error", Value(found.error, 1)),
                    for_its_error = std::isfinite(found.time)
                                        ? say("for its error @ of its time", Value(found.time, 2))
                                        : std::string("never as accurate");
  return say("This course beside @, the fastest: @, @", found.engine, in_its_time, for_its_error);
}

template <class M>
std::vector<double> times_of(const std::vector<Entrant<M>>& all, const Scene<M>& scene, int frames) {
  std::vector<Contestant<M>> contestants;
  for (const Entrant<M>& entrant : all)
    contestants.insert(contestants.end(), entrant.settings.begin(), entrant.settings.end());
  return engines::seconds_a_frame(contestants, scene, frames, 3);
}

}  // namespace

template <class M>
std::string reached_with(const Entrant<M>& ours, const Errors& errors, double wanted) {
  const Contestant<M>* least = nullptr;
  for (std::size_t i = 0; i < ours.settings.size(); ++i)
    if (errors.by_setting[i] <= 1.01 * wanted && (!least || ours.settings[i].effort < least->effort))
      least = &ours.settings[i];
  return least ? least->setting : "none of its settings";
}

template <class M>
Chart against_time(const std::vector<Entrant<M>>& all, const std::vector<Errors>& errors, const Scene<M>& scene,
                   int frames, const std::string& label) {
  const std::vector<double> seconds = times_of(all, scene, frames);
  Chart chart{.x = {.label = "processor time (µs a frame)", .scale = Scale::logarithmic},
              .y = {.label = label, .scale = Scale::logarithmic}};
  const double* time = seconds.data();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::vector<double>& error = errors[i].by_setting;
    std::vector<std::size_t> order(error.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return time[a] < time[b]; });
    Curve curve{.label = all[i].name, .style = CurveStyle::line_and_markers};
    double least = INFINITY;
    for (const std::size_t setting : order) {
      if (!(error[setting] < least)) continue;
      least = error[setting];
      curve.x.push_back(1e6 * time[setting]);
      curve.y.push_back(std::max(least, rounding));
    }
    if (curve.x.empty()) curve.label += " (failed)";
    chart.curves.push_back(std::move(curve));
    time += error.size();
  }
  if (const Comparison found = beside_the_fastest(errors, seconds); !found.engine.empty())
    chart.title = verdict(found);
  return chart;
}

template <class M>
Chart at_equal_error(const std::vector<Contest<M>>& contests, int frames) {
  std::vector<std::string> names;
  std::string fastest;
  Curve times{.label = "time for no more than its error"}, errors{.label = "error in no more than its time"};
  for (const Contest<M>& contest : contests) {
    const Comparison found = beside_the_fastest(contest.errors, times_of(contest.entrants, contest.scene, frames));
    names.push_back(contest.name);
    fastest += say("@@", fastest.empty() ? "" : ", ", found.engine);
    times.y.push_back(found.time);
    errors.y.push_back(std::max(found.error, rounding));
  }
  Chart chart = by_name(names, {times, errors}, "this course over that engine");
  chart.title = "The fastest engine in each: " + fastest;
  chart.references.push_back({.value = 1, .label = "as that engine"});
  return chart;
}

template <class M>
double deepest_overlap(const Scene<M>& scene) {
  Scene<M> touching = scene;
  ContactManager<M>().find(touching);
  return position_error(touching).max;
}

template <class M>
std::pair<int, int> first_and_last_sweeps(const Scene<M>& scene, int frames) {
  Simulation<M> simulation{scene, best_method()};
  simulation.step(frame);
  const int first = simulation.work.solution.passes;
  for (int i = 1; i < frames; ++i) simulation.step(frame);
  return {first, simulation.work.solution.passes};
}

std::string ahead_of_ours(const std::vector<Errors>& all) {
  std::string names;
  for (std::size_t i = 1; i < all.size(); ++i)
    if (all[i].usual() < all[0].usual()) names += (names.empty() ? "" : ", ") + all[i].name;
  return names;
}

#define BYHAND_INSTANTIATE(M)                                                                                   \
  template std::string reached_with(const Entrant<M>&, const Errors&, double);                                  \
  template Chart against_time(const std::vector<Entrant<M>>&, const std::vector<Errors>&, const Scene<M>&, int, \
                              const std::string&);                                                              \
  template Chart at_equal_error(const std::vector<Contest<M>>&, int);                                           \
  template double deepest_overlap(const Scene<M>&);                                                             \
  template std::pair<int, int> first_and_last_sweeps(const Scene<M>&, int)
BYHAND_INSTANTIATE(PlaneBody);
BYHAND_INSTANTIATE(SpaceBody);
#undef BYHAND_INSTANTIATE

}  // namespace byhand::beside
