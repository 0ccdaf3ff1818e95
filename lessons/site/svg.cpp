#include "lessons/site/svg.hpp"

#include "lessons/site/alternative.hpp"
#include "lessons/site/markup.hpp"
#include "renderer/opengl/space_picture.hpp"
#include "renderer/svg_canvas.hpp"

namespace byhand::site {
namespace {

constexpr int width = 1280;

renderer::SvgCanvas canvas(const std::string& name) {
  return renderer::SvgCanvas(width, name, renderer::space_picture);
}

}  // namespace

std::string svg(const tutor::Figure& figure) {
  renderer::SvgCanvas page = canvas(figure.name);
  if (const auto* chart = tutor::chart_of(figure))
    renderer::draw(page, *chart, page.page().inset(12));
  else
    std::get<tutor::Drawing>(figure.picture)(page);
  return page.svg(plain_text(figure.caption), plain_text(alternative(figure)));
}

std::string svg(const tutor::Sequence& film, double time) {
  renderer::SvgCanvas page = canvas(film.name);
  tutor::FrameDrawing draw = film.draw;
  draw(page, time);
  return page.svg(plain_text(film.caption), plain_text(alternative(film)));
}

}  // namespace byhand::site
