#pragma once

#include "lessons/tutor/lesson.hpp"
#include "lessons/tutor/options.hpp"

namespace byhand::tutor {

/// Runs the lesson interactively, step by step, at a terminal. Returns the exit status.
int run_dialogue(Lesson& lesson, const Options& options);

}  // namespace byhand::tutor
