#pragma once

#include <string>

#include "renderer/svg_canvas.hpp"

namespace byhand::renderer {

/// A scene in space as a PNG file. Throws Unavailable without OpenGL.
std::string space_picture(const SvgCanvas::Window& window, const PageSize& page, Colour paper);

/// The same as an address that holds it, for an SvgCanvas whose picture is one file.
std::string space_picture_url(const SvgCanvas::Window& window, const PageSize& page, Colour paper);

}  // namespace byhand::renderer
