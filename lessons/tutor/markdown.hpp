#pragma once

#include <string>
#include <vector>

#include "lessons/tutor/options.hpp"
#include "lessons/tutor/recording.hpp"

namespace byhand::tutor {

/// lesson.md: the lesson in Markdown with formulas in LaTeX, answers folded, and links to the pictures beside it.
/// A sequence without frames is its caption alone.
std::string markdown(const Lesson& lesson, const std::vector<RecordedStep>& steps, FramesWanted frames);

}  // namespace byhand::tutor
