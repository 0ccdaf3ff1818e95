#pragma once

#include <array>

#include "solver/constraints/turn.hpp"

// A motor drives a joint's freedom q, the angle of a Turn or the way of a Slide, at a speed s. There is no C to
// keep, only a rate.
//
//   asks for         q̇ = s                                                              [rad/s or m/s]
//   isolate V        as in Turn and Slide
//   J by inspection  J = J_q, and the row's bias is -s: JV - s = 0
//
// It gives at most `strength` [N m or N], so over a step |λ| <= strength h: at its bound it pushes on and is
// slower.
namespace byhand {

template <class M, class Freedom>
struct Motor {
  static constexpr int rows = 1;
  static constexpr Bound bound = Bound::interval;
  static constexpr int position_rows = 0;
  static constexpr bool periodic = std::is_same_v<Freedom, Turn<M>>;

  Freedom at;
  double speed = 0;     // s [rad/s or m/s]
  double strength = 0;  // [N m or N] >= 0, may be infinite

  std::array<double, 2> bounds(double h) const { return {-strength * h, strength * h}; }

  Soft soft(const Pose<M>&, const Pose<M>&, double /*h*/) const { return {0, -speed}; }

  /// q at two poses [rad or m], for any scalar.
  template <class T>
  Rows<1, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    return Rows<1, T>(at.template value<T>(pose1, pose2));
  }

  /// J_q at two poses [1, and m].
  Jacobian<M, 1> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const { return at.jacobian(pose1, pose2); }

  /// Throws std::invalid_argument for a speed that is not finite, strength < 0, or what the freedom refuses.
  void require_valid(const Bodies<M>& bodies) const {
    at.require_valid(bodies);
    require_finite("speed of the motor", speed, "rad/s or m/s");
    require(strength >= 0, "strength of the motor", strength, "zero or above [N m or N]");
  }
};

template <class M>
struct AngleMotor : Motor<M, Turn<M>> {};
template <class M>
struct SlideMotor : Motor<M, Slide<M>> {};

/// Motors of a speed [rad/s or m/s] and a strength [N m or N].
template <class M>
AngleMotor<M> motor(const Turn<M>& turn, double speed, double strength) {
  return {{turn, speed, strength}};
}
template <class M>
SlideMotor<M> motor(const Slide<M>& slide, double speed, double strength) {
  return {{slide, speed, strength}};
}

BYHAND_STORE_IN_LIBRARY(PlaneBody, AngleMotor);
BYHAND_STORE_IN_LIBRARY(SpaceBody, AngleMotor);
BYHAND_STORE_IN_LIBRARY(PlaneBody, SlideMotor);
BYHAND_STORE_IN_LIBRARY(SpaceBody, SlideMotor);

}  // namespace byhand
