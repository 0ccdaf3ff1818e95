#pragma once

namespace byhand {

/// A bob that circles steadily at a fixed `angle` from straight down [rad].
class ConicalPendulum {
 public:
  /// Throws std::invalid_argument unless 0 <= angle < π/2 and length [m] and gravity [m/s²] are positive.
  ConicalPendulum(double angle, double length, double gravity);

  /// √(g/(L·cosθ)) [rad/s]
  double angular_velocity() const;
  /// One turn [s]
  double period() const;
  /// Radius of the circle, L·sinθ [m]
  double radius() const;
  /// Pull of the rod on a bob of `mass` [kg]: m·g/cosθ [N]
  double tension(double mass) const;

 private:
  double angle_, length_, gravity_;
};

}  // namespace byhand
