#pragma once

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

// How each engine is set in lesson 10: one file an engine, in settings/. There are three rows: as the engine is
// shipped, as its manual advises, and every other setting that is tried, of which the best at each cost counts.
namespace byhand::engines {

/// Knobs of an engine that are turned away from where it is shipped.
class Knobs {
 public:
  Knobs(std::initializer_list<std::pair<std::string, double>> turned = {}) : turned_(turned) {}
  explicit Knobs(std::vector<std::pair<std::string, double>> turned) : turned_(std::move(turned)) {}

  /// Where the knob stands, if it is turned.
  double value(const std::string& name, double shipped) const;
  /// Turns what an engine keeps under that name.
  template <class T>
  void turn(const std::string& name, T& kept) const {
    kept = static_cast<T>(value(name, static_cast<double>(kept)));
  }
  /// "16 substeps", "iterations 40, ERP 0.8"; "as shipped" if none is turned.
  std::string words() const;
  const std::vector<std::pair<std::string, double>>& turned() const { return turned_; }

 private:
  std::vector<std::pair<std::string, double>> turned_;
};

enum class Row { shipped, advised, tuned };

struct Setting {
  Row row = Row::shipped;
  Knobs knobs = {};
  int steps = 1;            // a frame
  std::string source = {};  // of an advice
};

/// The settings of an engine, for scenes of joints and for scenes of contacts: one shipped, one advised, and those
/// that are tried.
struct Settings {
  std::vector<Setting> joints, contacts;
};

// Each is defined in settings/, under its name.
Settings this_course_settings();
Settings box2d_2_settings();
Settings box2d_3_settings();
Settings box3d_settings();
Settings bullet_settings();
Settings bullet_multibody_settings();
Settings chipmunk_settings();
Settings jolt_settings();
Settings mujoco_settings();
Settings ode_quick_settings();
Settings ode_direct_settings();
Settings physx_settings();
Settings physx_articulation_settings();
Settings rapier_settings();

}  // namespace byhand::engines
