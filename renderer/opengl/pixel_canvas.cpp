#include "renderer/opengl/pixel_canvas.hpp"

#include <optional>
#include <utility>
#include <vector>

#include "renderer/font.hpp"
#include "renderer/opengl/painter.hpp"
#include "renderer/outline.hpp"

namespace byhand::renderer {

// Turns shapes into triangles, and letters into quads with an atlas.
class PixelCanvas::Surface : public DrawingSurface {
 public:
  explicit Surface(const PageSize& size)
      : clip_{0, 0, size.width, size.height}, page_(clip_), painter_(size.width, size.height) {}

  void clear(Colour paper) override {
    vertices_.clear();
    batches_.clear();
    clip_ = page_;
    paper_ = paper;
  }

  void clip(const PixelBox& box) override {
    close_batch();
    clip_ = box;
  }

  void polygon(std::span<const Point> corners, Colour colour, const Pen& edge, bool sharp) override {
    if (sharp)
      fill_sharply(vertices_, corners, colour);
    else if (colour.a > 0)
      fill(vertices_, corners, colour);
    stroke(vertices_, corners, edge.width, edge.colour, true);
  }

  void disc(const Point& centre, double radius, Colour colour, const Pen& edge) override {
    polygon(circle(centre, radius), colour, edge, false);
  }

  void path(std::span<const Point> points, const Pen& pen) override {
    if (pen.on <= 0)
      return stroke(vertices_, points, pen.width, pen.colour, false, pen.opacity_at_start, pen.opacity_at_end);
    for (const std::vector<Point>& dash : dashed(points, pen.on, pen.off))
      stroke(vertices_, dash, pen.width, pen.colour);
  }

  void text(std::span<const TextLine> lines, const Lettering& how) override {
    const auto write = [&](Colour colour, double halo) {
      for (const TextLine& line : lines)
        font_.write(vertices_, line.words, line.at, how.size, how.bold, colour, halo, how.upright);
    };
    if (how.halo > 0) write(paper_, how.halo);
    write(how.colour, 0);
  }

  double text_width(std::string_view line, double size, bool bold) const override {
    return font_.width(line, size, bold);
  }

  void space(const Space& space, const PixelBox& frame) override {
    close_batch();
    batches_.push_back({frame, vertices_.size(), 0, space});
  }

  Image image() {
    close_batch();
    return painter_.paint(paper_, vertices_, batches_, font_);
  }

  const std::string& describe() const { return painter_.describe(); }

 private:
  // Makes a batch of all vertices since the last one.
  void close_batch() {
    const std::size_t first = batches_.empty() ? 0 : batches_.back().first + batches_.back().count;
    if (vertices_.size() > first) batches_.push_back({clip_, first, vertices_.size() - first, std::nullopt});
  }

  PixelBox clip_;
  const PixelBox page_;
  Painter painter_;
  Font font_;
  Vertices vertices_;
  std::vector<Batch> batches_;
  Colour paper_ = palette::paper;
};

PixelCanvas::PixelCanvas(int width, int height) : PixelCanvas(PageSize(width, height)) {}
PixelCanvas::PixelCanvas(const PageSize& size) : Canvas(size, std::make_unique<Surface>(size)) {}

Image PixelCanvas::image() { return static_cast<Surface&>(surface()).image(); }
const std::string& PixelCanvas::describe() const { return static_cast<const Surface&>(surface()).describe(); }

}  // namespace byhand::renderer
