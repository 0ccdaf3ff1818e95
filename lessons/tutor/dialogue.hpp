#pragma once

#include "lessons/tutor/lesson.hpp"
#include "lessons/tutor/options.hpp"

namespace byhand::tutor {

/// The lesson step by step with a reader at the terminal. Returns the exit status.
int run_dialogue(Lesson& lesson, const Options& options);

}  // namespace byhand::tutor
