#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "renderer/canvas.hpp"

namespace byhand::renderer {

/// Places labels beside points without overlap between labels, avoided shapes and the edge of the frame.
class Labels {
 public:
  /// `frame`: the region for labels, in points on the page.
  Labels(Canvas& canvas, const Rectangle& frame);

  /// Keeps labels off a rectangle (points on the page), a disc or a path (both in world units).
  void avoid(const Rectangle& on_page);
  void avoid_disc(const Point& centre, double radius);
  void avoid_path(std::span<const Point> points);

  /// Area [points²] of avoided shapes and labels under a rectangle on the page.
  double covered(const Rectangle& on_page) const;

  /// Draws `text` beside `at` (world units). Tries right, left, above, below and the corners at `gap` points, then
  /// farther out. Takes the first free place, else the one with the least overlap. Returns its box in points.
  Rectangle place(const Point& at, std::string_view text, TextStyle style = {.halo = 3}, double gap = 10);

 private:
  Canvas& canvas_;
  Rectangle frame_;
  std::vector<Rectangle> taken_;
};

}  // namespace byhand::renderer
