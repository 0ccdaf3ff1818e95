#pragma once

#include "lessons/files/options.hpp"
#include "lessons/page/lesson.hpp"

namespace byhand::course {

/// Exit status of a lesson whose reader asks for the menu of the course.
inline constexpr int back_to_menu = 4;

/// Runs the lesson interactively, step by step, at a terminal. Returns the exit status.
int run_dialogue(Lesson& lesson, const Options& options);

}  // namespace byhand::course
