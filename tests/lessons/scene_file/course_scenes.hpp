#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lessons/scene_file/scene_file.hpp"

namespace byhand::test {

/// A scene of the course, as its code makes it: lessons/scenes/<name>.json is the same.
struct CourseScene {
  std::string name, title, about;
  SceneOfAnyModel (*make)();
  double duration = 5;  // [s]
  VelocityStepping method = {};
  std::map<std::string, double> accuracy = {};

  SceneFile file() const { return {title, about, make(), {}, method, 1.0 / 60, duration, accuracy}; }
};

/// All of them: those of lessons/scenes, and the chooser's with its names.
const std::vector<CourseScene>& course_scenes();

}  // namespace byhand::test
