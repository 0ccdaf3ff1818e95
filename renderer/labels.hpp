#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "renderer/canvas.hpp"

namespace byhand::renderer {

/// Places texts beside points so that none covers another, a shape it was told to avoid or the edge of
/// `frame`.
class Labels {
 public:
  /// `frame`, in points on the page, is where texts may stand.
  Labels(Canvas& canvas, const Rectangle& frame);

  /// Keeps texts off a rectangle (points), a disc or a path (both in the camera's units).
  void avoid(const Rectangle& on_page);
  void avoid_disc(const Point& centre, double radius);
  void avoid_path(std::span<const Point> points);

  /// The area, in square points, of what a rectangle on the page would cover.
  double covered(const Rectangle& on_page) const;

  /// Draws `text` beside `at` (camera's units), `gap` points away: right, left, above, below, the corners,
  /// then farther out; the first place that is free, else the one that covers least. Returns its box in
  /// points.
  Rectangle place(const Point& at, std::string_view text, TextStyle style = {.halo = 3}, double gap = 10);

 private:
  Canvas& canvas_;
  Rectangle frame_;
  std::vector<Rectangle> taken_;
};

}  // namespace byhand::renderer
