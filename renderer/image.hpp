#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace byhand::renderer {

/// A picture: `height` rows from top to bottom of `width` pixels, each red, green, blue (sRGB, 0–255).
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;

  /// The first of the three bytes of the pixel in column `x` from the left and row `y` from the top.
  const std::uint8_t* pixel(int x, int y) const { return rgb.data() + 3 * (std::size_t(y) * width + x); }

  bool operator==(const Image&) const = default;
};

}  // namespace byhand::renderer
