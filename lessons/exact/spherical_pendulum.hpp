#pragma once

#include <vector>

#include "lessons/exact/certified_integration.hpp"

namespace byhand {

/// A bob on a massless rod in space, started sideways. With u = cosθ, u̇² = (u − u0)·(2(g/L)·(1 − u²) −
/// (φ̇0·sinθ0)²·(u + u0)): it swings between two cones in an elliptic period while it goes round the vertical.
class SphericalPendulum {
 public:
  struct State {
    double angle, azimuth;            // from straight down, and about the upward vertical [rad]
    double angle_rate, azimuth_rate;  // [rad/s]
    double uncertainty;               // largest error expected in angle, azimuth and angle_rate
  };

  /// Starts at azimuth 0 with `angle` [rad] at rest and turning about the vertical at `azimuth_rate` [rad/s].
  /// Throws std::invalid_argument unless 0 < angle < π, azimuth_rate is finite and not zero (a plane pendulum
  /// is SimplePendulum) and length [m] and gravity [m/s²] are positive.
  SphericalPendulum(double angle, double azimuth_rate, double length, double gravity);

  /// The other cone it touches: where θ̇ vanishes again [rad].
  double other_angle() const;
  /// From one cone to the other and back [s]
  double nutation_period() const;
  /// The state after `time` [s] >= 0.
  State at(double time) const;
  /// The angles from straight down after 0, end/parts, … `end` [s]: for a curve (see integrated_path).
  std::vector<double> angles(double end, int parts) const;
  /// Kinetic and potential energy of a bob of `mass` [kg], zero at rest at the pivot's height [J].
  double energy(double mass) const;
  /// About the upward vertical, of a bob of `mass` [kg]: m·L²·sin²θ·φ̇ [kg·m²/s]
  double angular_momentum(double mass) const;

 private:
  /// Of angle, azimuth and angle_rate.
  Rate rate() const;
  /// sin²θ·φ̇, which gravity cannot change.
  long double momentum() const;

  double angle_, azimuth_rate_, length_, gravity_;
};

}  // namespace byhand
