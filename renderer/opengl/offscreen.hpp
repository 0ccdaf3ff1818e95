#pragma once

#include <memory>
#include <string>

namespace byhand::renderer {

/// An OpenGL 3.3 core context without a window. CMake chooses the library that creates it, BYHAND_GL=osmesa|egl;
/// both export the same functions, so a program links one of them.
class Context {
 public:
  /// Throws Unavailable if the context cannot be created. Where no threads can be started for it, as under a
  /// limit on processes, it draws without any.
  static std::unique_ptr<Context> make();
  virtual ~Context() = default;
  /// Makes this the calling thread's current context.
  virtual void make_current() = 0;
  /// "OSMesa" or "EGL".
  virtual const char* name() const = 0;

 private:
  /// What the library of the context offers.
  static std::unique_ptr<Context> offered();
};

/// OpenGL's renderer, its version and the library of the context:
/// "llvmpipe (LLVM 15.0.6, 128 bits), OpenGL 4.5 (Core Profile) Mesa 22.3.6, OSMesa".
std::string describe(Context& context);

}  // namespace byhand::renderer
