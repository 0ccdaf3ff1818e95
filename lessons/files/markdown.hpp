#pragma once

#include <string>
#include <vector>

#include "lessons/files/options.hpp"
#include "lessons/page/recording.hpp"

namespace byhand::course {

/// lesson.md: the lesson in Markdown with formulas in LaTeX, answers folded, and links to the pictures beside it.
/// A sequence without frames is its caption alone.
std::string markdown(const Lesson& lesson, const std::vector<RecordedStep>& steps, FramesWanted frames);

}  // namespace byhand::course
