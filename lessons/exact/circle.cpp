#include "lessons/exact/circle.hpp"

#include "solver/support/require.hpp"

namespace byhand {

double circle_tension(double mass, double speed, double radius) {
  require_positive("mass", mass, "kg");
  require_finite("speed", speed, "m/s");
  require_positive("the circle's radius", radius, "m");
  return mass * speed * speed / radius;
}

}  // namespace byhand
