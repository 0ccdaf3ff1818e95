#pragma once

#include <optional>
#include <string>

#include "lessons/page/lesson.hpp"
#include "lessons/scene_file/scene_file.hpp"
#include "lessons/stage/watched.hpp"

namespace byhand::stage {

/// What a reader can turn of a scene, as parameters of its page. They begin at what the file says.
class Knobs {
 public:
  Knobs(course::Lesson& lesson, SceneFile file);

  /// The file with its method, step and duration as they are now.
  SceneFile file() const;
  /// The method, which may be one that a file cannot name: XPBD, RATTLE, …
  Method method() const;
  /// "Gauss–Seidel, 10 sweeps, Baumgarte with β = 0.2, 1 substep of h = 1/60 s".
  std::string described() const;

 private:
  SceneFile file_;
  course::Parameter<std::string> solver_, cure_;
  course::Parameter<int> sweeps_, substeps_;
  course::Parameter<double> beta_, slop_, frequency_, h_, seconds_;
};

}  // namespace byhand::stage
