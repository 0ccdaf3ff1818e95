#pragma once

#include <string>

#include "lessons/page/items.hpp"
#include "renderer/svg_canvas.hpp"

namespace byhand::site {

/// A picture as an SVG element, `width` × 720 points, whose ids begin with `name`. `draw_window` draws what is in
/// space (see SvgCanvas).
std::string drawn(const std::string& name, const course::Drawing& drawing,
                  const renderer::SvgCanvas::DrawWindow& draw_window = {}, int width = 1280);
std::string drawn(const course::Figure& figure, const renderer::SvgCanvas::DrawWindow& draw_window = {});

}  // namespace byhand::site
