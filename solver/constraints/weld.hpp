#pragma once

#include "solver/constraints/orientation.hpp"
#include "solver/constraints/pin.hpp"

// Two bodies are one: a pin, and no turn.
//
//   C                C_k = e_k · (P2 - P1) as in Pin [m], then φ or 4σ of Orientation [rad]
//   differentiate,
//   isolate V        there, row by row
//   J by inspection  J = [ -e_k   -r1 × e_k   e_k   r2 × e_k ]
//                        [   0       -Bᵀ       0       B     ]
//
// Three rows in the plane, where B = 1; six in space. λ is the impulse on body 2 in world axes [N s, N m s].
namespace byhand {

template <class M>
struct Weld {
  static constexpr int rows = M::dof;
  static constexpr Bound bound = Bound::none;
  static constexpr int position_rows = rows;

  Anchors<M> at;
  Orientation<M> right = {};
  double softness = 0;  // γ [1/kg] >= 0

  /// P2 - P1 and φ or 4σ at two poses [m, rad], for any scalar.
  template <class T>
  Rows<rows, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    Rows<rows, T> C;
    C << at.separation(pose1, pose2), right.template value<T>(pose1, pose2);
    return C;
  }

  /// J at two poses [1 and m; 1].
  Jacobian<M, rows> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    Jacobian<M, rows> J;
    J.matrix.template topRows<M::linear>() = Pin<M>{at}.jacobian(pose1, pose2).matrix;
    right.set_rows(J, pose1, pose2);
    return J;
  }

  /// Throws std::invalid_argument for softness < 0, a rotation that is none, or anchors that name no bodies.
  void require_valid(const Bodies<M>& bodies) const {
    at.require_valid(bodies);
    require_rotation<M>(right.rest);
    require_in("softness", softness, 0, 1e300);
  }
};

/// A weld at a world point [m] of two bodies as they now stand.
template <class M>
Weld<M> weld(const Bodies<M>& bodies, int body1, int body2, const Linear<M>& point) {
  return {between<M>(bodies, body1, point, body2, point), orientation<M>(bodies, body1, body2)};
}

BYHAND_STORE_IN_LIBRARY(PlaneBody, Weld);
BYHAND_STORE_IN_LIBRARY(SpaceBody, Weld);

}  // namespace byhand
