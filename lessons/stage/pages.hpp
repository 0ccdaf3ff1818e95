#pragma once

#include <string>

#include "lessons/page/lesson.hpp"
#include "lessons/scene_file/scene_file.hpp"

namespace byhand::stage {

/// Which of a scene's steps is the doctor's.
inline constexpr const char* doctors_step = "4";

/// The page of a scene: what it is, its film, energy and drift over time, what the doctor says, what it costs. Its
/// parameters are the method's knobs. `stem` names the folder of its output.
course::Lesson page_of(const SceneFile& file, const std::string& stem);

}  // namespace byhand::stage
