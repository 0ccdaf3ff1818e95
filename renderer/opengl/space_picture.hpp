#pragma once

#include <string>

#include "renderer/svg_canvas.hpp"

namespace byhand::renderer {

/// A scene in space as a PNG file, for SvgCanvas. Throws Unavailable without OpenGL.
std::string space_picture(const SvgCanvas::Window& window, const PageSize& page, Colour paper);

}  // namespace byhand::renderer
