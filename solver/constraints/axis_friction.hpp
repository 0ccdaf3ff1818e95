#pragma once

#include "solver/constraints/anchors.hpp"

// One axis of friction by itself: (16) along one tangent of a contact, whatever the other axis does.
//
//   slip              s = t · (P2 - P1), t held still over a step                                [m]
//   J by inspection,  J = [ -t   -r1 × t   t   r2 × t ], as in friction.hpp
//   (16)
//
// |λ| <= μ λ_normal [N s]. Two of them at right angles hold the impulse in a square, the "box pyramid", and not in
// Coulomb's disc: diagonally it rubs √2 times too much, and turns what slides towards its axes. Friction has the
// disc.
namespace byhand {

template <class M>
struct AxisFriction {
  static constexpr int rows = 1;
  static constexpr Bound bound = Bound::friction;
  static constexpr int position_rows = 0;

  Anchors<M> at;
  Linear<M> tangent;       // t, a unit vector in the world
  double coefficient = 0;  // μ >= 0
  int contact = 0;         // the contact that presses, by its handle
  double softness = 0;     // γ [1/kg] >= 0

  /// The slip at two poses [m], for any scalar.
  template <class T>
  Rows<1, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    return Rows<1, T>(at.separation(pose1, pose2).dot(tangent.template cast<T>()));
  }

  /// (16) at two poses [1, and m where a body turns].
  Jacobian<M, 1> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    const Arm<M> r1 = in_world<M, double>(pose1, at.arms.first), r2 = in_world<M, double>(pose2, at.arms.second);
    Jacobian<M, 1> J;
    set_row_along<M, 1>(J, 0, tangent, r1, r2);
    return J;
  }

  /// Throws std::invalid_argument unless the tangent has length 1, μ >= 0 and softness >= 0.
  void require_valid(const Bodies<M>& bodies) const {
    at.require_valid(bodies);
    require_in("length of the tangent", tangent.norm(), 1 - 1e-9, 1 + 1e-9);
    require_in("friction coefficient", coefficient, 0, 1e300);
    require_in("softness", softness, 0, 1e300);
  }
};

BYHAND_STORES_IN_LIBRARY(AxisFriction);

}  // namespace byhand
