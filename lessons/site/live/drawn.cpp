#include "lessons/site/live/drawn.hpp"

#include "lessons/site/markup.hpp"
#include "renderer/svg_canvas.hpp"

namespace byhand::site {
namespace {

constexpr int width = 1280;

}  // namespace

std::string drawn(const std::string& name, const std::string& caption, const std::string& words,
                  const tutor::Drawing& drawing) {
  renderer::SvgCanvas canvas(width, name);
  drawing(canvas);
  return canvas.svg(plain_text(caption), words);
}

std::string drawn(const tutor::Figure& figure, const std::string& words) {
  return drawn(figure.name, figure.caption, words, [&](renderer::Canvas& canvas) {
    if (const auto* chart = tutor::chart_of(figure))
      renderer::draw(canvas, *chart, canvas.page().inset(12));
    else
      std::get<tutor::Drawing>(figure.picture)(canvas);
  });
}

}  // namespace byhand::site
