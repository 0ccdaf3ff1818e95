#pragma once

#include "solver/constraints/anchors.hpp"

// A joint is a system of constraints. The pin: two points coincide, one row for each axis e_k of the world.
//
//   C                C_k = e_k · (P2 - P1)                                                   [m]
//   differentiate    Ċ_k = e_k · ((v2 + ω2 × r2) - (v1 + ω1 × r1))
//   isolate V        Ċ_k = e_k·v2 + (r2 × e_k)·ω2 - e_k·v1 - (r1 × e_k)·ω1   (triple product, as in (13))
//   J by inspection  J_k = [ -e_k   -r1 × e_k   e_k   r2 × e_k ]
//
// Two rows in the plane, three in space (a ball joint); λ is the impulse on body 2 in world axes [N s].
namespace byhand {

template <class M>
struct Pin {
  static constexpr int rows = M::linear;

  Anchors<M> at;
  double softness = 0;  // γ [1/kg] >= 0

  template <class T>
  Rows<rows, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    return at.separation(pose1, pose2);
  }

  //! [jacobian]
  /// J at two poses [1, and m where a body turns].
  Jacobian<M, rows> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    const Arm<M> r1 = in_world<M, double>(pose1, at.arms.first), r2 = in_world<M, double>(pose2, at.arms.second);
    Jacobian<M, rows> J;
    for (int k = 0; k < rows; ++k) set_row_along<M, rows>(J, k, Linear<M>::Unit(k), r1, r2);
    return J;
  }
  //! [jacobian]
};

/// A pin at a world point [m] of two bodies at their current poses.
template <class M>
Pin<M> pin(const Bodies<M>& bodies, int body1, int body2, const Linear<M>& point) {
  return {between<M>(bodies, body1, point, body2, point)};
}

BYHAND_STORES(extern, Pin);

}  // namespace byhand
