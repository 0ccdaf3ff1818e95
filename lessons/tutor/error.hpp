#pragma once

#include <stdexcept>

namespace byhand::tutor {

/// A lesson that is written wrongly: no claim, too many steps, an excerpt that does not exist. The reader is
/// not to blame.
struct LessonError : std::logic_error {
  using std::logic_error::logic_error;
};

}  // namespace byhand::tutor
