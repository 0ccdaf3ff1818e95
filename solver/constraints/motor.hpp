#pragma once

#include <array>

#include "solver/constraints/freedom.hpp"
#include "solver/constraints/spring.hpp"

// A motor drives a freedom q, the angle of a Turn or the distance of a Slide, at a speed s: a rate without C.
//
//   rate             q̇ = s                                                              [rad/s or m/s]
//   isolate V        as in Turn and Slide
//   J by inspection  J = J_q with the bias -s: JV - s = 0
//
// A servo drives q to a target q* and holds it there: a spring of limited strength. With infinite strength it is a
// torsion spring, or a spring along a slider.
//
//   C                C = q - q*                                                              [rad or m]
//   isolate V        as in Turn and Slide
//   J by inspection  J = J_q, bias and γ as in Spring
//
// Their strength bounds the impulse of a step: |λ| <= strength h. A row at its bound is slower than it should be.
namespace byhand {

/// What motors and servos share.
template <class M, template <class> class Freedom>
struct Drive {
  static constexpr int rows = 1, position_rows = 0;  // the row has its own bias
  static constexpr Bound bound = Bound::interval;
  static constexpr bool periodic = std::is_same_v<Freedom<M>, Turn<M>>;

  Freedom<M> at;
  double strength = 0;  // [N m or N] >= 0, may be infinite

  Jacobian<M, 1> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const { return at.jacobian(pose1, pose2); }
  std::array<double, 2> bounds(double h) const { return {-strength * h, strength * h}; }
};

template <class M, template <class> class Freedom>
struct Motor : Drive<M, Freedom> {
  double speed = 0;  // s [rad/s or m/s]

  template <class T>
  Rows<1, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    return Rows<1, T>(this->at.template value<T>(pose1, pose2));
  }
  Soft soft(const Pose<M>&, const Pose<M>&, double /*h*/) const { return {0, -speed}; }

  void require_valid(const Bodies<M>&) const {
    require_finite("speed of the motor", speed, "rad/s or m/s");
    require(this->strength >= 0, "strength of the motor", this->strength, "zero or above [N m or N]");
  }
};

template <class M, template <class> class Freedom>
struct Servo : Drive<M, Freedom> {
  double target = 0;  // q* [rad or m]
  Elastic elastic = {};

  template <class T>
  Rows<1, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    return Rows<1, T>(T(this->at.template value<T>(pose1, pose2) - target));
  }
  Soft soft(const Pose<M>& pose1, const Pose<M>& pose2, double h) const {
    return elastic.soft(value<double>(pose1, pose2)[0], h);
  }

  void require_valid(const Bodies<M>&) const {
    this->at.require_place("target of the servo", target);
    elastic.require_valid();
    require(this->strength >= 0, "strength of the servo", this->strength, "zero or above [N m or N]");
  }
};

/// A motor of a speed [rad/s or m/s] and a strength [N m or N].
template <class M, template <class> class Freedom>
Motor<M, Freedom> motor(const Freedom<M>& freedom, double speed, double strength) {
  return {{freedom, strength}, speed};
}
/// A servo to a target [rad or m], of a strength [N m or N].
template <class M, template <class> class Freedom>
Servo<M, Freedom> servo(const Freedom<M>& freedom, double target, const Elastic& elastic, double strength) {
  return {{freedom, strength}, target, elastic};
}

BYHAND_STORES_OF_FREEDOMS(extern, Motor);
BYHAND_STORES_OF_FREEDOMS(extern, Servo);

}  // namespace byhand
