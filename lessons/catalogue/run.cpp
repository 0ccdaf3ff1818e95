#include "lessons/catalogue/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "lessons/catalogue/cost.hpp"

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
                                                          {"contact", "m/s"},
                                                          {"algebraic", "m/s"}}};

constexpr double blown_up = 100;  // times the energy scale

void advance_frame(AnyScene& scene, const Setting& setting) {
  for (int i = 0; i < setting.steps; ++i) scene.step(frame / setting.steps);
}

std::vector<Eigen::Vector3d> centres(const AnyScene& scene) {
  std::vector<Eigen::Vector3d> all;
  for (const Placement& body : scene.placements())
    if (body.moves) all.push_back(body.position);
  return all;
}

/// Holds a run against its duty.
class Judge {
 public:
  Judge(const Problem& problem, const AnyScene& scene) : duty_(problem.scene().duty), size_(problem.size()) {
    const auto begins_otherwise = [&](const SceneParameter& one) { return problem[one.name] != one.initial; };
    own_start_ = std::ranges::none_of(problem.scene().parameters, begins_otherwise);
    end_ = problem.scene().duration - 0.5 * frame;
    if (duty_ == Duty::stand || problem.scene().rests) places_ = centres(scene);
    if (duty_ == Duty::slide) {
      size_ = problem["height"];
      exact_ = problem.scene().exact(problem);
    }
  }

  /// Whether its energy is another than that of the true motion by now [s], by the scale of energy; then how.
  bool strayed(const EnergyOfTruth& truth, double gained, double now, Point& point) const {
    const auto fails = [&](double more, const char* than) {
      return fail(point, Outcome::strayed,
                  fmt::format("its energy was {:.2g} of its scale {} than in the true motion at {:.2g} s",
                              std::abs(more), than, now));
    };
    // From another start a motor gives another energy; where none is given, none is from any start.
    const bool known = own_start_ || truth.most <= energy_astray;
    if (known && gained > truth.most + energy_astray) return fails(gained - truth.most, "more");
    const double left = gained - truth.last;
    return own_start_ && now > end_ && std::abs(left) > energy_astray && fails(left, left > 0 ? "more" : "less");
  }

  /// Whether it has failed by now; then how.
  bool failed(const AnyScene& scene, double apart, Point& point) const {
    const double now = scene.time();
    if (!places_.empty() && scene.farthest_from(places_) > size_ / 2)
      return fail(point, Outcome::fell,
                  fmt::format("it fell: {} from its place at {:.2g} s",
                              duty_ == Duty::stand ? "a box was half a box" : "a body was half its length", now));
    if (duty_ != Duty::stand && apart > size_ / 10)
      return fail(point, Outcome::opened,
                  fmt::format("{} by a tenth of a body at {:.2g} s",
                              duty_ == Duty::hold    ? "a joint opened"
                              : duty_ == Duty::slide ? "it sank in"
                                                     : "a joint opened, or a body sank in,",
                              now));
    if (duty_ == Duty::slide && scene.farthest_from(exact_(now).positions) > 0.5)
      return fail(point, Outcome::strayed,
                  fmt::format("it was half its length from where it should be at {:.2g} s", now));
    return false;
  }

 private:
  static bool fail(Point& point, Outcome outcome, std::string reason) {
    point.outcome = outcome;
    point.reason = std::move(reason);
    return true;
  }

  Duty duty_;
  double size_;
  bool own_start_;  // whether it begins as the scene does, whose true energy is known
  double end_;      // after which its run has come to its end [s]
  std::vector<Eigen::Vector3d> places_;
  std::function<ExactState(double)> exact_;
};

/// What a frame costs on the mean of a whole run, foreseen from those that it has taken. The first is counted
/// once: there all contacts are new and rows start cold, which may cost several times as much as any later frame.
class Bill {
 public:
  explicit Bill(long frames) : frames_(static_cast<double>(frames)) {}

  /// After so many of them and what they cost together. Until the third, later ones may cost a tenth of that.
  double a_frame(double total, long frames) {
    if (frames == 1) first_ = total;
    const double later = frames < 3 ? total / 10 : (total - first_) / static_cast<double>(frames - 1);
    return (first_ + later * (frames_ - 1)) / frames_;
  }

 private:
  double frames_, first_ = 0;
};

/// The run itself; what a method throws goes through.
void run(const Problem& problem, const Setting& setting, const Watch& watch, Point& point) {
  AnyScene scene = problem.start();
  scene.use(setting.method);
  const NamedScene& named = problem.scene();
  const double energy = scene.energy(), scale = named.energy_scale > 0 ? named.energy_scale : scene.energy_scale(),
               spin = scene.angular_momentum().y();
  const Prices prices = prices_of(scene.row_kind(), *point.family, point.knobs.cure),
               free = prices_of(scene.row_kind(), "free");
  const Judge judge(problem, scene);
  const auto at = [&](Error which) -> double& { return point.error[static_cast<int>(which)]; };
  at(Error::drift) = scene.separation();
  if (named.keeps_energy) at(Error::energy) = 0;
  if (named.keeps_spin) at(Error::momentum) = 0;
  const bool touches = has(named, Error::contact);
  const long frames = std::lround((watch.seconds > 0 ? watch.seconds : named.duration) / frame),
             compared =
                 watch.reference || touches || watch.algebraic ? std::lround(problem.compared_at() / frame) : 0;
  Bill bill(frames);
  Eigen::Vector3d momentum = scene.momentum();
  for (long i = 1; i <= frames; ++i) {
    advance_frame(scene, setting);
    point.seconds = static_cast<double>(i) * frame;
    point.row_solves = static_cast<double>(scene.row_solves()) / static_cast<double>(i);
    const Effort effort = scene.effort();
    point.cost = cost_of(effort, prices) / static_cast<double>(i);
    if (scene.rows() == 0) point.cost = std::max(point.cost, cost_of(effort, free) / static_cast<double>(i));
    const double gained = (scene.energy() - energy) / scale, change = std::abs(gained), apart = scene.separation();
    if (!scene.finite() || !(change < blown_up)) {
      point.outcome = Outcome::blew_up;
      point.reason = fmt::format("it blew up after {:.2g} s", static_cast<double>(i) * frame);
      return;
    }
    if (judge.failed(scene, apart, point) || judge.strayed(named.energy, gained, i * frame, point)) return;
    if (const double cost = bill.a_frame(point.cost * static_cast<double>(i), i); cost > watch.most) {
      point.outcome = Outcome::too_slow;
      point.reason = "it costs more than is allowed here";
      point.cost = cost;
      return;
    }
    at(Error::drift) = std::max(at(Error::drift), apart);
    if (named.keeps_energy) at(Error::energy) = std::max(at(Error::energy), change);
    if (named.keeps_spin)
      at(Error::momentum) = std::max(at(Error::momentum), std::abs(scene.angular_momentum().y() / spin - 1));
    if (i + 1 == compared) momentum = scene.momentum();
    if (i == compared && watch.reference) {
      const Reference& reference = problem.reference();
      at(Error::trajectory) = scene.farthest_from(reference.positions);
      point.uncertainty = reference.uncertainty;
      const Eigen::Vector3d reaction = (scene.momentum() - momentum) / frame - scene.weight();
      at(Error::reaction) =
          (reaction - reference.reaction).norm() / std::max(reference.reaction.norm(), scene.weight().norm());
    }
    if (i == compared) {
      if (touches) at(Error::contact) = scene.residual();
      if (watch.algebraic) at(Error::algebraic) = scene.algebraic_error(frame / setting.steps);
    }
    for (int e = 0; e < error_count; ++e)
      if (point.error[static_cast<std::size_t>(e)] > watch.limit[static_cast<std::size_t>(e)]) return;
  }
}

}  // namespace

std::string_view name_of(Error error) { return error_names[static_cast<std::size_t>(error)].name; }
std::string_view unit_of(Error error) { return error_names[static_cast<std::size_t>(error)].unit; }
Error error_named(std::string_view name) {
  for (const Error error : errors)
    if (name_of(error) == name) return error;
  require(false, "error", name, "one of drift, trajectory, energy, momentum, reaction, contact, algebraic");
  return {};
}

bool has(const NamedScene& scene, Error error) {
  switch (error) {
    case Error::energy: return scene.keeps_energy;
    case Error::momentum: return scene.keeps_spin;
    case Error::contact: return scene.duty != Duty::hold;
    case Error::algebraic: return scene.duty == Duty::hold;
    default: return true;
  }
}

std::string_view name_of(Outcome outcome, Duty duty) {
  switch (outcome) {
    case Outcome::good: return duty == Duty::stand ? "stood" : duty == Duty::slide ? "slid" : "held";
    case Outcome::refused: return "cannot";
    case Outcome::opened: return "opened";
    case Outcome::fell: return "fell";
    case Outcome::strayed: return "strayed";
    case Outcome::blew_up: return "blew up";
    case Outcome::no_solution: return "no solution";
    case Outcome::too_slow: return "too slow";
  }
  return "";
}

std::string Point::described() const { return family->name + described_knobs(*family, knobs); }

Point measure(const Problem& problem, const Family& family, const Knobs& knobs, const Watch& watch) {
  Point point;
  point.family = &family;
  point.knobs = knobs;
  const Setting setting = family.setting(knobs);
  point.reason = problem.start().refusal(setting.method);
  if (!point.reason.empty()) {
    point.outcome = Outcome::refused;
    return point;
  }
  try {
    run(problem, setting, watch, point);
  } catch (const std::invalid_argument& error) {
    point.outcome = Outcome::refused;
    point.reason = error.what();
  } catch (const std::exception& error) {
    point.outcome = Outcome::no_solution;
    point.reason = error.what();
  }
  return point;
}

namespace {

/// What the clock tells apart [s]: some nanoseconds, in a browser a tenth of a millisecond, in which many frames
/// pass. They are timed together.
double tick() {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  Clock::time_point next = begin;
  while (next == begin) next = Clock::now();
  return std::chrono::duration<double>(next - begin).count();
}

}  // namespace

double nanoseconds_a_frame(const Problem& problem, const Setting& setting, double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  constexpr int warm_up = 10;
  const long frames = std::lround(problem.scene().duration / frame);
  std::vector<double> times;
  const Clock::time_point begin = Clock::now();
  const double enough = 50 * tick();
  do {
    AnyScene scene = problem.start();
    scene.use(setting.method);
    Clock::time_point start = Clock::now();
    long timed = 0, i = 0;
    for (; i < frames && (i <= 2 * warm_up || since(begin) < 8 * seconds); ++i) {
      if (i == warm_up) start = Clock::now(), timed = 0;
      advance_frame(scene, setting);
      ++timed;
    }
    if (const double taken = since(start); taken > enough || times.empty()) times.push_back(taken / timed);
  } while (since(begin) < seconds);
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return 1e9 * *middle;
}

}  // namespace byhand
