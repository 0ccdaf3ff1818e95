#include "lessons/10_beside_the_engines/field.hpp"

#include <cmath>
#include <numeric>

namespace byhand::beside {

using namespace tutor;
using namespace renderer;

std::string in_millimetres(double metres) {
  if (!std::isfinite(metres)) return "failed";
  if (metres < 1e-9) return "rounding";
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
    usual.y.push_back(std::max(errors.usual(), 1e-9));
    least.y.push_back(std::max(errors.least(), 1e-9));
    several_settings = several_settings || errors.by_setting.size() > 1;
  }
  std::vector<Curve> curves{usual};
  if (several_settings) curves.push_back(least);
  return by_name(names, curves, label);
}

namespace {

/// How the course's settings compare with the quickest engine: their least error in no more than its time, and
/// their least time for no more than its error.
std::string verdict(const std::vector<double>& errors, const std::vector<double>& seconds, const std::string& name,
                    double its_error, double its_seconds) {
  double error = INFINITY, time = INFINITY;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (seconds[i] <= its_seconds) error = std::min(error, errors[i]);
    if (errors[i] <= its_error) time = std::min(time, seconds[i]);
  }
  const std::string in_its_time = std::isfinite(error)
                                      ? say("in its time @ of its error", Value(error / its_error, 1))
                                      : std::string("never as quick"),
                    for_its_error = std::isfinite(time)
                                        ? say("for its error @ of its time", Value(time / its_seconds, 2))
                                        : std::string("never as accurate");
  return say("This course beside @, the quickest: @, @", name, in_its_time, for_its_error);
}

}  // namespace

template <class M>
Chart against_time(const std::vector<Entrant<M>>& all, const std::vector<Errors>& errors, const Scene<M>& scene,
                   int frames, const std::string& label) {
  std::vector<Contestant<M>> contestants;
  for (const Entrant<M>& entrant : all)
    contestants.insert(contestants.end(), entrant.settings.begin(), entrant.settings.end());
  const std::vector<double> seconds = engines::seconds_a_frame(contestants, scene, frames, 3);
  Chart chart{.x = {.label = "processor time (µs a frame)", .scale = Scale::logarithmic},
              .y = {.label = label, .scale = Scale::logarithmic}};
  const double* time = seconds.data();
  double quickest = INFINITY, its_error = 0;
  std::string its_name;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::vector<double>& error = errors[i].by_setting;
    if (i > 0 && std::isfinite(error[0]) && time[0] < quickest)
      quickest = time[0], its_error = error[0], its_name = all[i].name;
    std::vector<std::size_t> order(error.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return time[a] < time[b]; });
    Curve curve{.label = all[i].name, .style = CurveStyle::line_and_markers};
    double least = INFINITY;
    for (const std::size_t setting : order) {
      if (!(error[setting] < least)) continue;
      least = error[setting];
      curve.x.push_back(1e6 * time[setting]);
      curve.y.push_back(std::max(least, 1e-9));
    }
    if (curve.x.empty()) curve.label += " (failed)";
    chart.curves.push_back(std::move(curve));
    time += error.size();
  }
  if (std::isfinite(quickest)) chart.title = verdict(errors[0].by_setting, seconds, its_name, its_error, quickest);
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
  template Chart against_time(const std::vector<Entrant<M>>&, const std::vector<Errors>&, const Scene<M>&, int, \
                              const std::string&);                                                              \
  template double deepest_overlap(const Scene<M>&);                                                             \
  template std::pair<int, int> first_and_last_sweeps(const Scene<M>&, int)
BYHAND_INSTANTIATE(PlaneBody);
BYHAND_INSTANTIATE(SpaceBody);
#undef BYHAND_INSTANTIATE

}  // namespace byhand::beside
