#pragma once

#include "renderer/rectangle.hpp"

namespace byhand::renderer {

/// Maps the plane of the world to the page: `centre` appears in the middle of `frame`, at `scale` points per unit.
struct Camera {
  Rectangle frame{};   ///< on the page, in points
  Point centre{0, 0};  ///< in the world
  double scale = 1;    ///< points per world unit

  Point to_page(const Point& world) const { return frame.centre() + scale * (world - centre); }
  Point to_world(const Point& page) const { return centre + (page - frame.centre()) / scale; }
};

/// The camera with the largest scale at which the box `world` fits into `frame` with `margin` points around it.
/// Throws std::invalid_argument if the frame is smaller than its margins, or the box is a point or not finite.
Camera fit(const Rectangle& world, const Rectangle& frame, double margin = 32);

}  // namespace byhand::renderer
