#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "renderer/point.hpp"

namespace byhand::renderer {

/// An axis-aligned rectangle by its lower left corner; y points up, in the world and on the page.
struct Rectangle {
  double x = 0, y = 0, width = 0, height = 0;

  double right() const { return x + width; }
  double top() const { return y + height; }
  Point centre() const { return {x + width / 2, y + height / 2}; }
  bool contains(const Point& p) const { return p.x() >= x && p.x() <= right() && p.y() >= y && p.y() <= top(); }
  /// Area of the intersection with `other`.
  double overlap(const Rectangle& other) const {
    const double w = std::min(right(), other.right()) - std::max(x, other.x);
    const double h = std::min(top(), other.top()) - std::max(y, other.y);
    return w > 0 && h > 0 ? w * h : 0;
  }
  /// Shrinks by `margin` on each side; a negative margin grows it.
  Rectangle inset(double margin) const { return inset(margin, margin); }
  Rectangle inset(double dx, double dy) const { return {x + dx, y + dy, width - 2 * dx, height - 2 * dy}; }
  /// The parts left and right of a gap; the left one gets `fraction` of the remaining width.
  std::pair<Rectangle, Rectangle> split_columns(double fraction, double gap = 24) const {
    const double w = (width - gap) * fraction;
    return {{x, y, w, height}, {x + w + gap, y, width - w - gap, height}};
  }
  /// The parts above and below a gap; the upper one gets `fraction` of the remaining height.
  std::pair<Rectangle, Rectangle> split_rows(double fraction, double gap = 24) const {
    const double h = (height - gap) * fraction;
    return {{x, top() - h, width, h}, {x, y, width, height - h - gap}};
  }
  /// `rows` × `columns` equal cells, row by row from the top left.
  std::vector<Rectangle> cells(int rows, int columns, double gap = 24) const;

  // Layouts of a page that may be a phone's, which is higher than wide.
  bool is_high() const { return height > width; }
  /// Two panels side by side, the left one with `fraction` of the width; on a high page one above the other, the
  /// upper one with `upper` of the height, which is `fraction` unless it is given.
  std::pair<Rectangle, Rectangle> panels(double fraction, double gap = 24,
                                         std::optional<double> upper = {}) const {
    return is_high() ? split_rows(upper.value_or(fraction), gap) : split_columns(fraction, gap);
  }
  /// `cells`, on a high page with rows for columns.
  std::vector<Rectangle> grid(int rows, int columns, double gap = 24) const {
    return is_high() ? cells(columns, rows, gap) : cells(rows, columns, gap);
  }
  /// Without so much above and below if it is high, as a chart beside a scene need not be.
  Rectangle lowered(double margin) const { return is_high() ? inset(0, margin) : *this; }
};

/// Bounding box of both.
Rectangle united(const Rectangle& a, const Rectangle& b);
/// Bounding box of the points. Throws std::invalid_argument if there are none or one is not finite.
Rectangle bounds(std::span<const Point> points);

}  // namespace byhand::renderer
