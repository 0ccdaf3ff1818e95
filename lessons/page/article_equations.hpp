#pragma once

#include "lessons/page/words.hpp"

namespace byhand::course {

/// The article's equations are (1) to this one.
inline constexpr int article_equations = 23;

/// Equation `number` exactly as the article prints it, inaccuracies included. Throws LessonError unless
/// 1 ≤ number ≤ 23.
const Formula& article_equation(int number);

}  // namespace byhand::course
