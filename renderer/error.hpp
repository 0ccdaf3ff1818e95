#pragma once

#include <stdexcept>

namespace byhand::renderer {

/// OpenGL, a font or memory that drawing needs is missing. `what()` is one sentence with the cause and, if there
/// is one, the remedy.
struct Unavailable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace byhand::renderer
