#pragma once

#include "lessons/tutor/words.hpp"

namespace byhand::tutor {

/// Formula `number` of the article as it stands there, loose ones included. Throws LessonError unless 1 ≤
/// number ≤ 23.
const Formula& article_equation(int number);

}  // namespace byhand::tutor
