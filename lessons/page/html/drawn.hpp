#pragma once

#include <string>
#include <string_view>

#include "lessons/page/items.hpp"
#include "renderer/svg_canvas.hpp"

namespace byhand::site {

/// Widths of a picture [points]: on a screen, and on a phone, where letters of 14 points are 11 pixels high.
inline constexpr int wide = 1280, narrow = 490;

/// A picture as an SVG element, `width` × 720 points or lower, whose ids begin with `name`. `draw_window` draws
/// what is in space (see SvgCanvas).
std::string drawn(const std::string& name, const course::Drawing& drawing,
                  const renderer::SvgCanvas::DrawWindow& draw_window = {}, int width = wide);
std::string drawn(const course::Figure& figure, const renderer::SvgCanvas::DrawWindow& draw_window = {},
                  int width = wide);

/// Whether all letters of a picture are as large as a phone's need to be. A table's are not: it stays wide.
bool is_legible(std::string_view svg);

}  // namespace byhand::site
