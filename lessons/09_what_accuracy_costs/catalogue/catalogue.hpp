#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/09_what_accuracy_costs/catalogue/any_scene.hpp"

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
  std::vector<Eigen::Vector3d> positions;              // of the centres of all bodies that move [m]
  double uncertainty = 0;                              // largest error expected in one [m]
  Eigen::Vector3d reaction = Eigen::Vector3d::Zero();  // of all that does not move, mean over the last frame [N]
};

class Problem;

/// A scene of the catalogue.
struct NamedScene {
  std::string name, title;
  std::vector<SceneParameter> parameters;
  std::vector<std::string> models;  // what it can be made of; the first is meant where none is named
  std::string stress;               // the parameter that makes it harder as it grows
  double time = 1;                  // when trajectory and reaction are held against the reference [s]
  double duration = 5;              // how long drift, energy and momentum are watched [s]
  bool keeps_energy = true;
  bool keeps_spin = false;  // angular momentum about the vertical through the origin
  std::string reference;    // where the exact answer comes from
  AnyScene (*make)(const Problem&);
  std::function<ExactState(double time)> (*exact)(const Problem&);
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

  const NamedScene& scene() const { return *scene_; }
  const std::string& model() const { return model_; }
  const Values& values() const { return values_; }
  double operator[](std::string_view parameter) const { return values_.find(parameter)->second; }
  /// The same with another value.
  Problem with(std::string_view parameter, double value) const;

  /// The scene as it begins.
  AnyScene start() const { return scene_->make(*this); }
  /// What its run is held against at scene().time; worked out when first asked for, once for all copies.
  const Reference& reference() const;

 private:
  struct Known {
    std::once_flag once;
    Reference reference;
  };
  const NamedScene* scene_;
  Values values_;
  std::string model_;
  std::shared_ptr<Known> known_ = std::make_shared<Known>();
};

}  // namespace byhand
