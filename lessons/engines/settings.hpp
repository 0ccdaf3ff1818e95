#pragma once

#include <array>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

// How each engine is set in lesson 10: one file an engine, in settings/. There are three rows: as the engine is
// shipped, as its manual advises, and every other setting that is tried, of which the best at each cost counts.
// All engines are tried with the same steps, and the iterative ones with the same iterations, shared out among
// these.
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
  /// "16 substeps", "RK4, 40 iterations, ERP 0.8"; "as shipped" if none is turned. A knob in capitals that is 0
  /// or 1 is a switch.
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

/// Steps a frame that each engine is tried with; it may count them as substeps.
inline constexpr std::array joint_steps{1, 2, 3, 4, 8, 16, 32};
inline constexpr std::array contact_steps{1, 2, 4, 8, 32};
/// Iterations a frame that an iterative engine is tried with.
inline constexpr std::array joint_iterations{32, 128, 512, 2048};
inline constexpr std::array contact_iterations{32, 128};

/// Substeps a frame of an engine whose substep is its iteration.
inline constexpr std::array substeps_of_joints{1, 2, 3, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048};
inline constexpr std::array substeps_of_contacts{1, 2, 4, 8, 16, 32, 64, 128};

/// Steps a frame and iterations in each.
struct Shares {
  int steps, iterations;
};
/// Each number of iterations a frame, shared out among each number of steps.
std::vector<Shares> shares_of_joints();
std::vector<Shares> shares_of_contacts();

/// How often a setting goes through the constraints in a frame.
double iterations_a_frame(const Setting& setting);

/// The settings of an engine, for scenes of joints and for scenes of contacts: one shipped, one advised, and those
/// that are tried.
struct Settings {
  std::vector<Setting> joints, contacts;
};

/// Of Box2D 3 and of Box3D, which has its solver. `source` is where more substeps are advised.
Settings soft_step_settings(const std::string& source);

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
