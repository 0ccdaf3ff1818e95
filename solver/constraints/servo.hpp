#pragma once

#include <array>

#include "solver/constraints/spring.hpp"
#include "solver/constraints/turn.hpp"

// A servo drives a joint's freedom q, the angle of a Turn or the way of a Slide, to a target q* and holds it
// there: a motor for a position, which acts like a spring of limited strength.
//
//   C                C = q - q*                                                              [rad or m]
//   isolate V        as in Turn and Slide
//   J by inspection  J = J_q, bias and γ as in Spring
//
// Over a step |λ| <= strength h. With infinite strength it is a torsion spring, or a spring along a slider.
namespace byhand {

template <class M, class Freedom>
struct Servo {
  static constexpr int rows = 1;
  static constexpr Bound bound = Bound::interval;
  static constexpr int position_rows = 0;  // the row brings its own bias
  static constexpr bool periodic = std::is_same_v<Freedom, Turn<M>>;

  Freedom at;
  double target = 0;  // q* [rad or m]
  Elastic elastic = {};
  double strength = 0;  // [N m or N] >= 0, may be infinite

  std::array<double, 2> bounds(double h) const { return {-strength * h, strength * h}; }

  /// q - q* at two poses [rad or m], for any scalar.
  template <class T>
  Rows<1, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    return Rows<1, T>(T(at.template value<T>(pose1, pose2) - target));
  }

  Soft soft(const Pose<M>& pose1, const Pose<M>& pose2, double h) const {
    return elastic.soft(value<double>(pose1, pose2)[0], h);
  }

  /// J_q at two poses [1, and m].
  Jacobian<M, 1> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const { return at.jacobian(pose1, pose2); }

  /// Throws std::invalid_argument for a target that cannot be reached, stiffness, damping or strength out of
  /// range, or what the freedom refuses.
  void require_valid(const Bodies<M>& bodies) const {
    at.require_valid(bodies);
    Freedom::require_place("target of the servo", target);
    byhand::require_valid(elastic);
    require(strength >= 0, "strength of the servo", strength, "zero or above [N m or N]");
  }
};

template <class M>
struct AngleServo : Servo<M, Turn<M>> {};
template <class M>
struct SlideServo : Servo<M, Slide<M>> {};

/// Servos to a target [rad or m], of a strength [N m or N].
template <class M>
AngleServo<M> servo(const Turn<M>& turn, double target, const Elastic& elastic, double strength) {
  return {{turn, target, elastic, strength}};
}
template <class M>
SlideServo<M> servo(const Slide<M>& slide, double target, const Elastic& elastic, double strength) {
  return {{slide, target, elastic, strength}};
}

BYHAND_STORE_IN_LIBRARY(PlaneBody, AngleServo);
BYHAND_STORE_IN_LIBRARY(SpaceBody, AngleServo);
BYHAND_STORE_IN_LIBRARY(PlaneBody, SlideServo);
BYHAND_STORE_IN_LIBRARY(SpaceBody, SlideServo);

}  // namespace byhand
