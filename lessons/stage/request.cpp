#include "lessons/stage/request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <optional>

#include "lessons/doctor/doctor.hpp"
#include "lessons/stage/oscillation.hpp"

namespace byhand::stage {
namespace {

constexpr double pilot_solves = 1e7;    // uses of (17) after which the pilot ends
constexpr double reference_cost = 4e9;  // instructions after which a reference is not refined further

AnyScene any(const SceneFile& file) {
  return std::visit([](const auto& scene) { return AnyScene(scene); }, file.scene);
}

/// Not where rows repeat each other, which its solve cannot take.
bool takes_rattle(AnyScene scene) {
  if (!scene.refusal(Rattle{}).empty()) return false;
  try {
    scene.use(Rattle{.substeps = 8});
    scene.step(frame);
  } catch (const std::runtime_error&) {
    return false;
  }
  return true;
}

/// A method for the true motion: RATTLE where it can, which is of second order, else exact solves.
Method fine_method(bool rattle, int substeps) {
  if (rattle) return Rattle{.substeps = substeps};
  AnyStepping exact{ByGraph{}, Baumgarte{.slop = 0}};
  exact.substeps = substeps;
  exact.gyroscopic = Gyroscopic::implicit;
  return exact;
}

std::vector<Eigen::Vector3d> centres(const AnyScene& scene) {
  std::vector<Eigen::Vector3d> all;
  for (const Placement& body : scene.placements())
    if (body.moves) all.push_back(body.position);
  return all;
}

double smallest_body(const SceneFile& file) {
  double smallest = INFINITY;
  for (const double size : doctor::body_sizes(file))
    if (size > 0) smallest = std::min(smallest, size);
  return std::isinf(smallest) ? 1 : smallest;
}

/// In how many substeps a frame has to be cut for springs to swing on for so long [s]: e^-1 is left of what swings
/// fastest. RATTLE has no springs.
int substeps_of_springs(const SceneFile& file, double time) {
  const double fastest =
      std::visit([&](const auto& scene) { return fastest_oscillation(scene, time); }, file.scene);
  return static_cast<int>(std::min(1e9, 0.5 * fastest * time * frame));
}

/// What the true motion does, as far as the chooser asks.
struct Pilot {
  double seconds = 0;                             // that it was watched
  bool broke = false;                             // whether a step had no answer then
  double scale = 0;                               // of its energy [J]
  double spin_change = INFINITY, away = 0;        // by itself, [m]
  EnergyOfTruth energy = {.most = 0, .last = 0};  // of energy by its scale, as is its largest change
  double energy_change = 0;
};

/// In a scene without weight that begins at rest, or nearly, what springs hold or motors give. An energy of weight
/// is not counted, as it depends on the origin.
double scale_of(const AnyScene& scene, double most_change) {
  const bool weighs = scene.weight().norm() > 0;
  const double scale = scene.energy_scale(),
               other = std::max(weighs ? 0.0 : std::abs(scene.energy()), most_change);
  return scale > 0.01 * other ? scale : other > 0 ? other : 1;
}

/// The energy that an instant takes, in which first velocities that pull joints apart become such that do not [J].
double energy_taken_at_first(AnyScene scene) {
  scene.use(AnyStepping{ByGraph{}, Baumgarte{.beta = 0}});
  const double before = scene.energy();
  try {
    scene.step(1e-6 * frame);
  } catch (const std::runtime_error&) {
    return 0;
  }
  return before - scene.energy();
}

Pilot watch_pilot(const SceneFile& file, int substeps) {
  const AnyScene start = any(file);
  AnyScene scene = start;
  scene.use(fine_method(takes_rattle(start), substeps));
  const std::vector<Eigen::Vector3d> places = centres(scene);
  const double energy = scene.energy(), spin = scene.angular_momentum().y();
  Pilot pilot;
  if (spin != 0) pilot.spin_change = 0;
  const long frames = std::max(2L, std::lround(file.duration / frame));
  for (long i = 1; i <= frames; ++i) {
    try {
      scene.step(frame);
    } catch (const std::runtime_error&) {
      pilot.broke = true;  // the methods are watched until here
      break;
    }
    pilot.seconds = scene.time();
    const double gained = scene.energy() - energy;
    pilot.energy_change = std::max(pilot.energy_change, std::abs(gained));
    pilot.energy = {std::max(pilot.energy.most, gained), gained};
    pilot.away = std::max(pilot.away, scene.farthest_from(places));
    if (spin != 0)
      pilot.spin_change = std::max(pilot.spin_change, std::abs(scene.angular_momentum().y() / spin - 1));
    if (static_cast<double>(scene.row_solves()) > pilot_solves && scene.time() > 1) break;
  }
  pilot.seconds = std::max(pilot.seconds, 2 * frame);
  pilot.scale = scale_of(start, pilot.energy_change);
  for (double* number : {&pilot.energy.most, &pilot.energy.last, &pilot.energy_change}) *number /= pilot.scale;
  return pilot;
}

/// Its energy is not known where shorter steps have another, or where both damp what springs hold.
Pilot watch_pilot(const SceneFile& file) {
  constexpr int few = 8, more = 32;
  Pilot pilot = watch_pilot(file, few);
  const Pilot finer = watch_pilot(file, more);
  const bool alone = pilot.broke && finer.seconds > pilot.seconds;  // the shorter steps went on
  if (alone) pilot = finer;
  const double apart =
      std::max({std::abs(pilot.energy.most - finer.energy.most), std::abs(pilot.energy.last - finer.energy.last),
                std::abs(pilot.energy_change - finer.energy_change)});
  pilot.energy = finer.energy, pilot.energy_change = finer.energy_change, pilot.scale = finer.scale;
  if (alone || !(apart < 0.5 * energy_astray) || finer.seconds < pilot.seconds ||
      substeps_of_springs(file, finer.seconds) > more)
    pilot.energy = {.most = INFINITY, .last = NAN}, pilot.energy_change = NAN;
  return pilot;
}

/// Whether no part of a scene takes or gives energy: rods, joints and springs without dampers between bodies that
/// are at rest or free.
template <class M>
bool keeps_energy(const Scene<M>& scene) {
  const Bodies<M>& bodies = scene.bodies();
  const auto inert = [&](int place) {
    const auto& entry = scene.entries()[place];
    const ConstraintStore<M>& store = scene.store(entry.kind);
    if (const auto* spring = scene.template get_if<Spring<M>>(place)) return spring->elastic.damping == 0;
    return store.bound == Bound::none && store.position_rows == store.rows && store.softness(entry.index) == 0;
  };
  for (int place = 0; place < scene.count(); ++place)
    if (!inert(place)) return false;
  for (int body = 0; body < bodies.size(); ++body)
    if (!moves(bodies.inverse_mass[body]) && in_motion(bodies, body)) return false;
  const auto damped = [](const BodyForces& forces) {
    return forces.linear_damping != 0 || forces.angular_damping != 0;
  };
  return scene.colliders().shapes.empty() && bodies.applied.empty() &&
         std::none_of(bodies.forces.begin(), bodies.forces.end(), damped);
}
bool keeps_energy(const SceneFile& file) {
  return std::visit([](const auto& scene) { return keeps_energy(scene); }, file.scene);
}

struct Ended {
  ExactState before, end;  // one frame apart
  double cost = 0;         // of its run [instructions]
  bool touched = false;    // whether bodies touched in it
};
/// What takes a scene a frame further, in steps in place of substeps, so that contacts are found as often.
std::function<void()> finely(AnyScene& scene, bool rattle, int substeps) {
  const int steps = rattle ? 1 : substeps;
  scene.use(fine_method(rattle, substeps / steps));
  return [&scene, steps] {
    for (int i = 0; i < steps; ++i) scene.step(frame / steps);
  };
}
Ended run(AnyScene scene, bool rattle, int substeps, double time) {
  const auto advance = finely(scene, rattle, substeps);
  const long frames = std::lround(time / frame);
  for (long i = 1; i < frames; ++i) advance();
  const ExactState before{centres(scene), scene.momentum()};
  advance();
  const std::string kind = scene.row_kind();
  const Prices prices = rattle ? prices_of(kind, "RATTLE")
                               : prices_of(kind, "by graph") + prices_of(kind, "stepping") +
                                     prices_of(kind, name_of(Cure::baumgarte));
  return {
      before, {centres(scene), scene.momentum()}, cost_of(scene.effort(), prices), scene.effort().contacts > 0};
}

using Places = std::vector<Eigen::Vector3d>;
double farthest_apart(const Places& a, const Places& b) {
  double apart = 0;
  for (std::size_t i = 0; i < a.size(); ++i) apart = std::max(apart, (a[i] - b[i]).norm());
  return apart;
}

/// Richardson's extrapolation of two runs, of which the second has half the step and a `factor`-th of the error.
Ended extrapolated(const Ended& coarse, const Ended& fine, double factor) {
  Ended result = fine;
  const auto extrapolate = [&](ExactState& to, const ExactState& from) {
    for (std::size_t i = 0; i < to.positions.size(); ++i)
      to.positions[i] += (to.positions[i] - from.positions[i]) / (factor - 1);
    to.momentum += (to.momentum - from.momentum) / (factor - 1);
  };
  extrapolate(result.before, coarse.before);
  extrapolate(result.end, coarse.end);
  return result;
}

/// Where the scene is at a time and a frame before it: its steps are halved until two runs are as close as this,
/// or cost too much [m]. `cost` is that of all runs. While the runs come closer as those of first or second order
/// do, they are extrapolated, and three extrapolations have to be as close. Where events are met a step sooner or
/// later, two runs may agree by chance: so it counts as well by how much those before differed, a fourth of it for
/// each halving since. Where bodies touch, long steps meet with another normal than short ones: there nothing is
/// extrapolated, nor believed before steps are short. Nor is anything believed of fewer substeps than springs
/// need. What two runs of first order differ by counts twice, for the finer one is about as far from the true
/// motion. `size` is that of a body.
Ended refined(const AnyScene& start, double size, double time, double close, int of_springs) {
  const bool rattle = takes_rattle(start);
  Ended coarse = run(start, rattle, 8, time), best = coarse;
  // Substeps up to which no agreement is believed.
  const auto chance = [&] { return std::max(of_springs, coarse.touched ? 512 : 64); };
  double uncertainty = INFINITY, cost = coarse.cost;
  std::array<double, 2> before{};     // by how much the runs before differed
  std::optional<Ended> last;          // extrapolation
  std::optional<double> last_change;  // from the extrapolation before that
  // A motion without events is worth more.
  const auto most = [&] { return last || of_springs > 64 ? 8192 : 1024; };
  int reached = 8;
  for (int substeps = 16; substeps <= most() && (reached < chance() || uncertainty > close); substeps *= 2) {
    Ended fine = run(start, rattle, substeps, time);
    const double apart = farthest_apart(fine.end.positions, coarse.end.positions), ratio = before[0] / apart;
    const double factor = std::abs(ratio - 2) < 0.2 ? 2 : std::abs(ratio - 4) < 0.4 ? 4 : 0;
    best = fine, uncertainty = (rattle ? 1 : 2) * std::max({apart, before[0] / 4, before[1] / 16});
    std::optional<Ended> now;
    std::optional<double> change;
    if (factor > 0 && !fine.touched) now = extrapolated(coarse, fine, factor);
    if (now && last) change = farthest_apart(now->end.positions, last->end.positions);
    if (change && last_change) best = *now, uncertainty = std::max({*change, *last_change / 4, 0.01 * apart});
    const bool hopeless = (substeps >= 128 && apart > 0.5 * size) || 4 * fine.cost > reference_cost;
    cost += fine.cost;
    last = std::move(now), last_change = change, coarse = std::move(fine), before = {apart, before[0]},
    reached = substeps;
    if (hopeless) break;
  }
  if (reached < of_springs) uncertainty = INFINITY;
  best.before.uncertainty = best.end.uncertainty = uncertainty;
  best.cost = cost;
  return best;
}

/// How far any body is at most, in the last tenth of a time, from where it then ends [m], to a tenth of that.
double last_motion(AnyScene scene, double time, int of_springs) {
  const auto advance = finely(scene, takes_rattle(scene), std::clamp(16 * of_springs, 64, 8192));
  const long frames = std::lround(time / frame), before = frames - std::max(1L, frames / 10);
  std::vector<Places> last;
  for (long i = 0; i < frames; ++i) {
    if (i >= before) last.push_back(centres(scene));
    advance();
  }
  double most = 0;
  for (const Places& places : last) most = larger(most, farthest_apart(places, centres(scene)));
  return most;
}

/// What is known of starts, by their values.
class Known {
 public:
  template <class F>
  Ended find(const Values& start, F&& computed) {
    {
      const std::scoped_lock lock(mutex_);
      if (const auto found = all_.find(start); found != all_.end()) return found->second;
    }
    const Ended now = computed();
    const std::scoped_lock lock(mutex_);
    return all_.emplace(start, now).first->second;
  }

 private:
  std::mutex mutex_;
  std::map<Values, Ended> all_;
};

/// The file's scene with its gravity and its velocities times a factor each.
AnyScene scaled(const SceneFile& file, double gravity, double speed) {
  return std::visit(
      [&](auto scene) {
        scene.gravity *= gravity;
        if (speed != 1)
          for (auto& V : scene.state().velocity) V *= speed;
        return AnyScene(std::move(scene));
      },
      file.scene);
}

/// With friction at each corner that touches. A manifold's is in the middle of two that are near, where no step is
/// short enough for a box to tip about the one.
SceneFile with_contact_at_points(SceneFile file) {
  std::visit([](auto& scene) { scene.set_contact_rows(ContactRows::points); }, file.scene);
  return file;
}

bool begins_moving(const SceneFile& file) {
  return std::visit(
      [](const auto& scene) {
        const auto& V = scene.bodies().velocity;
        return std::any_of(V.begin(), V.end(), [](const auto& v) { return !v.isZero(0); });
      },
      file.scene);
}
bool has_weight(const SceneFile& file) {
  return std::visit([](const auto& scene) { return !scene.gravity.isZero(0); }, file.scene);
}

/// How close two runs have to be, for what is asked [m].
double closeness(const SceneFile& file) {
  const auto asked = file.accuracy.find("trajectory");
  return std::max(1e-7 * smallest_body(file), asked == file.accuracy.end() ? 0.0 : 0.01 * asked->second);
}

bool asks_for_truth(const SceneFile& file) {
  return std::ranges::any_of(file.accuracy, [](const auto& one) { return needs_truth(error_named(one.first)); });
}

/// The scene as a problem, of which trajectory and reaction are compared at `time` [s].
NamedScene scene_of(const SceneFile& file, const Pilot& pilot, double time) {
  NamedScene scene;
  scene.name = "file";
  scene.title = file.title.empty() ? "scene of this file" : file.title;
  scene.parameters = {{"gravity", "1", "times that of the file", 1, 0.01, 1e3},
                      {"speed", "1", "times the first velocities of the file", 1, 0.01, 1e3}};
  scene.models = {"as in the file"};
  scene.stress = has_weight(file) ? "gravity" : "speed";
  if (begins_moving(file)) scene.varied.push_back("speed");
  if (has_weight(file)) scene.varied.push_back("gravity");
  scene.duration = pilot.seconds;
  scene.time = std::floor(time / frame + 1e-9) * frame;
  scene.duty = Duty::keep;
  scene.body = smallest_body(file);
  scene.rests = pilot.away < 0.1 * scene.body;
  const bool by_its_parts = keeps_energy(file);
  const auto asked = file.accuracy.find("energy");
  scene.keeps_energy =
      by_its_parts || pilot.energy_change < (asked == file.accuracy.end() ? 0.01 : 0.1 * asked->second);
  scene.energy_scale = pilot.scale;
  scene.energy = by_its_parts ? EnergyOfTruth{.most = 0, .last = 0} : pilot.energy;
  scene.keeps_spin = pilot.spin_change < 1e-6;
  scene.reference = "runs whose steps are halved until two agree";
  scene.make = [file](const Problem& problem) { return scaled(file, problem["gravity"], problem["speed"]); };
  scene.reference_work = std::make_shared<std::atomic<double>>(0);
  scene.exact = [file = with_contact_at_points(file), close = closeness(file), work = scene.reference_work,
                 known = std::make_shared<Known>()](const Problem& problem) {
    const double at = problem.scene().time;
    const auto ended = [&](double moment) {
      return refined(scaled(file, problem["gravity"], problem["speed"]), problem.size(), moment, close,
                     substeps_of_springs(file, moment));
    };
    const Ended both = known->find(problem.values(), [&] { return ended(at); });
    for (double known_cost = *work;
         known_cost < both.cost && !work->compare_exchange_weak(known_cost, both.cost);) {
    }
    return [=](double moment) {
      if (std::abs(moment - at) < 0.5 * frame) return both.end;
      if (std::abs(moment + frame - at) < 0.5 * frame) return both.before;
      return ended(moment).end;
    };
  };
  return scene;
}

}  // namespace

Request request_of(const SceneFile& file) {
  const Pilot pilot = watch_pilot(file);
  const auto compared_at = [&](double time) { return Problem(scene_of(file, pilot, time)); };
  Request request{
      .problem = compared_at(pilot.seconds), .limits = {}, .seconds = pilot.seconds, .broke = pilot.broke};
  // At the end, if the true motion is known until then.
  if (!asks_for_truth(file) || !(request.problem.reference().uncertainty < 10 * closeness(file)))
    request.problem = compared_at(std::min(1.0, pilot.seconds));
  const NamedScene& scene = request.problem.scene();
  if (asks_for_truth(file) && scene.time < pilot.seconds - frame)
    request.notes.push_back(
        fmt::format("Until {:.3g} s, as long as the scene is watched, its true motion is not known well enough. "
                    "So it is compared "
                    "after {:.2g} s.",
                    pilot.seconds, scene.time));
  if (asks_for_truth(file))
    request.last_motion = last_motion(request.problem.start(), scene.time, substeps_of_springs(file, scene.time));
  for (const auto& [name, limit] : file.accuracy) {
    const Error error = error_named(name);
    if (error == Error::energy && !scene.keeps_energy && std::isnan(pilot.energy_change))
      request.notes.emplace_back(
          "The file limits the change of energy, but how the true motion changes it is not known, as runs of "
          "shorter steps have another. So this limit is left out.");
    else if (error == Error::energy && !scene.keeps_energy)
      request.notes.push_back(
          fmt::format("The file limits the change of energy, but the true motion changes it by {:.2g} % of its "
                      "scale, as friction, bounces, dampers, servos and motors can. So this limit is left out; a "
                      "run that ever has more than the most of the true motion and {:.2g} % of the scale still "
                      "fails, and from the file's own start one that ends further than that from it.",
                      100 * pilot.energy_change, 100 * energy_astray));
    else if (!has(scene, error))
      request.notes.push_back(fmt::format(
          "The file limits the error of {}, but the true motion of this scene does not keep it.", name));
    else if (needs_truth(error) && std::isinf(request.problem.reference().uncertainty))
      request.notes.push_back(fmt::format(
          "The file limits the error of {}, but after {:.2g} s the true motion is not known: steps "
          "that are short enough for its springs cost more than is allowed. So this limit is left out.",
          name, scene.time));
    else if (needs_truth(error) &&
             !well_known(request.problem.reference().uncertainty,
                         {{Error::trajectory, error == Error::trajectory ? limit : scene.body}}))
      request.notes.push_back(fmt::format(
          "The file limits the error of {}, but after {:.2g} s the true motion is known to {:.2g} m only, from "
          "runs whose steps were halved for as long as that may cost and they came nearer. So this limit is left "
          "out.",
          name, scene.time, request.problem.reference().uncertainty));
    else
      request.limits[error] = limit;
  }
  if (const auto energy = request.limits.find(Error::energy); energy != request.limits.end()) {
    request.taken = energy_taken_at_first(any(file)) / pilot.scale;
    if (request.taken > 0.1 * energy->second && request.taken <= energy->second)
      request.notes.push_back(fmt::format(
          "The first velocities pull joints apart. The first step of any method ends that, which takes "
          "{:.2g} of the energy's scale: so much of the limit of {:.2g} is spent.",
          request.taken, energy->second));
  }
  if (request.limits.empty()) {
    request.limits[Error::drift] = 0.01 * scene.body;
    request.notes.push_back(fmt::format(
        "{}, so gaps and overlaps of at most a hundredth of the smallest body are asked for, {:.2g} m.",
        file.accuracy.empty() ? "The file does not say what is to be accurate"
                              : "Nothing else is left of its \"accuracy\"",
        0.01 * scene.body));
  }
  return request;
}

}  // namespace byhand::stage
