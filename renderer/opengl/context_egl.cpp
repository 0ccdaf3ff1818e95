#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "renderer/error.hpp"
#include "renderer/opengl/offscreen.hpp"

namespace byhand::renderer {
namespace {

class Egl : public Context {
 public:
  Egl() {
    display_ = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display_ == EGL_NO_DISPLAY || !eglInitialize(display_, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API))
      throw Unavailable("EGL offers no OpenGL without a window: apt install libegl-mesa0.");
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 3,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 3,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_NONE};
    context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (context_ == EGL_NO_CONTEXT)
      throw Unavailable("EGL offers no OpenGL 3.3 core context: apt install libegl-mesa0.");
    make_current();
  }
  Egl(const Egl&) = delete;
  Egl& operator=(const Egl&) = delete;
  // All contexts of the process share the display, so it is not terminated here.
  ~Egl() override {
    if (eglGetCurrentContext() == context_)
      eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
  }

  void make_current() override {
    if (eglGetCurrentContext() == context_) return;
    if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
      throw Unavailable("EGL's OpenGL context cannot be made current.");
  }

  const char* name() const override { return "EGL"; }

 private:
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<Context> Context::offered() { return std::make_unique<Egl>(); }

}  // namespace byhand::renderer
