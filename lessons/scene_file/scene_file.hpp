#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "solver/byhand.hpp"

// Scenes as files: JSON with comments, in SI units. `scene.schema.json` beside this header is its schema, in which
// every member has its unit and meaning; lessons/scenes/*.json are examples.
namespace byhand {

/// A scene whose model is known only when it is read.
using SceneOfAnyModel =
    std::variant<Scene<PlaneParticle>, Scene<PlaneBody>, Scene<SpaceParticle>, Scene<SpaceBody>>;

// What files and knobs call the solvers of rows and the cures of drift, in the order of their variants.
inline constexpr std::array<const char*, 6> row_solver_names{"gauss_seidel",     "jacobi", "direct",
                                                             "conjugate_sweeps", "newton", "by_graph"};
inline constexpr std::array<const char*, 5> drift_cure_names{"none", "baumgarte", "projection", "split_impulse",
                                                             "soft"};
static_assert(row_solver_names.size() == std::variant_size_v<RowSolver>);
static_assert(drift_cure_names.size() == std::variant_size_v<DriftCure>);

/// A scene and what its file says besides.
struct SceneFile {
  std::string title = {}, about = {};   // for people
  SceneOfAnyModel scene = {};           // all bodies and constraints, in the file's order
  std::vector<std::string> names = {};  // of the bodies; "" where a body has none
  VelocityStepping method;
  double step = 1.0 / 60;  // h [s] > 0
  double duration = 5;     // how long the scene is watched [s]
  // What shall be accurate, and within how much, each in its own unit: see accuracy_names().
  std::map<std::string, double> accuracy = {};

  /// "body 3", or its name in quotes.
  std::string name_of(int body) const;
};

/// The errors that a file may limit, with their units: drift [m], energy [1], …
struct AccuracyName {
  std::string unit, meaning;
};
const std::map<std::string, AccuracyName>& accuracy_names();

/// Reads a file's text. Throws std::invalid_argument with one sentence: the line, the member, its value and what
/// is allowed.
SceneFile read_scene(std::string_view text);

/// The file's text. It reads back to a scene that steps to the same bits. Throws std::invalid_argument for what a
/// file cannot hold: a kind that is not the library's, forces that act in the next step.
std::string write_scene(const SceneFile& file);

/// The JSON schema of such files.
std::string scene_schema();

}  // namespace byhand
