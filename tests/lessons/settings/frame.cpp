#include "tests/lessons/settings/frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>

#include "lessons/files/picture_drawer.hpp"
#include "renderer/chart.hpp"
#include "renderer/drawing_surface.hpp"
#include "renderer/font.hpp"

namespace byhand::tests {
namespace {

using renderer::Colour;
using renderer::Pen;
using renderer::PixelBox;
using renderer::Point;
using renderer::Rectangle;

constexpr double touching = 6;                       // points: the head of an arrow that ends at the edge
constexpr int page_width = 1280, page_height = 720;  // pixels, so that one is a point

struct Shape {
  Rectangle box;    // y down, as its panel
  Rectangle panel;  // what it is clipped to
};

/// Whether a polygon is a line: a rod, whose other end may be outside.
bool thin(std::span<const Point> corners) {
  double area = 0, longest = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point &a = corners[i], &b = corners[(i + 1) % corners.size()];
    area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    longest = std::max(longest, (a - corners[0]).norm());
  }
  constexpr double thickest = 9;  // points
  return std::abs(area) < thickest * longest;
}

/// Pictures in which something leaves the frame because that is what they show.
struct Excepted {
  const char *picture, *rule, *because;
};
constexpr Excepted excepted_pictures[] = {
    {"pop", "a body leaves its frame", "a box that is thrown out of the ground flies out of sight"},
    {"heavy_on_light", "a body leaves its frame", "with few sweeps the boxes sink out of sight"},
    {"heavy_on_light", "a label leaves the page", "with few sweeps the boxes sink out of sight, names and all"},
    {"heavy_on_light", "a label covers another", "with few sweeps the boxes sink out of sight, names and all"},
    {"sweeps_side_by_side", "a body leaves its frame", "without correction a chain stretches out of sight"},
    {"warm_and_cold", "a body leaves its frame", "a chain that rings breaks up and flies out of sight"},
    {"stack", "a label covers another", "a named tick stands beside the lowest decade of its axis"},
    {"leaning_stack", "a body leaves its frame", "boxes of a fallen stack roll out of sight"},
    {"ringing_chain", "a body leaves its frame", "a chain that rings breaks up and flies out of sight"},
    {"exploding_chain", "a body leaves its frame", "a chain that tears flies out of sight"},
    {"stack", "a body leaves its frame", "boxes of a fallen stack roll out of sight"},
    {"block_and_row", "a body leaves its frame", "with few sweeps a pin comes off and its box flies out of sight"},
};

/// Keeps where shapes are and draws nothing. Lines may leave their panel: the canvas cuts them, and a chart's
/// curve, a ground and a trail mean to.
class Recorder : public renderer::DrawingSurface {
 public:
  void clear(Colour /*paper*/) override {
    shapes_.clear();
    in_space_ = false;
    panel_ = {0, 0, page_width, page_height};
  }
  void clip(const PixelBox& box) override {
    panel_ = {double(box.x), double(box.y), double(box.width), double(box.height)};
  }
  void polygon(std::span<const Point> corners, Colour fill, const Pen& edge, bool sharp) override {
    const bool seen = fill.a > 0 || edge.width > 0;
    if (seen && !sharp && !thin(corners) && fill != renderer::palette::fixed)
      shapes_.push_back({renderer::bounds(corners), panel_});
  }
  void disc(const Point& centre, double radius, Colour /*fill*/, const Pen& /*edge*/) override {
    shapes_.push_back({{centre.x() - radius, centre.y() - radius, 2 * radius, 2 * radius}, panel_});
  }
  void path(std::span<const Point> /*points*/, const Pen& /*pen*/) override {}
  void text(std::span<const renderer::TextLine> /*lines*/, const renderer::Lettering& /*how*/) override {}
  double text_width(std::string_view line, double size, bool bold) const override {
    return font_.width(line, size, bold);
  }
  void space(const renderer::Space& /*space*/, const PixelBox& /*frame*/) override { in_space_ = true; }

  const std::vector<Shape>& shapes() const { return shapes_; }
  bool shows_a_body() const { return in_space_ || !shapes_.empty(); }

 private:
  renderer::Font font_;
  std::vector<Shape> shapes_;
  bool in_space_ = false;  // a scene in space is drawn, whose bodies are not looked at
  Rectangle panel_;
};

class RecordingCanvas : public renderer::Canvas {
 public:
  RecordingCanvas() : Canvas({page_width, page_height}, std::make_unique<Recorder>()) { list_labels(); }
  const Recorder& recorded() const { return static_cast<const Recorder&>(surface()); }
};

/// How far [points] `inner` stands out of `outer`.
double beyond(const Rectangle& inner, const Rectangle& outer) {
  return std::max(
      {outer.x - inner.x, outer.y - inner.y, inner.right() - outer.right(), inner.top() - outer.top()});
}

bool spans(const Rectangle& box, const Rectangle& panel) {
  return box.width >= panel.width || box.height >= panel.height;
}

std::vector<Finding> findings(const RecordingCanvas& canvas, const std::string& caption) {
  std::set<std::string> rules;
  std::vector<Finding> found;
  const auto add = [&](const std::string& rule, const std::string& words) {
    const bool excepted = std::any_of(
        std::begin(excepted_pictures), std::end(excepted_pictures),
        [&](const Excepted& e) { return rule == e.rule && caption.starts_with(std::string(e.picture) + ":"); });
    if (!excepted && rules.insert(rule).second)
      found.push_back({rule, fmt::format("{} [{}]", words, caption.substr(0, 90))});
  };
  for (const Shape& shape : canvas.recorded().shapes())
    if (const double out = beyond(shape.box, shape.panel); out > touching && !spans(shape.box, shape.panel))
      add("a body leaves its frame",
          fmt::format("by {:.0f} of {:.0f} × {:.0f} points", out, shape.box.width, shape.box.height));
  const auto& labels = canvas.labels();
  for (auto a = labels.begin(); a != labels.end(); ++a) {
    if (beyond(a->box, canvas.page()) > 2) add("a label leaves the page", a->text);
    for (auto b = std::next(a); b != labels.end(); ++b) {
      const double smaller = std::min(a->box.width * a->box.height, b->box.width * b->box.height);
      if (a->text != b->text && a->box.overlap(b->box) > 0.25 * smaller)
        add("a label covers another", fmt::format("“{}” and “{}”", a->text, b->text));
    }
  }
  return found;
}

/// Whether the first frame has more than curves, rods and letters.
bool begins_with_a_body(const course::FrameDrawing& draw) {
  RecordingCanvas canvas;
  const course::FrameDrawing copy = draw;  // it may go on from frame to frame
  copy(canvas, 0);
  return canvas.recorded().shows_a_body();
}

}  // namespace

std::vector<Finding> out_of_frame(const course::Drawing& draw, const std::string& caption) {
  RecordingCanvas canvas;
  draw(canvas);
  return findings(canvas, caption);
}

std::vector<Finding> out_of_frame(const course::Page& page) {
  const course::PictureDrawer pictures(course::small_quality);
  std::vector<Finding> all;
  for (const course::Item& item : page.items()) {
    if (const auto* figure = std::get_if<course::Figure>(&item))
      if (const auto* draw = std::get_if<course::Drawing>(&figure->picture))
        std::ranges::move(out_of_frame(*draw, figure->name + ": " + figure->caption), std::back_inserter(all));
    if (const auto* figure = std::get_if<course::Figure>(&item))
      if (const auto* chart = std::get_if<renderer::Chart>(&figure->picture))
        std::ranges::move(
            out_of_frame(
                [&](renderer::Canvas& canvas) { renderer::draw(canvas, *chart, canvas.page().inset(12)); },
                figure->name + ": " + figure->caption),
            std::back_inserter(all));
    if (const auto* film = std::get_if<course::Sequence>(&item)) {
      const course::FrameDrawing draw = film->draw;
      const int last = pictures.count(*film) - 1;
      std::set<std::string> rules;
      constexpr int looks = 8;
      int before = -1;
      if (!begins_with_a_body(draw))
        all.push_back({"a film begins without a body", film->name + ": " + film->caption});
      for (int i = 0; i <= looks; ++i) {
        const int frame = last * i / looks;
        if (std::exchange(before, frame) == frame) continue;
        for (Finding& finding :
             out_of_frame([&](renderer::Canvas& canvas) { draw(canvas, pictures.time(*film, frame)); },
                          film->name + ": " + film->caption))
          if (rules.insert(finding.rule).second) all.push_back(std::move(finding));
      }
    }
  }
  return all;
}

}  // namespace byhand::tests
