#pragma once

#include "renderer/image.hpp"
#include "renderer/opengl/pixel_canvas.hpp"
#include "renderer/svg_canvas.hpp"

namespace byhand::renderer {

/// What a window of a page shows, drawn on a canvas of the page's shape that may have fewer pixels.
Image space_image(PixelCanvas& canvas, const SvgCanvas::Window& window, const PageSize& page, Colour paper);

}  // namespace byhand::renderer
