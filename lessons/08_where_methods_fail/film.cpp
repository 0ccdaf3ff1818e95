#include "lessons/08_where_methods_fail/film.hpp"

namespace byhand::failures {

void draw_cell(renderer::Canvas& canvas, const renderer::Rectangle& cell, const renderer::Rectangle& view,
               int number, const std::string& name, const std::string& words, bool failed,
               const std::function<void()>& draw) {
  namespace palette = renderer::palette;
  const double middle = cell.centre().x();
  canvas.text({middle, cell.top() - 15}, name, {.size = 20, .colour = palette::series(number), .bold = true});
  const renderer::Rectangle window{cell.x, cell.y + 32, cell.width, cell.height - 66};
  canvas.clip(window);
  canvas.look(fit(view, window, 4));
  draw();
  canvas.clip({});
  canvas.look_at_page();
  renderer::TextStyle style{.size = 18, .colour = failed ? palette::error : palette::muted, .bold = failed};
  style.size *= std::min(1.0, cell.width / canvas.measure({0, 0}, words, style).width);
  canvas.text({middle, cell.y + 14}, words, style);
}

}  // namespace byhand::failures
