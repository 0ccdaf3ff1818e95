#pragma once

#include <atomic>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/catalogue/any_scene.hpp"

// Scenes by name, with what they can be made of and what is known of how they go on.
namespace byhand {

/// Refuses a name as the solver's `require` refuses a number: throws std::invalid_argument "`what` is `name`, but
/// it must be `allowed`" unless `holds`.
void require(bool holds, std::string_view what, std::string_view name, std::string_view allowed);

/// How long a picture of a scene stands [s]: what is measured is measured at its end.
inline constexpr double frame = 1.0 / 60;

struct SceneParameter {
  std::string name, unit, meaning;
  double initial = 0, low = 0, high = 0;
  bool whole = false;
};

/// How a scene really goes on.
struct ExactState {
  std::vector<Eigen::Vector3d> positions;              // of the centres of all bodies that move [m]
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();  // of all of them [N s]
  double uncertainty = 0;                              // largest error expected in a position [m]
};

/// What a run is held against at one time.
struct Reference {
  double time = 0;                                     // [s]
  double lyapunov_time = INFINITY;                     // in which a small disturbance grows e-fold [s]
  std::vector<Eigen::Vector3d> positions;              // of the centres of all bodies that move [m]
  double uncertainty = 0;                              // largest error expected in one [m]
  Eigen::Vector3d reaction = Eigen::Vector3d::Zero();  // of all that does not move, mean over the last frame [N]
};

class Problem;

/// What a scene has to do before any error of it counts.
enum class Duty {
  hold,   // no joint opens by more than a tenth of a body
  stand,  // no box ends up more than half a box from its place
  slide,  // the block is never more than half a block from where it should be
  keep,   // no joint opens, and nothing sinks in, by more than a tenth of a body; what rests stays in its place
};

/// What the true motion does to the energy, by the scene's scale and from what it was at first: a run whose own
/// goes further by more than a tenth moves otherwise.
struct EnergyOfTruth {
  double most = INFINITY;  // at any time
  double last = NAN;       // at the end, from the scene's own start; NaN where it is not known
};
constexpr double energy_astray = 0.1;

/// A scene of the catalogue, or one of somebody's own.
struct NamedScene {
  std::string name, title;
  std::vector<SceneParameter> parameters;
  std::vector<std::string> models;  // what it can be made of; the first is meant where none is named
  std::string stress;               // the parameter that makes it harder as it grows
  double time = 1;                  // when trajectory and reaction are held against the reference [s]
  double duration = 5;              // how long its duty, drift, energy and momentum are watched [s]
  Duty duty = Duty::hold;
  bool keeps_energy = true;
  EnergyOfTruth energy = {};
  double energy_scale = 0;               // by which changes of energy are measured [J]; 0: that of the scene
  bool keeps_spin = false;               // angular momentum about the vertical through the origin
  std::string size = {};                 // the parameter that is the length of a body; empty: `body`
  double body = 1;                       // that length where it is no parameter [m]
  bool rests = false;                    // whether a scene with Duty::keep stands still
  std::vector<std::string> varied = {};  // the parameters that differ between initial conditions
  bool chaotic = false;
  /// The most instructions that the true motion from any start has taken yet, if they count beside the runs.
  std::shared_ptr<std::atomic<double>> reference_work = {};
  std::string reference;  // where the exact answer comes from
  std::function<AnyScene(const Problem&)> make;
  std::function<std::function<ExactState(double time)>(const Problem&)> exact;
};

/// All of them.
const std::vector<NamedScene>& catalogue();
/// Throws std::invalid_argument for a name that is none of them.
const NamedScene& named_scene(std::string_view name);

using Values = std::map<std::string, double, std::less<>>;

/// A named scene whose parameters have values: what methods are compared on. A cheap value.
class Problem {
 public:
  /// What is not in `values` has its initial value. Throws std::invalid_argument for a name that the scene does
  /// not have, a value outside its range and a model that it cannot be made of.
  explicit Problem(std::string_view scene, const Values& values = {}, std::string_view model = "");
  /// The same with a scene that is not of the catalogue.
  explicit Problem(NamedScene scene) : Problem(std::make_shared<const NamedScene>(std::move(scene)), {}, "") {}

  const NamedScene& scene() const { return *scene_; }
  const std::string& model() const { return model_; }
  const Values& values() const { return values_; }
  double operator[](std::string_view parameter) const { return values_.find(parameter)->second; }
  /// The same with another value.
  Problem with(std::string_view parameter, double value) const;

  /// The same from another initial condition, by up to a twentieth: of a stack, another push. The 0th is its own.
  Problem variation(int i, int seed = 1) const;

  /// Length of a body [m].
  double size() const { return scene_->size.empty() ? scene_->body : (*this)[scene_->size]; }
  /// The scene as it begins.
  AnyScene start() const { return scene_->make(*this); }
  /// When trajectory and reaction are held against the reference [s]: at scene().time, but of a chaotic scene
  /// within its Lyapunov time.
  double compared_at() const {
    return std::round((scene_->chaotic ? reference().time : scene_->time) / frame) * frame;
  }
  /// What its run is held against then; worked out when first asked for, once for all copies.
  const Reference& reference() const;

 private:
  struct Known {
    std::once_flag once;
    Reference reference;
  };
  Problem(std::shared_ptr<const NamedScene> scene, const Values& values, std::string_view model);

  std::shared_ptr<const NamedScene> scene_;
  Values values_;
  std::string model_;
  std::shared_ptr<Known> known_ = std::make_shared<Known>();
};

/// In which a small disturbance of the motion grows e-fold [s], over its duration, by direct solves of short
/// steps; infinite where it does not grow.
double lyapunov_time(const Problem& problem);

}  // namespace byhand
