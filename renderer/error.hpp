#pragma once

#include <stdexcept>

namespace byhand::renderer {

/// What the machine refuses: no OpenGL, a missing font, a full disk, a folder that cannot be written.
/// `what()` is one sentence that names the cause and, where there is one, the cure. A lesson ends with exit
/// status 3.
struct EnvironmentError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace byhand::renderer
