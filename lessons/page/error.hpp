#pragma once

#include <stdexcept>

namespace byhand::course {

/// A mistake of the lesson's author: no claim, too many steps, a missing excerpt.
struct LessonError : std::logic_error {
  using std::logic_error::logic_error;
};

/// A failure of the environment: a full disk, a folder that is not writable, a missing program. `what()` is one
/// sentence with the cause and, if there is one, the remedy. A lesson then exits with status 3.
struct EnvironmentError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace byhand::course
