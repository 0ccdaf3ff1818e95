#include "renderer/opengl/space_picture.hpp"

#include "renderer/data_url.hpp"
#include "renderer/opengl/space_image.hpp"
#include "renderer/png.hpp"

namespace byhand::renderer {

std::string space_picture(const SvgCanvas::Window& window, const PageSize& page, Colour paper) {
  PixelCanvas canvas(page.width, page.height);
  return encode_png(space_image(canvas, window, page, paper), Compression::thorough);
}

std::string space_picture_url(const SvgCanvas::Window& window, const PageSize& page, Colour paper) {
  return data_url(space_picture(window, page, paper));
}

}  // namespace byhand::renderer
