#include "lessons/site/drawn.hpp"

namespace byhand::site {

std::string drawn(const std::string& name, const tutor::Drawing& drawing,
                  const renderer::SvgCanvas::DrawWindow& draw_window, int width) {
  renderer::SvgCanvas canvas(width, name, draw_window);
  drawing(canvas);
  return canvas.svg("");
}

std::string drawn(const tutor::Figure& figure, const renderer::SvgCanvas::DrawWindow& draw_window) {
  const auto draw = [&](renderer::Canvas& canvas) {
    if (const auto* chart = tutor::chart_of(figure))
      renderer::draw(canvas, *chart, canvas.page().inset(12));
    else
      std::get<tutor::Drawing>(figure.picture)(canvas);
  };
  return drawn(figure.name, draw, draw_window);
}

}  // namespace byhand::site
