#include "renderer/opengl/space_picture.hpp"

#include <algorithm>

#include "renderer/data_url.hpp"
#include "renderer/opengl/pixel_canvas.hpp"
#include "renderer/png.hpp"

namespace byhand::renderer {

std::string space_picture(const SvgCanvas::Window& window, const PageSize& page, Colour paper) {
  PixelCanvas canvas(page.width, page.height);
  canvas.clear(paper);
  canvas.draw(window.scene);
  const Image whole = canvas.image();
  const PixelBox& frame = window.frame;
  Image part{frame.width, frame.height, {}};
  for (int y = frame.y; y < frame.y + frame.height; ++y)
    part.rgb.insert(part.rgb.end(), whole.pixel(frame.x, y), whole.pixel(frame.x, y) + 3 * frame.width);
  return encode_png(part, Compression::thorough);
}

std::string space_picture_url(const SvgCanvas::Window& window, const PageSize& page, Colour paper) {
  return data_url(space_picture(window, page, paper));
}

}  // namespace byhand::renderer
