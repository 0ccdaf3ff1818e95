#include "lessons/09_what_accuracy_costs/catalogue/work_precision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace byhand {
namespace {

struct ErrorName {
  std::string_view name, unit;
};
constexpr std::array<ErrorName, error_count> error_names{{{"drift", "m"},
                                                          {"trajectory", "m"},
                                                          {"energy", "1"},
                                                          {"momentum", "1"},
                                                          {"reaction", "1"},
                                                          {"algebraic", "m/s"}}};

constexpr double blown_up = 100;  // times the energy scale

void advance_frame(AnyScene& scene, const Setting& setting) {
  for (int i = 0; i < setting.steps; ++i) scene.step(frame / setting.steps);
}

double trajectory_error(const AnyScene& scene, const Reference& reference) {
  double largest = 0;
  auto exact = reference.positions.begin();
  for (const Placement& body : scene.placements())
    if (body.moves) largest = std::max(largest, (body.position - *exact++).norm());
  return largest;
}

/// The run itself; what a method throws goes through.
void run(const Problem& problem, const Setting& setting, const Watch& watch, Point& point) {
  AnyScene scene = problem.start();
  scene.use(setting.method);
  const NamedScene& named = problem.scene();
  const double energy = scene.energy(), scale = scene.energy_scale(), spin = scene.angular_momentum().y();
  const auto at = [&](Error which) -> double& { return point.error[static_cast<int>(which)]; };
  at(Error::drift) = scene.separation();
  if (named.keeps_energy) at(Error::energy) = 0;
  if (named.keeps_spin) at(Error::momentum) = 0;
  const long frames = std::lround(named.duration / frame), compared = std::lround(named.time / frame);
  Eigen::Vector3d momentum = scene.momentum();
  for (long i = 1; i <= frames; ++i) {
    advance_frame(scene, setting);
    const double change = std::abs(scene.energy() - energy) / scale;
    if (!scene.finite() || !(change < blown_up)) {
      point.outcome = Outcome::failed;
      point.reason = fmt::format("it blew up after {:.3g} s", i * frame);
      return;
    }
    at(Error::drift) = std::max(at(Error::drift), scene.separation());
    if (named.keeps_energy) at(Error::energy) = std::max(at(Error::energy), change);
    if (named.keeps_spin)
      at(Error::momentum) = std::max(at(Error::momentum), std::abs(scene.angular_momentum().y() / spin - 1));
    if (i == compared - 1) momentum = scene.momentum();
    if (i == compared) {
      const Reference& reference = problem.reference();
      at(Error::trajectory) = trajectory_error(scene, reference);
      const Eigen::Vector3d reaction = (scene.momentum() - momentum) / frame - scene.weight();
      at(Error::reaction) =
          (reaction - reference.reaction).norm() / std::max(reference.reaction.norm(), scene.weight().norm());
      if (watch.algebraic) at(Error::algebraic) = scene.algebraic_error(frame / setting.steps);
    }
    point.row_solves = static_cast<double>(scene.row_solves()) / i;
    if (at(watch.over) > watch.limit) return;
  }
}

}  // namespace

std::string_view name_of(Error error) { return error_names[static_cast<int>(error)].name; }
std::string_view unit_of(Error error) { return error_names[static_cast<int>(error)].unit; }
Error error_named(std::string_view name) {
  for (const Error error : errors)
    if (name_of(error) == name) return error;
  require(false, "error", name, "one of drift, trajectory, energy, momentum, reaction, algebraic");
  return {};
}

std::string Point::described() const {
  std::string text = fmt::format("{}, {} = {}", configuration->name, configuration->knob, knob);
  if (!configuration->tuning.empty()) text += fmt::format(", {} = {}", configuration->tuning, tuning);
  return text;
}

Point measure(const Problem& problem, const Configuration& configuration, int knob, double tuning,
              const Watch& watch) {
  Point point;
  point.configuration = &configuration;
  point.knob = knob;
  point.tuning = tuning;
  const Setting setting = configuration.setting(knob, tuning);
  point.reason = problem.start().refusal(setting.method);
  if (!point.reason.empty()) {
    point.outcome = Outcome::refused;
    return point;
  }
  try {
    run(problem, setting, watch, point);
  } catch (const std::exception& error) {
    point.outcome = Outcome::failed;
    point.reason = error.what();
  }
  return point;
}

double best_tuning(const Problem& problem, const Configuration& configuration, Error error) {
  double best = configuration.tunings.empty() ? 0 : configuration.tunings.front();
  if (configuration.tunings.size() < 2) return best;
  Watch watch{error == Error::algebraic, error};
  const int middle = configuration.values[configuration.values.size() / 2];
  for (const double tuning : configuration.tunings) {
    const Point point = measure(problem, configuration, middle, tuning, watch);
    if (!point.has(error) || point[error] >= watch.limit) continue;
    watch.limit = point[error];
    best = tuning;
  }
  return best;
}

double nanoseconds_a_frame(const Problem& problem, const Setting& setting, double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  constexpr int warm_up = 10;
  const long frames = std::lround(problem.scene().duration / frame);
  std::vector<double> times;
  const Clock::time_point begin = Clock::now();
  do {
    AnyScene scene = problem.start();
    scene.use(setting.method);
    for (long i = 0; i < frames; ++i) {
      const Clock::time_point start = Clock::now();
      advance_frame(scene, setting);
      if (i >= warm_up) times.push_back(since(start));
    }
  } while (since(begin) < seconds);
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return 1e9 * *middle;
}

double cost_of(const Point& point, Cost cost) {
  return cost == Cost::row_solves ? point.row_solves : point.nanoseconds;
}

std::vector<Point> pareto_front(std::span<const Point> points, Error error, Cost cost) {
  std::vector<Point> sorted;
  for (const Point& point : points)
    if (point.has(error) && std::isfinite(cost_of(point, cost))) sorted.push_back(point);
  std::stable_sort(sorted.begin(), sorted.end(), [&](const Point& a, const Point& b) {
    return a[error] != b[error] ? a[error] < b[error] : cost_of(a, cost) < cost_of(b, cost);
  });
  std::vector<Point> front;
  for (const Point& point : sorted)
    if (front.empty() || cost_of(point, cost) < cost_of(front.back(), cost)) front.push_back(point);
  return front;
}

double fitted_order(std::span<const Point> points, Error error) {
  constexpr double rounding = 1e-12;
  std::vector<double> slopes;
  const Point* last = nullptr;
  for (const Point& point : points) {
    if (!point.configuration->shortens_step) return NAN;
    if (!point.has(error) || point[error] < rounding) continue;
    if (last)
      slopes.push_back(std::log((*last)[error] / point[error]) /
                       std::log(static_cast<double>(point.knob) / last->knob));
    last = &point;
  }
  if (slopes.empty()) return NAN;
  const auto middle = slopes.begin() + static_cast<std::ptrdiff_t>(slopes.size() / 2);
  std::nth_element(slopes.begin(), middle, slopes.end());
  return *middle;
}

}  // namespace byhand
