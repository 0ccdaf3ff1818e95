#pragma once

#include <array>
#include <limits>

#include "solver/constraints/turn.hpp"

// A joint's freedom q, the angle of a Turn or the way of a Slide, ends at a stop q0.
//
//   C                C = q - q0 >= 0 at a lower stop, C = q0 - q >= 0 at an upper one            [rad or m]
//   differentiate    Ċ = ±q̇
//   isolate V        as in Turn and Slide
//   J by inspection  J = ±J_q
//
// One-sided like a contact: the accumulated λ >= 0 only pushes away from the stop [N m s or N s]. While C > 0 the
// row lets it close within the step, and no more. A stop of a turn keeps apart what lies within half a turn of q =
// 0.
namespace byhand {

enum class Stop { lower, upper };

template <class M, class Freedom>
struct Limit {
  static constexpr int rows = 1;
  static constexpr Bound bound = Bound::interval;
  static constexpr int position_rows = rows;

  Freedom at;
  double place = 0;  // q0 [rad or m]
  Stop stop = Stop::lower;
  double softness = 0;  // γ >= 0

  static constexpr std::array<double, 2> bounds(double /*h*/) {
    return {0, std::numeric_limits<double>::infinity()};
  }

  /// ±(q - q0) at two poses [rad or m], for any scalar.
  template <class T>
  Rows<1, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    return Rows<1, T>(T(sign() * (at.template value<T>(pose1, pose2) - place)));
  }

  /// ±J_q at two poses [1, and m].
  Jacobian<M, 1> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    Jacobian<M, 1> J = at.jacobian(pose1, pose2);
    J.matrix *= sign();
    return J;
  }

  /// Throws std::invalid_argument for a place where no stop can be, softness < 0, or what the freedom refuses.
  void require_valid(const Bodies<M>& bodies) const {
    at.require_valid(bodies);
    Freedom::require_place("place of the stop", place);
    require_in("softness", softness, 0, 1e300);
  }

 private:
  double sign() const { return stop == Stop::lower ? 1 : -1; }
};

template <class M>
struct AngleLimit : Limit<M, Turn<M>> {};
template <class M>
struct SlideLimit : Limit<M, Slide<M>> {};

/// Stops at an angle [rad] or a place [m].
template <class M>
AngleLimit<M> at_least(double angle, const Turn<M>& turn) {
  return {{turn, angle, Stop::lower}};
}
template <class M>
AngleLimit<M> at_most(double angle, const Turn<M>& turn) {
  return {{turn, angle, Stop::upper}};
}
template <class M>
SlideLimit<M> at_least(double place, const Slide<M>& slide) {
  return {{slide, place, Stop::lower}};
}
template <class M>
SlideLimit<M> at_most(double place, const Slide<M>& slide) {
  return {{slide, place, Stop::upper}};
}

BYHAND_STORE_IN_LIBRARY(PlaneBody, AngleLimit);
BYHAND_STORE_IN_LIBRARY(SpaceBody, AngleLimit);
BYHAND_STORE_IN_LIBRARY(PlaneBody, SlideLimit);
BYHAND_STORE_IN_LIBRARY(SpaceBody, SlideLimit);

}  // namespace byhand
