#include <GL/osmesa.h>

#include <array>
#include <cstdlib>
#include <string_view>

#include "renderer/error.hpp"
#include "renderer/opengl/offscreen.hpp"

#if defined(__SANITIZE_ADDRESS__)
#define BYHAND_LEAKS_ARE_REPORTED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define BYHAND_LEAKS_ARE_REPORTED
#endif
#endif
#ifdef BYHAND_LEAKS_ARE_REPORTED
// OSMesa never frees some of its memory.
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa\n"; }
#endif

namespace byhand::renderer {
namespace {

class OSMesa : public Context {
 public:
  OSMesa() {
    // Mesa crashes on a driver that it does not have.
    const char* const driver = std::getenv("GALLIUM_DRIVER");
    const std::string_view wanted = driver ? driver : "";
    if (!wanted.empty() && wanted != "llvmpipe" && wanted != "softpipe")
      throw Unavailable(
          "The environment sets GALLIUM_DRIVER, but not to llvmpipe or softpipe, with which OSMesa "
          "draws: unset GALLIUM_DRIVER.");
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              0,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              3,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              3,
                              0};
    context_ = OSMesaCreateContextAttribs(attributes, nullptr);
    if (!context_) throw Unavailable("OSMesa offers no OpenGL 3.3 core context: apt install libosmesa6.");
    make_current();
  }
  OSMesa(const OSMesa&) = delete;
  OSMesa& operator=(const OSMesa&) = delete;
  ~OSMesa() override { OSMesaDestroyContext(context_); }

  void make_current() override {
    if (OSMesaGetCurrentContext() == context_) return;
    if (!OSMesaMakeCurrent(context_, unused_.data(), GL_UNSIGNED_BYTE, side, side))
      throw Unavailable("OSMesa's OpenGL context cannot be made current.");
  }

  const char* name() const override { return "OSMesa"; }

 private:
  // OSMesa requires a default framebuffer. Its pixels differ from EGL's, so nothing is drawn into it.
  static constexpr int side = 16;
  std::array<unsigned char, 4 * side * side> unused_{};
  OSMesaContext context_ = nullptr;
};

}  // namespace

std::unique_ptr<Context> Context::offered() { return std::make_unique<OSMesa>(); }

}  // namespace byhand::renderer
