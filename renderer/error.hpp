#pragma once

#include <stdexcept>

namespace byhand::renderer {

/// A failure of the environment: no OpenGL, a missing font, a full disk, a folder that is not writable. `what()`
/// is one sentence with the cause and, if there is one, the remedy. A lesson then exits with status 3.
struct EnvironmentError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace byhand::renderer
