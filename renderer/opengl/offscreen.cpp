#include "renderer/opengl/offscreen.hpp"

#include <fmt/format.h>

#include "renderer/opengl/gl.hpp"

namespace byhand::renderer {

std::string describe(Context& context) {
  context.make_current();
  const auto text = [](GLenum name) { return reinterpret_cast<const char*>(glGetString(name)); };
  return fmt::format("{}, OpenGL {}, {}", text(GL_RENDERER), text(GL_VERSION), context.name());
}

}  // namespace byhand::renderer
