#pragma once

#include <memory>
#include <string>

namespace byhand::renderer {

/// An OpenGL 3.3 core context without a window. Which library makes it (OSMesa or EGL) is chosen when CMake
/// configures, BYHAND_GL=osmesa|egl: both export the same functions, so a program links one of them.
class Context {
 public:
  /// Throws EnvironmentError when the context cannot be made.
  static std::unique_ptr<Context> make();
  virtual ~Context() = default;
  /// Directs the calling thread's OpenGL to this context.
  virtual void make_current() = 0;
  /// "OSMesa" or "EGL".
  virtual const char* name() const = 0;
};

/// OpenGL's renderer and version and how the context is made:
/// "llvmpipe (LLVM 15.0.6, 128 bits), OpenGL 4.5 (Core Profile) Mesa 22.3.6, OSMesa".
std::string describe(Context& context);

}  // namespace byhand::renderer
