#pragma once

#include <string>

#include "lessons/scene_file/scene_file.hpp"

namespace byhand::test {

/// A random scene with a random method: chains, trees, machines, columns, heavy on light, walls, ragdolls; about
/// two in five in space. The same for the same draw.
SceneFile random_scene(int draw);

/// What becomes of a scene that is run to its end.
struct Ending {
  bool fails = false;
  std::string how;
};
Ending ending_of(const SceneFile& file);

}  // namespace byhand::test
