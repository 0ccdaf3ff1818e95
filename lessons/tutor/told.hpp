#pragma once

#include <string>
#include <vector>

#include "lessons/tutor/lesson.hpp"

namespace byhand::tutor {

/// A step and what it recorded with the present parameters.
struct Told {
  const Step* step;
  Page page;
};

/// Runs the step and looks its page over: at the default parameters two answers of a question that lie within
/// its tolerance are a LessonError; at others the wrong one is dropped.
Told tell(const Lesson& lesson, const Step& step, bool quiet);

/// Throws LessonError unless there is a claim and every picture has a name of its own. `lesson` is wholly
/// told.
void require_whole(const std::vector<Told>& lesson);

std::vector<Claim> claims(const Page& page);

}  // namespace byhand::tutor
