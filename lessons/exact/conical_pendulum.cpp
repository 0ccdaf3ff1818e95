#include "lessons/exact/conical_pendulum.hpp"

#include <cmath>
#include <numbers>

#include "solver/support/require.hpp"

namespace byhand {

ConicalPendulum::ConicalPendulum(double angle, double length, double gravity)
    : angle_(angle), length_(length), gravity_(gravity) {
  require(0 <= angle && angle < std::numbers::pi / 2, "the cone's angle", angle, "at least 0 and below π/2 [rad]");
  require_positive("the pendulum's length", length, "m");
  require_positive("gravity", gravity, "m/s²");
}

double ConicalPendulum::angular_velocity() const { return std::sqrt(gravity_ / (length_ * std::cos(angle_))); }

double ConicalPendulum::period() const { return 2 * std::numbers::pi / angular_velocity(); }

double ConicalPendulum::radius() const { return length_ * std::sin(angle_); }

double ConicalPendulum::tension(double mass) const {
  require_positive("mass", mass, "kg");
  return mass * gravity_ / std::cos(angle_);
}

}  // namespace byhand
