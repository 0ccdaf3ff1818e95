#include "renderer/rectangle.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace byhand::renderer {

std::vector<Rectangle> Rectangle::cells(int rows, int columns, double gap) const {
  const double w = (width - gap * (columns - 1)) / columns, h = (height - gap * (rows - 1)) / rows;
  std::vector<Rectangle> cells;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      cells.push_back({x + column * (w + gap), top() - h - row * (h + gap), w, h});
  return cells;
}

Rectangle united(const Rectangle& a, const Rectangle& b) {
  const double x = std::min(a.x, b.x), y = std::min(a.y, b.y);
  return {x, y, std::max(a.right(), b.right()) - x, std::max(a.top(), b.top()) - y};
}

Rectangle bounds(std::span<const Point> points) {
  if (points.empty()) throw std::invalid_argument("The bounds of no points at all are not defined.");
  Point low = points.front(), high = low;
  for (const Point& p : points) {
    if (!p.allFinite())
      throw std::invalid_argument(fmt::format("A point at ({}, {}) has no bounds.", p.x(), p.y()));
    low = low.cwiseMin(p), high = high.cwiseMax(p);
  }
  return {low.x(), low.y(), high.x() - low.x(), high.y() - low.y()};
}

}  // namespace byhand::renderer
