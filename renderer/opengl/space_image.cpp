#include "renderer/opengl/space_image.hpp"

namespace byhand::renderer {

Image space_image(PixelCanvas& canvas, const SvgCanvas::Window& window, const PageSize& page, Colour paper) {
  canvas.clear(paper);
  canvas.draw(window.scene);
  const Image whole = canvas.image();
  const auto pixels = [&](int points) { return points * whole.height / page.height; };
  const PixelBox& frame = window.frame;
  const int left = pixels(frame.x), right = pixels(frame.x + frame.width);
  const int top = pixels(frame.y), bottom = pixels(frame.y + frame.height);
  Image part{right - left, bottom - top, {}};
  for (int y = top; y < bottom; ++y)
    part.rgb.insert(part.rgb.end(), whole.pixel(left, y), whole.pixel(left, y) + 3 * part.width);
  return part;
}

}  // namespace byhand::renderer
