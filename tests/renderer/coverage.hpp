#pragma once

#include <cmath>

#include "renderer/canvas.hpp"

namespace byhand::renderer {

inline constexpr Colour black{0, 0, 0}, white{255, 255, 255};
inline constexpr Look black_area{black, {black, 0}};

// How much of a pixel on a white page is black, 0 … 1.
inline double darkness(const Image& image, int x, int y) { return 1 - image.pixel(x, y)[1] / 255.0; }

// What is black on a white page: its area and the box around it, in pixels, y down.
struct Ink {
  double area = 0;
  double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
};

inline Ink ink(const Image& image, double threshold = 0.5) {
  Ink result;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double d = darkness(image, x, y);
      result.area += d;
      if (d < threshold) continue;
      result.left = std::min(result.left, double(x)), result.right = std::max(result.right, x + 1.0);
      result.top = std::min(result.top, double(y)), result.bottom = std::max(result.bottom, y + 1.0);
    }
  return result;
}

// The pixel that shows a point of the page (points), column and row.
inline std::pair<int, int> pixel_of(const Canvas& canvas, const Point& page) {
  const double scale = canvas.height() / 720.0;
  return {int(std::floor(page.x() * scale)), int(std::floor(canvas.height() - page.y() * scale))};
}

inline Colour colour_at(const Image& image, std::pair<int, int> place) {
  const std::uint8_t* p = image.pixel(place.first, place.second);
  return {p[0], p[1], p[2]};
}

}  // namespace byhand::renderer
