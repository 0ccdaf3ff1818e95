#include "lessons/exact/compound_pendulum.hpp"

#include <cmath>

#include "solver/support/require.hpp"

namespace byhand {
namespace {

double checked(double length) {
  require_positive("the rod's length", length, "m");
  return length;
}

}  // namespace

CompoundPendulum::CompoundPendulum(double angle, double length, double mass, double gravity)
    : simple_(angle, 2 * checked(length) / 3, gravity), length_(length), mass_(mass), gravity_(gravity) {
  require_positive("the rod's mass", mass, "kg");
}

// The hinge supplies what the centre's acceleration needs beyond gravity.
Eigen::Vector2d CompoundPendulum::pivot_force(double time) const {
  const double theta = angle(time), omega = angular_velocity(time);
  const Eigen::Vector2d outward(std::sin(theta), -std::cos(theta)), onward(std::cos(theta), std::sin(theta));
  const double angular_acceleration = -1.5 * gravity_ / length_ * std::sin(theta);
  const Eigen::Vector2d acceleration = length_ / 2 * (angular_acceleration * onward - omega * omega * outward);
  return mass_ * (acceleration + gravity_ * Eigen::Vector2d::UnitY());
}

double CompoundPendulum::energy() const { return -mass_ * gravity_ * length_ / 2 * std::cos(angle(0)); }

}  // namespace byhand
