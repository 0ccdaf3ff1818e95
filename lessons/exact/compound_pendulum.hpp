#pragma once

#include <Eigen/Core>

#include "lessons/exact/simple_pendulum.hpp"

namespace byhand {

/// A uniform rod hinged at one end, released from rest: I = m·l²/3 about the hinge makes it a simple pendulum
/// of length 2l/3. Angles are measured from straight down [rad].
class CompoundPendulum {
 public:
  /// Throws std::invalid_argument unless |angle| <= 3.14 rad and length [m], mass [kg] and gravity [m/s²] are
  /// > 0.
  CompoundPendulum(double angle, double length, double mass, double gravity);

  /// [s]
  double period() const { return simple_.period(); }
  /// θ [rad] at `time` [s]
  double angle(double time) const { return simple_.angle(time); }
  /// dθ/dt [rad/s] at `time` [s]
  double angular_velocity(double time) const { return simple_.angular_velocity(time); }
  /// Force of the hinge on the rod at `time` [s]: x to the side where θ > 0, y up [N].
  Eigen::Vector2d pivot_force(double time) const;
  /// Kinetic and potential energy, zero at rest with the centre at the hinge's height [J].
  double energy() const;

 private:
  SimplePendulum simple_;
  double length_, mass_, gravity_;
};

}  // namespace byhand
