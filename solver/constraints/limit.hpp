#pragma once

#include "solver/constraints/freedom.hpp"

// A freedom q, the angle of a Turn or of a Swing or the distance of a Slide, ends at a stop q0.
//
//   C                C = q - q0 >= 0 at a lower stop, C = q0 - q >= 0 at an upper one            [rad or m]
//   differentiate    Ċ = ±q̇
//   isolate V        as in Turn and Slide
//   J by inspection  J = ±J_q
//
// One-sided: the accumulated λ >= 0 only pushes away from the stop [N m s or N s].
// A turn is stopped only within half a turn of q = 0.
namespace byhand {

enum class Stop { lower, upper };

template <class M, template <class> class Freedom>
struct Limit {
  static constexpr int rows = 1;
  static constexpr Bound bound = Bound::interval;

  Freedom<M> at;
  double place = 0;  // q0 [rad or m]
  Stop stop = Stop::lower;
  double softness = 0;  // γ >= 0

  template <class T>
  Rows<1, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    return Rows<1, T>(T(sign() * (at.template value<T>(pose1, pose2) - place)));
  }
  Jacobian<M, 1> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    Jacobian<M, 1> J = at.jacobian(pose1, pose2);
    J.matrix *= sign();
    return J;
  }

  void require_valid(const Bodies<M>&) const { at.require_place("place of the stop", place); }

 private:
  double sign() const { return stop == Stop::lower ? 1 : -1; }
};

/// Stops at an angle [rad] or a distance [m].
template <class M, template <class> class Freedom>
Limit<M, Freedom> at_least(double place, const Freedom<M>& freedom) {
  return {freedom, place, Stop::lower};
}
template <class M, template <class> class Freedom>
Limit<M, Freedom> at_most(double place, const Freedom<M>& freedom) {
  return {freedom, place, Stop::upper};
}

BYHAND_STORES_OF_FREEDOMS(extern, Limit);
extern BYHAND_STORE_OF_FREEDOM(SpaceBody, Limit, Swing);

}  // namespace byhand
