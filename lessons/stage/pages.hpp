#pragma once

#include <string>

#include "lessons/page/lesson.hpp"
#include "lessons/scene_file/scene_file.hpp"

namespace byhand::stage {

/// Which of a scene's steps are the doctor's and the chooser's.
inline constexpr const char* doctors_step = "4";
inline constexpr const char* choosers_step = "6";

/// The page of a scene: what it is, its film, energy and drift over time, what the doctor says, what it costs. Its
/// parameters are the method's knobs. `stem` names the folder of its output. `with_chooser`: a step more, which
/// takes a minute.
course::Lesson page_of(const SceneFile& file, const std::string& stem, bool with_chooser = false);

}  // namespace byhand::stage
