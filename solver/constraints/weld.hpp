#pragma once

#include "solver/constraints/orientation.hpp"
#include "solver/constraints/pin.hpp"

// Two bodies move as one: a pin that allows no rotation.
//
//   C                C_k = e_k · (P2 - P1) as in Pin [m], then φ or 4σ of Orientation [rad]
//   differentiate,
//   isolate V        as there, row by row
//   J by inspection  J = [ -e_k   -r1 × e_k   e_k   r2 × e_k ]
//                        [   0       -Bᵀ       0       B     ]
//
// Three rows in the plane, where B = 1; six in space. λ is the impulse on body 2 in world axes [N s, N m s].
namespace byhand {

template <class M>
struct Weld {
  static constexpr int rows = M::dof;

  Anchors<M> at;
  Orientation<M> right = {};
  double softness = 0;  // γ [1/kg] >= 0

  template <class T>
  Rows<rows, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    Rows<rows, T> C;
    C << at.separation(pose1, pose2), right.template value<T>(pose1, pose2);
    return C;
  }

  Jacobian<M, rows> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    Jacobian<M, rows> J;
    J.matrix.template topRows<M::linear>() = Pin<M>{at}.jacobian(pose1, pose2).matrix;
    right.set_rows(J, pose1, pose2);
    return J;
  }

  void require_valid(const Bodies<M>&) const { right.require_valid(); }
};

/// A weld at a world point [m] of two bodies at their current poses.
template <class M>
Weld<M> weld(const Bodies<M>& bodies, int body1, int body2, const Linear<M>& point) {
  return {between<M>(bodies, body1, point, body2, point), orientation<M>(bodies, body1, body2)};
}

BYHAND_STORES_OF_BODIES(extern, Weld);

}  // namespace byhand
