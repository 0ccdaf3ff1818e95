// Scenes in space by the browser's WebGL 2, whose functions the worker offers under OpenGL's names (webgl.js).

#include <algorithm>
#include <cstdint>
#include <optional>

#include "lessons/site/live/space_window.hpp"
#include "renderer/data_url.hpp"
#include "renderer/opengl/gl.hpp"
#include "renderer/opengl/offscreen.hpp"
#include "renderer/opengl/space_image.hpp"

__attribute__((import_module("page"), import_name("has_webgl"))) int has_webgl();

/// The worker returns numbers only, no text.
extern "C" const GLubyte* glGetString(GLenum) { return reinterpret_cast<const GLubyte*>("WebGL 2"); }

namespace byhand {
namespace {

class WebGl : public renderer::Context {
  void make_current() override {}
  const char* name() const override { return "WebGL 2"; }
};

/// An image as a BMP file, which costs no compression; browsers tell the format by the bytes.
std::string bitmap(const renderer::Image& image) {
  const std::uint32_t row = (3u * std::uint32_t(image.width) + 3) / 4 * 4,
                      size = row * std::uint32_t(image.height);
  std::string file = "BM";
  const auto put = [&](std::uint32_t number, int bytes) {
    for (int i = 0; i < bytes; ++i) file += static_cast<char>(number >> (8 * i) & 0xff);
  };
  put(54 + size, 4), put(0, 4), put(54, 4);  // sizes of the file, nothing, of the headers
  put(40, 4), put(std::uint32_t(image.width), 4), put(std::uint32_t(image.height), 4);
  put(1, 2), put(24, 2), put(0, 4), put(size, 4), put(2835, 4), put(2835, 4), put(0, 8);
  for (int y = image.height - 1; y >= 0; --y) {
    for (int x = 0; x < image.width; ++x) {
      const auto* rgb = image.pixel(x, y);
      for (const int channel : {2, 1, 0}) file += static_cast<char>(rgb[channel]);
    }
    file.append(row - 3u * std::uint32_t(image.width), '\0');
  }
  return file;
}

/// Draws with one pixel for `shrink` × `shrink` of the page's.
template <int shrink>
std::string draw(const renderer::SvgCanvas::Window& window, const renderer::PageSize& page,
                 renderer::Colour paper) {
  static std::optional<renderer::PixelCanvas> canvas;
  const renderer::PageSize size(page.width / shrink, page.height / shrink);
  if (!canvas || canvas->width() != size.width) canvas.emplace(size.width, size.height);
  return renderer::data_url(bitmap(renderer::space_image(*canvas, window, page, paper)));
}

}  // namespace

std::unique_ptr<renderer::Context> renderer::Context::make() { return std::make_unique<WebGl>(); }

site::DrawWindows site::space_windows() {
  if (has_webgl()) return {draw<1>, draw<4>};
  return {};
}

}  // namespace byhand
