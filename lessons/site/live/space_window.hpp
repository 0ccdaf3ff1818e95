#pragma once

#include "renderer/svg_canvas.hpp"

namespace byhand::site {

/// What draws scenes in space into the pictures of this page; none for a lesson in the plane.
renderer::SvgCanvas::DrawWindow space_window();

}  // namespace byhand::site
