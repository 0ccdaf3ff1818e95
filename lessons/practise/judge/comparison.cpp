#include "lessons/practise/judge/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace byhand::practise {
namespace {

using namespace renderer;

Point point(Vec2 a) { return {a.x, a.y}; }

int count(const Film& film) { return static_cast<int>(film.frames.size()); }

/// A text that is made smaller where it would be wider than `width` points.
void fitted_text(Canvas& canvas, const Point& at, double width, const std::string& text, TextStyle style) {
  style.size *= std::min(1.0, width / canvas.measure({0, 0}, text, style).width);
  canvas.text(at, text, style);
}

void draw(Canvas& canvas, const Shape& shape) {
  switch (shape.kind) {
    case Shape::bob: canvas.disc(point(shape.at), shape.to.x); break;
    case Shape::rod: canvas.rod(point(shape.at), point(shape.to)); break;
    case Shape::box: canvas.box(point(shape.at), point(shape.to), shape.angle); break;
    case Shape::anchor: canvas.anchor(point(shape.at)); break;
    case Shape::ground: canvas.ground(point(shape.at), point(shape.to)); break;
  }
}

bool is_body(const Shape& shape) { return shape.kind == Shape::bob || shape.kind == Shape::box; }

/// All that moves or holds in the right run, with half a metre around it.
Rectangle window_of(const Film& right) {
  std::vector<Point> seen;
  for (const Frame& frame : right.frames)
    for (const Shape& shape : frame.shapes) {
      if (shape.kind == Shape::ground) continue;
      const double reach = shape.kind == Shape::bob   ? shape.to.x
                           : shape.kind == Shape::box ? length(shape.to) / 2
                                                      : 0;
      for (const double side : {-reach, reach}) seen.push_back(point(shape.at) + Point(side, side));
      if (shape.kind == Shape::rod) seen.push_back(point(shape.to));
    }
  return bounds(seen).inset(-0.5);
}

/// Since which frame the film's body `shape` has been outside what is seen; −1 if it is inside.
int gone_since(const Film& film, std::size_t shape, int index, const Rectangle& seen) {
  int since = -1;
  for (int i = index; i >= 0; --i) {
    const Shape& body = film.frames[static_cast<std::size_t>(i)].shapes[shape];
    if (seen.contains(point(body.at))) break;
    since = i;
  }
  return since;
}

/// An arrow at the frame's edge towards each body that has left it, and since when.
void draw_gone(Canvas& canvas, const Rectangle& body, const Camera& camera, const Film& film, int index) {
  const Rectangle inner = body.inset(10);
  const Point low = camera.to_world({body.x, body.y}), high = camera.to_world({body.right(), body.top()});
  const Rectangle seen{low.x(), low.y(), high.x() - low.x(), high.y() - low.y()};
  const Frame& frame = film.frames[static_cast<std::size_t>(index)];
  int first = -1;
  for (std::size_t i = 0; i < frame.shapes.size(); ++i) {
    if (!is_body(frame.shapes[i])) continue;
    const int since = gone_since(film, i, index, seen);
    if (since < 0) continue;
    first = first < 0 ? since : std::min(first, since);
    const Point away = camera.to_page(point(frame.shapes[i].at)) - inner.centre();
    if (!away.allFinite()) continue;
    const double reach = std::max(std::abs(away.x()) / inner.width, std::abs(away.y()) / inner.height);
    const Point tip = inner.centre() + 0.5 / reach * away;
    canvas.arrow(tip - 44 * away.normalized(), tip, {palette::error, 4});
  }
  if (first < 0) return;
  fitted_text(canvas, {body.centre().x(), body.y + 20}, body.width - 12,
              fmt::format("left the picture at {:.1f} s", double(first) / frames_per_second),
              {.size = 18, .colour = palette::error, .halo = 4});
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
  const int shown = std::min(index, count(film) - 1);
  const Frame& frame = film.frames[static_cast<std::size_t>(shown)];
  const Camera camera = fit(window_of(right), body, 4);
  canvas.clip(body);
  canvas.look(camera);
  for (const Shape& shape : frame.shapes) draw(canvas, shape);
  canvas.clip(std::nullopt);
  canvas.look_at_page();
  draw_gone(canvas, body, camera, film, shown);
  canvas.text({head.centre().x(), head.y + 0.66 * head.height}, title, {.size = 20, .bold = true});
  const double size = std::abs(frame.reading);
  const std::string number =
      fmt::format(fmt::runtime(1000 <= size && size < 1e6 ? "{:.0f}" : "{:.3g}"), frame.reading);
  const std::string reading = std::isfinite(size) ? number + " " + right.unit : "not a finite number";
  fitted_text(canvas, {head.centre().x(), head.y + 0.24 * head.height}, head.width,
              right.quantity + ": " + reading, {.size = 17, .colour = palette::error});
}

Rectangle below_title(Canvas& canvas, const std::string& title) {
  const auto [head, body] = canvas.page().inset(14).split_rows(0.06, 6);
  canvas.text(head.centre(), title, {.size = 22, .bold = true});
  return body;
}

}  // namespace

int frames_that_tell(const Film& film, const Film& right) {
  const Rectangle seen = window_of(right);
  int last = count(right);
  for (std::size_t i = 0; count(film) > 0 && i < film.frames[0].shapes.size(); ++i)
    if (const int since = gone_since(film, i, count(film) - 1, seen);
        since >= 0 && is_body(film.frames[0].shapes[i]))
      last = std::min(last, since + frames_per_second / 5);
  return last;
}

void draw(Canvas& canvas, const Film& yours, const Film& right, int index) {
  canvas.clear();
  const auto [left, other] =
      below_title(canvas, fmt::format("{}: {:.2f} s", right.title, double(index) / frames_per_second))
          .split_columns(0.5, 16);
  draw_panel(canvas, left, yours, right, index, "your code");
  draw_panel(canvas, other, right, right, index, "right");
}

void draw_instants(Canvas& canvas, const Film& yours, const Film& right, const std::vector<int>& instants) {
  canvas.clear();
  const auto cells = below_title(canvas, right.title).cells(2, 4, 10);
  for (std::size_t i = 0; i < instants.size(); ++i) {
    const double seconds = double(instants[i]) / frames_per_second;
    draw_panel(canvas, cells[i], yours, right, instants[i], fmt::format("your code, {:.2g} s", seconds));
    draw_panel(canvas, cells[4 + i], right, right, instants[i], fmt::format("right, {:.2g} s", seconds));
  }
}

}  // namespace byhand::practise
