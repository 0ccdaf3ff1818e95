#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/page/items.hpp"
#include "lessons/page/words.hpp"
#include "lessons/scene_file/scene_file.hpp"

// Reports of engines' users: predicted from the equations, run, cured. A case is a folder here with a scene.json
// and a case.cpp that ends in
//
//   const bool told = tell(__FILE__, [] { return Case{…}; });
namespace byhand::cases {

/// A number that the equations give before the run, and the run's.
struct Number {
  std::string what, unit;
  double predicted = 0, found = 0;
  std::string from = {};  // the equation or law of the prediction
  double within = 0.1;    // share by which they may differ, of 0 the difference; of closed forms 1e-6

  course::Tolerance tolerance() const {
    return predicted == 0 ? course::absolute(within) : course::relative(within);
  }
};

/// What engines are asked about a case's scene, where they have all that is in it.
struct Question {
  std::string what, unit;
  double seconds = 1;  // of their run
  std::function<double(const Scene<PlaneBody>&)> read;
};

struct Case {
  std::string title = {};
  std::string report = {};  // in one sentence, in our words
  std::string link = {};
  int law = 0;                    // under which the doctor finds it
  std::string why = {};           // what the equations say of it, in words
  course::Formula equation = {};  // the prediction
  std::function<std::vector<Number>(const SceneFile&)> numbers = {};
  std::optional<Question> engines = {};
  std::string cure = {};
  std::function<SceneFile(SceneFile)> cured = {};  // the scene with the cure
  std::function<std::vector<Number>(const SceneFile&)> numbers_cured = {};
  std::string takeaway = {};
};

/// A case in its folder, "03_regularised_friction".
struct Folder {
  std::string slug;
  Case (*make)();
};
/// All of them, by their numbers.
const std::vector<Folder>& all();
/// Adds the case whose folder holds this source.
bool tell(std::string_view source, Case (*make)());

/// The scene of a case. Throws std::runtime_error if its file is missing.
SceneFile scene_of(const Folder& folder);

/// The file's scene with its method.
template <class M>
Simulation<M> begin(const SceneFile& file) {
  return {std::get<Scene<M>>(file.scene), file.method};
}
/// The same after some time [s].
template <class M>
Simulation<M> after(const SceneFile& file, double seconds) {
  Simulation<M> simulation = begin<M>(file);
  const long steps = std::lround(seconds / file.step);
  for (long i = 0; i < steps; ++i) simulation.step(file.step);
  return simulation;
}

}  // namespace byhand::cases
