#include "renderer/canvas.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "renderer/drawing_surface.hpp"
#include "renderer/outline.hpp"
#include "renderer/space.hpp"
#include "renderer/ticks.hpp"

namespace byhand::renderer {
namespace {

constexpr double page_height = 720;  // points
constexpr double cap_height = 0.73;  // of DejaVu's capitals, in sizes
constexpr double descent = 0.22, line_height = 1.3;

Point turned(const Point& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

Point unit_or(const Point& v, const Point& otherwise) { return v.norm() > 0 ? Point(v.normalized()) : otherwise; }

// Position of the anchor in the box of a text, 0 … 1 from the lower left.
Point share(Anchor anchor) {
  switch (anchor) {
    case Anchor::centre: return {0.5, 0.5};
    case Anchor::left: return {0, 0.5};
    case Anchor::right: return {1, 0.5};
    case Anchor::top: return {0.5, 1};
    case Anchor::bottom: return {0.5, 0};
    case Anchor::top_left: return {0, 1};
    case Anchor::top_right: return {1, 1};
    case Anchor::bottom_left: return {0, 0};
    case Anchor::bottom_right: return {1, 0};
  }
  return {0.5, 0.5};
}

std::array<Point, 4> corners(const Point& centre, const Point& half, double angle) {
  return {centre + turned({-half.x(), -half.y()}, angle), centre + turned({half.x(), -half.y()}, angle),
          centre + turned({half.x(), half.y()}, angle), centre + turned({-half.x(), half.y()}, angle)};
}

struct TextBlock {
  std::vector<std::string_view> lines;
  std::vector<double> widths;  // points
  Rectangle box;               // points on the page
  double letters;  // height of the lines from the last baseline to the top of the first line's capitals
};

TextBlock lay_out(const DrawingSurface& surface, double scale, const Point& at, std::string_view text,
                  const TextStyle& style) {
  TextBlock block;
  double width = 0;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    block.lines.push_back(text.substr(begin, end - begin));
    block.widths.push_back(surface.text_width(block.lines.back(), style.size * scale, style.bold) / scale);
    width = std::max(width, block.widths.back());
    begin = end + 1;
  }
  block.letters = (cap_height + line_height * double(block.lines.size() - 1)) * style.size;
  const double height = block.letters + descent * style.size;
  const Point held = share(style.anchor), corner = at + style.offset;
  // Vertically, the capitals are centred, without the descenders.
  const auto begin = [&](double where, double extent) {
    return where == 0.5 ? -extent + block.letters / 2 : -where * extent;
  };
  if (style.upright)
    block.box = {corner.x() - held.x() * width, corner.y() + begin(held.y(), height), width, height};
  else
    block.box = {corner.x() - height - begin(1 - held.x(), height), corner.y() - held.y() * width, height, width};
  return block;
}

/// A line with breaks at its blanks, so that each part `fits`, if its words do.
template <class Fits>
std::string broken(std::string line, const Fits& fits) {
  std::size_t begin = 0, blank = 0;
  for (std::size_t i = 1; i <= line.size(); ++i) {
    if (i < line.size() && line[i] != ' ') continue;
    if (blank > begin && !fits(std::string_view(line).substr(begin, i - begin))) {
      line[blank] = '\n';
      begin = blank + 1;
    }
    blank = i;
  }
  return line;
}

}  // namespace

Mark series_mark(int i) {
  static constexpr std::array<Mark, 8> marks{Mark::disc,          Mark::square,      Mark::triangle,
                                             Mark::diamond,       Mark::circle,      Mark::open_square,
                                             Mark::open_triangle, Mark::open_diamond};
  return marks[std::size_t(i % 8 + 8) % 8];
}

// The members work in pixels, y down.
struct Canvas::State {
  State(const PageSize& size, std::unique_ptr<DrawingSurface> surface_)
      : width(size.width), height(size.height), scale(height / page_height), surface(std::move(surface_)) {}

  Rectangle page() const { return {0, bottom, width / scale, page_height - bottom}; }
  Point pixel(const Point& page_point) const { return {page_point.x() * scale, height - page_point.y() * scale}; }
  Point seen(const Point& world) const { return pixel(camera.to_page(world)); }
  std::vector<Point> seen(std::span<const Point> world) const {
    std::vector<Point> pixels;
    pixels.reserve(world.size());
    for (const Point& p : world) pixels.push_back(seen(p));
    return pixels;
  }
  PixelBox box(const Rectangle& r) const {
    const auto pixel_of = [](double v, int most) { return int(std::lround(std::clamp(v, 0.0, double(most)))); };
    const int left = pixel_of(r.x * scale, width), right = pixel_of(r.right() * scale, width);
    const int upper = pixel_of(height - r.top() * scale, height), lower = pixel_of(height - r.y * scale, height);
    return {left, upper, right - left, lower - upper};
  }
  Rectangle reach(double margin) const {
    return Rectangle{double(clip.x), double(clip.y), double(clip.width), double(clip.height)}.inset(-margin);
  }

  void restart() {
    surface->clear(paper);
    labels.clear();
    bottom = 0;
    camera = {page(), page().centre(), 1};
    clip = {0, 0, width, height};
  }

  Pen pen(const Stroke& style) const {
    Pen pen{style.colour, style.width * scale};
    if (style.dash == Dash::dashed) pen.on = 9 * scale, pen.off = 5.5 * scale;
    if (style.dash == Dash::dotted) pen.on = 2 * scale, pen.off = 5 * scale;
    return pen;
  }

  // `fading`: opacity from zero at the first point to one at the last.
  void draw_stroke(std::span<const Point> pixels, const Stroke& style, bool fading = false) {
    Pen with = pen(style);
    if (with.width <= 0) return;
    const std::vector<std::vector<Point>> runs = clipped(pixels, reach(with.width + 2));
    double whole = 0, done = 0;
    for (const std::vector<Point>& run : runs) whole += length(run);
    for (const std::vector<Point>& run : runs) {
      if (fading) {
        with.opacity_at_start = done / whole;
        done += length(run);
        with.opacity_at_end = done / whole;
      }
      surface->path(run, with);
    }
  }

  void draw_shape(std::span<const Point> pixels, const Look& look, bool sharp = false) {
    for (const Point& p : pixels)
      if (!p.allFinite()) return;
    surface->polygon(pixels, look.fill, pen(look.edge), sharp);
  }

  void draw_fill(std::span<const Point> pixels, Colour colour) { draw_shape(pixels, {colour, {colour, 0}}); }

  void draw_disc(const Point& centre, double radius, const Look& look) {
    if (centre.allFinite() && radius > 0 && std::isfinite(radius))
      surface->disc(centre, radius, look.fill, pen(look.edge));
  }

  void draw_arrow(const Point& tail, const Point& tip, const Stroke& style) {
    const Point way = tip - tail;
    const double length = way.norm(), w = style.width * scale;
    if (!way.allFinite()) return;
    if (length < 0.75 * w) return draw_disc(tip, 1.2 * w, {style.colour, {style.colour, 0}});
    const Point ahead = way / length;
    // A short arrow keeps its shape: its head is at most 60 % of the length.
    const double head = std::min(5.2 * w, 0.6 * length), half = 0.38 * head;
    const Point neck = tip - head * ahead;
    const std::array<Point, 2> shaft{tail, neck + 0.3 * head * ahead};
    draw_stroke(shaft, {style.colour, std::min(style.width, 0.36 * head / scale), style.dash});
    draw_fill(std::array<Point, 3>{tip, neck + half * left_of(ahead), neck - half * left_of(ahead)}, style.colour);
  }

  // Short oblique strokes on the right of the line from `a` to `b`.
  void draw_hatching(const Point& a, const Point& b) {
    const double spacing = 9 * scale, depth = 9 * scale;
    const Point ahead = unit_or(b - a, {1, 0});
    const Point lean = depth * (left_of(ahead) - 0.8 * ahead);  // left with y down is right with y up
    for (const std::vector<Point>& run : clipped(std::array<Point, 2>{a, b}, reach(2 * depth)))
      for (double s = 0.9 * spacing; s <= length(run); s += spacing)
        draw_stroke(std::array<Point, 2>{run.front() + s * ahead, run.front() + s * ahead + lean},
                    {palette::muted, 1.2});
  }

  int width, height;
  double scale;       // pixels per point
  double bottom = 0;  // of the page [points]
  std::unique_ptr<DrawingSurface> surface;
  Camera camera;
  PixelBox clip;
  Colour paper = palette::paper;
  bool lists_labels = false;
  std::vector<Label> labels;
};

PageSize::PageSize(int width_, int height_) : width(width_), height(height_) {
  constexpr int least = 16, most = 8192;
  if (std::min(width, height) < least || std::max(width, height) > most)
    throw std::invalid_argument(
        fmt::format("A page has {} to {} pixels on each side; got {} × {}.", least, most, width, height));
}

Canvas::Canvas(const PageSize& size, std::unique_ptr<DrawingSurface> surface)
    : state_(std::make_unique<State>(size, std::move(surface))) {
  clear();
}
Canvas::Canvas(Canvas&&) noexcept = default;
Canvas& Canvas::operator=(Canvas&&) noexcept = default;
Canvas::~Canvas() = default;

int Canvas::width() const { return state_->width; }
int Canvas::height() const { return state_->height; }
Rectangle Canvas::page() const { return state_->page(); }
Rectangle Canvas::page(double most) {
  State& s = *state_;
  s.bottom = std::max(0.0, page_height - std::ceil(most * s.page().width));
  if (s.bottom > 0) s.surface->cut(static_cast<int>(std::lround((page_height - s.bottom) * s.scale)));
  return s.page();
}
DrawingSurface& Canvas::surface() const { return *state_->surface; }

void Canvas::clear(Colour paper) {
  state_->paper = paper;
  state_->restart();
}

void Canvas::look(const Camera& camera) { state_->camera = camera; }
void Canvas::look_at_page() { look({page(), page().centre(), 1}); }
const Camera& Canvas::camera() const { return state_->camera; }

void Canvas::clip(const std::optional<Rectangle>& rectangle) {
  const PixelBox box = rectangle ? state_->box(*rectangle) : PixelBox{0, 0, state_->width, state_->height};
  if (box == state_->clip) return;
  state_->surface->clip(box);
  state_->clip = box;
}

void Canvas::disc(const Point& centre, double radius, const Look& look) {
  const double pixels = radius * state_->camera.scale * state_->scale;
  state_->draw_disc(state_->seen(centre), pixels, look);
}

void Canvas::box(const Point& centre, const Point& size, double angle, const Look& look) {
  polygon(corners(centre, size / 2, angle), look);
}

void Canvas::rectangle(const Rectangle& r, const Look& look) {
  // On whole pixels, cells of a heat map meet without a seam and bars are sharp.
  const auto snapped = [](const Point& p) { return Point(std::round(p.x()), std::round(p.y())); };
  const Point a = snapped(state_->seen(Point(r.x, r.y))), c = snapped(state_->seen(Point(r.right(), r.top())));
  if (!a.allFinite() || !c.allFinite()) return;
  const std::array<Point, 4> outline{a, Point(c.x(), a.y()), c, Point(a.x(), c.y())};
  state_->draw_shape(outline, look, true);
}

void Canvas::polygon(std::span<const Point> points, const Look& look) {
  state_->draw_shape(state_->seen(points), look);
}

void Canvas::rod(const Point& a, const Point& b, const Look& look, double thickness) {
  const Point from = state_->seen(a), to = state_->seen(b);
  const double radius = thickness / 2 * state_->scale;
  const Point side = radius * left_of(unit_or(to - from, {1, 0}));
  constexpr int steps = 12;
  std::vector<Point> outline;
  outline.reserve(2 * (steps + 1));
  for (int i = 0; i <= steps; ++i) outline.push_back(from + turned(side, std::numbers::pi * i / steps));
  for (int i = 0; i <= steps; ++i) outline.push_back(to - turned(side, std::numbers::pi * i / steps));
  state_->draw_shape(outline, look);
}

void Canvas::line(const Point& a, const Point& b, const Stroke& style) { path(std::array<Point, 2>{a, b}, style); }

void Canvas::path(std::span<const Point> points, const Stroke& style) {
  state_->draw_stroke(state_->seen(points), style);
}

void Canvas::trail(std::span<const Point> points, const Stroke& style) {
  state_->draw_stroke(state_->seen(points), style, true);
}

void Canvas::spring(const Point& a, const Point& b, int turns, double thickness, const Stroke& style) {
  const Point from = state_->seen(a), to = state_->seen(b), ahead = unit_or(to - from, {1, 0});
  const double whole = (to - from).norm(), lead = std::min(10 * state_->scale, whole / 6);
  constexpr int steps = 16;  // a winding
  std::vector<Point> coil{from};
  for (int i = 0; i <= turns * steps; ++i) {
    const double s = lead + (whole - 2 * lead) * i / (turns * steps);
    const double swing = std::sin(2 * std::numbers::pi * i / steps);
    coil.push_back(from + s * ahead + thickness / 2 * state_->scale * swing * left_of(ahead));
  }
  coil.push_back(to);
  state_->draw_stroke(coil, style);
}

void Canvas::hinge(const Point& at) {
  state_->draw_disc(state_->seen(at), 4.5 * state_->scale, {palette::paper, {palette::ink, 1.8}});
}

void Canvas::anchor(const Point& at, const Point& body_side) {
  const double unit = state_->scale;
  const Point pin = state_->seen(at);
  const Point down = unit_or({body_side.x(), -body_side.y()}, {0, 1}), side = left_of(down);
  const Point base = pin - 16 * unit * down;
  const std::array<Point, 3> bracket{pin, base + 12 * unit * side, base - 12 * unit * side};
  state_->draw_shape(bracket, fixed_look);
  const Point a = base - 22 * unit * side, b = base + 22 * unit * side;
  state_->draw_hatching(a, b);
  state_->draw_stroke(std::array<Point, 2>{a, b}, {palette::ink, 1.8});
  hinge(at);
}

void Canvas::ground(const Point& a, const Point& b) {
  state_->draw_hatching(state_->seen(a), state_->seen(b));
  line(a, b, {palette::ink, 1.8});
}

void Canvas::mark(const Point& at, Mark mark, Colour colour, double size) {
  const Point p = state_->seen(at);
  const double r = size / 2 * state_->scale, line = 1.8;
  const Look full{colour, {colour, 0}}, open{palette::paper, {colour, line}};
  const auto regular = [&](int n, double radius, double angle) {
    std::vector<Point> points;
    for (int i = 0; i < n; ++i) points.push_back(p + turned({0, -radius}, angle + 2 * std::numbers::pi * i / n));
    return points;
  };
  if (!p.allFinite()) return;
  // These radii give all shapes about the same area.
  switch (mark) {
    case Mark::disc: return state_->draw_disc(p, r, full);
    case Mark::square: return state_->draw_shape(regular(4, 1.25 * r, std::numbers::pi / 4), full);
    case Mark::triangle: return state_->draw_shape(regular(3, 1.45 * r, 0), full);
    case Mark::diamond: return state_->draw_shape(regular(4, 1.35 * r, 0), full);
    case Mark::circle: return state_->draw_disc(p, 0.85 * r, open);
    case Mark::open_square: return state_->draw_shape(regular(4, 1.1 * r, std::numbers::pi / 4), open);
    case Mark::open_triangle: return state_->draw_shape(regular(3, 1.3 * r, 0), open);
    case Mark::open_diamond: return state_->draw_shape(regular(4, 1.2 * r, 0), open);
    case Mark::cross:
      for (const double s : {-0.9 * r, 0.9 * r})
        state_->draw_stroke(std::array<Point, 2>{p + Point(-0.9 * r, -s), p + Point(0.9 * r, s)}, {colour, 2.4});
  }
}

void Canvas::arrow(const Point& from, const Point& to, const Stroke& style) {
  state_->draw_arrow(state_->seen(from), state_->seen(to), style);
}

void Canvas::vector(const Point& from, const Point& quantity, const ArrowKind& kind) {
  arrow(from, from + kind.scale * quantity, {kind.colour, 3});
}

void Canvas::arrow_key(const Point& at, const ArrowKind& kind, std::string_view name) {
  const double points_per_unit = kind.scale * camera().scale, wanted = 60 / points_per_unit;
  if (!(wanted > 0 && std::isfinite(wanted)))
    throw std::invalid_argument(fmt::format("An arrow's scale is a positive length; got {}.", kind.scale));
  const double decade = std::pow(10, std::floor(std::log10(wanted)));
  const double round = decade * (wanted >= 5 * decade ? 5 : wanted >= 2 * decade ? 2 : 1);
  const Camera before = camera();
  look_at_page();
  const Point tip = at + Point(round * points_per_unit, 0);
  arrow(at, tip, {kind.colour, 3});
  const std::string value = fmt::format("{}{}{}", number(round), kind.unit.empty() ? "" : " ", kind.unit);
  text(tip, name.empty() ? value : fmt::format("{} {}", name, value),
       {.size = 16, .colour = kind.colour, .anchor = Anchor::left, .offset = {8, 0}});
  look(before);
}

void Canvas::dimension(const Point& a, const Point& b, std::string_view label, double offset) {
  const Camera before = camera();
  const Point from = before.to_page(a), to = before.to_page(b);
  if (!from.allFinite() || !to.allFinite()) return;
  const Point ahead = unit_or(to - from, {1, 0}), aside = left_of(ahead);
  const Point p = from + offset * aside, q = to + offset * aside;
  look_at_page();
  const Stroke thin{palette::muted, 1.3};
  line(p, q, thin);
  for (const Point& end : {p, q}) line(end - 5 * aside, end + 5 * aside, thin);
  // The text is on the outer side of the line, its box touching it.
  const Rectangle box = measure({0, 0}, label, {.size = 16});
  const double away = 6 + 0.5 * (std::abs(aside.x()) * box.width + std::abs(aside.y()) * box.height);
  text((p + q) / 2 + (offset < 0 ? -away : away) * aside, label, {.size = 16, .halo = 3});
  look(before);
}

void Canvas::text(const Point& at, std::string_view words, const TextStyle& wanted) {
  const Point where = camera().to_page(at);
  if (!where.allFinite() || words.empty()) return;
  State& s = *state_;
  std::string text(words);
  TextStyle style = wanted;
  TextBlock block = lay_out(*s.surface, s.scale, where, text, style);
  if (s.width < s.height && style.upright) {
    constexpr double least = 16;  // size of letters that are made smaller, before a line is broken
    const Rectangle page = s.page().inset(4);
    if (block.box.width > page.width) {
      style.size = std::min(style.size, std::max(least, style.size * page.width / block.box.width));
      if (block.lines.size() == 1)
        text = broken(text, [&](std::string_view part) {
          return s.surface->text_width(part, style.size * s.scale, style.bold) <= page.width * s.scale;
        });
      block = lay_out(*s.surface, s.scale, where, text, style);
    }
    style.offset.x() += std::max(page.x - block.box.x, 0.0) + std::min(page.right() - block.box.right(), 0.0);
    style.offset.y() += std::max(page.y - block.box.y, 0.0) + std::min(page.top() - block.box.top(), 0.0);
    block = lay_out(*s.surface, s.scale, where, text, style);
  }
  if (s.lists_labels) {
    s.labels.push_back({text, block.box, style.colour});
    return;
  }
  const Point held = share(style.anchor);
  std::vector<TextLine> lines;
  for (std::size_t i = 0; i < block.lines.size(); ++i) {
    const double fall = cap_height * style.size + double(i) * line_height * style.size;
    const Rectangle& box = block.box;
    const Point begin = style.upright ? Point(box.x + held.x() * (box.width - block.widths[i]), box.top() - fall)
                                      : Point(box.x + fall, box.y + held.y() * (box.height - block.widths[i]));
    lines.push_back({block.lines[i], s.pixel(begin)});
  }
  s.surface->text(lines,
                  {style.size * s.scale, style.bold, legible(style.colour), style.halo * s.scale, style.upright});
}

void Canvas::list_labels() { state_->lists_labels = true; }
const std::vector<Label>& Canvas::labels() const { return state_->labels; }

Rectangle Canvas::measure(const Point& at, std::string_view text, const TextStyle& style) const {
  return lay_out(*state_->surface, state_->scale, camera().to_page(at), text, style).box;
}

void Canvas::draw(const Space& space) { state_->surface->space(space, state_->box(space.camera().frame)); }

}  // namespace byhand::renderer
