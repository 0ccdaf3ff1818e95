#pragma once

#include "renderer/rectangle.hpp"

namespace byhand::renderer {

/// Looks at the plane: `centre` of the world appears in the middle of `frame`, one world unit `scale` points
/// long.
struct Camera {
  Rectangle frame{};   ///< on the page, in points
  Point centre{0, 0};  ///< in the world
  double scale = 1;    ///< points per world unit

  Point to_page(const Point& world) const { return frame.centre() + scale * (world - centre); }
  Point to_world(const Point& page) const { return centre + (page - frame.centre()) / scale; }
};

/// The camera that shows all of the box `world` in `frame` as large as it goes, with `margin` points around
/// it. Throws std::invalid_argument when the frame is smaller than its margins or the box is a point or not
/// finite.
Camera fit(const Rectangle& world, const Rectangle& frame, double margin = 32);

}  // namespace byhand::renderer
