#include "lessons/page/html/drawn.hpp"

#include <cstdlib>

namespace byhand::site {
namespace {

/// Writes into the windows of scenes in space why they are empty.
void explain_empty_windows(renderer::SvgCanvas& canvas) {
  canvas.clip(std::nullopt);
  canvas.look_at_page();
  for (const auto& [scene, frame] : canvas.windows())
    canvas.text({frame.x + frame.width / 2.0, canvas.height() - frame.y - frame.height / 2.0},
                "This browser has no WebGL,\nwhich draws what is in space.", {.size = 16});
}

}  // namespace

std::string drawn(const std::string& name, const course::Drawing& drawing,
                  const renderer::SvgCanvas::DrawWindow& draw_window, int width) {
  renderer::SvgCanvas canvas(width, name, draw_window);
  drawing(canvas);
  if (!draw_window) explain_empty_windows(canvas);
  return canvas.svg("");
}

std::string drawn(const course::Figure& figure, const renderer::SvgCanvas::DrawWindow& draw_window, int width) {
  const auto draw = [&](renderer::Canvas& canvas) {
    if (const auto* chart = course::chart_of(figure))
      renderer::draw(canvas, *chart, canvas.page(0.9).inset(12));
    else
      std::get<course::Drawing>(figure.picture)(canvas);
  };
  return drawn(figure.name, draw, draw_window, width);
}

bool is_legible(std::string_view svg) {
  constexpr double least = 12.5;  // points
  constexpr std::string_view size = " font-size=\"";
  for (auto at = svg.find(size); at != std::string_view::npos; at = svg.find(size, at + 1)) {
    const bool subscript = svg.substr(svg.rfind('<', at)).starts_with("<tspan");
    if (!subscript && std::strtod(svg.data() + at + size.size(), nullptr) < least) return false;
  }
  return true;
}

}  // namespace byhand::site
