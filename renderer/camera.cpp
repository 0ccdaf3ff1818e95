#include "renderer/camera.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace byhand::renderer {

Camera fit(const Rectangle& world, const Rectangle& frame, double margin) {
  const double width = frame.width - 2 * margin, height = frame.height - 2 * margin;
  const double scale = std::min(width / world.width, height / world.height);
  const bool sides = world.width >= 0 && world.height >= 0 && world.width + world.height > 0;
  if (!(width > 0 && height > 0 && sides && std::isfinite(scale) && world.centre().allFinite()))
    throw std::invalid_argument(fmt::format(
        "A camera fits a finite box into a frame larger than its margins; got a box of {} × {}, a frame "
        "of {} × {} points and margins of {}.",
        world.width, world.height, frame.width, frame.height, margin));
  return {frame, world.centre(), scale};
}

}  // namespace byhand::renderer
