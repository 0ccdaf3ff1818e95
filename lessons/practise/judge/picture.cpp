#include "lessons/practise/judge/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "renderer/frames.hpp"
#include "renderer/opengl/pixel_canvas.hpp"
#include "renderer/png.hpp"

namespace byhand::practise {
namespace {

using namespace renderer;

Point point(Vec2 a) { return {a.x, a.y}; }

void draw(Canvas& canvas, const Shape& shape) {
  switch (shape.kind) {
    case Shape::bob: canvas.disc(point(shape.at), shape.to.x); break;
    case Shape::rod: canvas.rod(point(shape.at), point(shape.to)); break;
    case Shape::box: canvas.box(point(shape.at), point(shape.to), shape.angle); break;
    case Shape::anchor: canvas.anchor(point(shape.at)); break;
    case Shape::ground: canvas.ground(point(shape.at), point(shape.to)); break;
  }
}

/// One film at one instant, in its part of the page.
void draw_panel(Canvas& canvas, const Rectangle& place, const Film& film, const Film& right, int index,
                const std::string& title) {
  const auto [head, body] = place.split_rows(0.16, 0);
  canvas.look_at_page();
  canvas.rectangle(body, {palette::paper, {palette::grid, 1.5}});
  if (film.frames.empty()) {
    canvas.text(body.centre(), "nothing to see", {.colour = palette::muted});
    return;
  }
  const int last = static_cast<int>(film.frames.size()) - 1;
  const Frame& frame = film.frames[static_cast<std::size_t>(std::min(index, last))];
  const double width = right.height * body.width / body.height;
  canvas.clip(body);
  canvas.look(fit({right.middle.x - width / 2, right.middle.y - right.height / 2, width, right.height}, body, 4));
  for (const Shape& shape : frame.shapes) draw(canvas, shape);
  canvas.clip(std::nullopt);
  canvas.look_at_page();
  canvas.text({head.centre().x(), head.y + 0.66 * head.height}, title, {.size = 20, .bold = true});
  const double size = std::abs(frame.reading);
  const std::string number =
      fmt::format(fmt::runtime(1000 <= size && size < 1e6 ? "{:.0f}" : "{:.3g}"), frame.reading);
  const std::string reading = std::isfinite(size) ? number + " " + right.unit : "not a finite number";
  canvas.text({head.centre().x(), head.y + 0.24 * head.height}, right.quantity + ": " + reading,
              {.size = 17, .colour = palette::error});
}

int count(const Film& right) { return static_cast<int>(right.frames.size()); }

Rectangle below_title(Canvas& canvas, const std::string& title) {
  const auto [head, body] = canvas.page().inset(14).split_rows(0.06, 6);
  canvas.text(head.centre(), title, {.size = 22, .bold = true});
  return body;
}

}  // namespace

void draw(Canvas& canvas, const Film& yours, const Film& right, int index) {
  canvas.clear();
  const auto [left, other] =
      below_title(canvas, fmt::format("{}: {:.2f} s", right.title, double(index) / frames_per_second))
          .split_columns(0.5, 16);
  draw_panel(canvas, left, yours, right, index, "your code");
  draw_panel(canvas, other, right, right, index, "right");
}

std::string still_png(const Film& yours, const Film& right) {
  PixelCanvas canvas(1280, 720);
  canvas.clear();
  const std::vector<int> instants = spread(count(right), 4);
  const auto cells = below_title(canvas, right.title).cells(2, 4, 10);
  for (std::size_t i = 0; i < instants.size(); ++i) {
    const double seconds = double(instants[i]) / frames_per_second;
    draw_panel(canvas, cells[i], yours, right, instants[i], fmt::format("your code, {:.1f} s", seconds));
    draw_panel(canvas, cells[4 + i], right, right, instants[i], fmt::format("right, {:.1f} s", seconds));
  }
  return encode_png(canvas.image());
}

void write_film(const std::filesystem::path& folder, const Film& yours, const Film& right) {
  PixelCanvas canvas(854, 480);
  FrameWriter writer(folder);
  for (int i = 0; i < count(right); ++i) {
    draw(canvas, yours, right, i);
    writer.write(canvas.image());
  }
  writer.finish();
}

}  // namespace byhand::practise
