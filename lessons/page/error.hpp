#pragma once

#include <stdexcept>

namespace byhand::course {

/// A mistake of the lesson's author: no claim, too many steps, a missing excerpt.
struct LessonError : std::logic_error {
  using std::logic_error::logic_error;
};

}  // namespace byhand::course
