#pragma once

#include <string>
#include <vector>

#include "lessons/tutor/options.hpp"
#include "lessons/tutor/told.hpp"

namespace byhand::tutor {

/// The lesson as a Markdown page, lesson.md: formulas in LaTeX, answers folded, pictures by their place
/// beside it. Without frames a sequence shows its caption alone.
std::string markdown(const Lesson& lesson, const std::vector<Told>& told, FramesWanted frames);

}  // namespace byhand::tutor
