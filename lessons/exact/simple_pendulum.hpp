#pragma once

namespace byhand {

/// A point on a massless rod in the plane, released from rest: sin(θ/2) = k·sn(K(k) − √(g/L)·t; k), k =
/// sin(θ0/2) (Landau and Lifshitz, Mechanics, §11). Angles are measured from straight down [rad]. The
/// relative error is about 1e-16/(π − |θ0|)².
class SimplePendulum {
 public:
  /// Throws std::invalid_argument unless |angle| <= 3.14 rad, length [m] > 0 and gravity [m/s²] > 0.
  SimplePendulum(double angle, double length, double gravity);

  /// 4·√(L/g)·K(k) [s]
  double period() const;
  /// θ [rad] at `time` [s]
  double angle(double time) const;
  /// dθ/dt [rad/s] at `time` [s]
  double angular_velocity(double time) const;
  /// Pull of the rod on a bob of `mass` [kg] at `time` [s]: m·(g·cosθ + L·θ̇²) [N]; negative where the rod
  /// pushes.
  double tension(double time, double mass) const;
  /// Kinetic and potential energy of a bob of `mass` [kg], zero at rest at the pivot's height [J].
  double energy(double mass) const;

 private:
  double angle_, length_, gravity_;
};

}  // namespace byhand
