#pragma once

#include "solver/constraints/orientation.hpp"

// Two bodies slide along one axis of body 1: no motion along the other directions t_k of body 1, no rotation.
//
//   C                C_k = t_k · d, d = P2 - P1 [m], then φ or 4σ of Orientation [rad]
//   differentiate,
//   isolate V        as in Slide and Orientation
//   J by inspection  J = [ -t_k   -(r1 + d) × t_k   t_k   r2 × t_k ]
//                        [   0          -Bᵀ          0        B    ]
//
// Two rows in the plane, five in space.
namespace byhand {

template <class M>
struct Slider {
  static constexpr int rows = M::dof - 1;

  Anchors<M> at;
  Packed<double, M::linear, M::linear - 1> across =
      tangents_of<M>(Linear<M>::Unit(0));  // t_k, as columns, in the frame of body 1
  Orientation<M> right = {};
  double softness = 0;  // γ [1/kg] >= 0

  template <class T>
  Rows<rows, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    const Linear<M, T> d = rotate(inverse(pose1.rotation), at.separation(pose1, pose2));
    Rows<rows, T> C;
    C << across.transpose().template cast<T>().lazyProduct(d), right.template value<T>(pose1, pose2);
    return C;
  }

  Jacobian<M, rows> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    const Linear<M> r1 = in_world<M, double>(pose1, at.arms.first),
                    r2 = in_world<M, double>(pose2, at.arms.second), to_P2 = r1 + at.separation(pose1, pose2);
    Jacobian<M, rows> J;
    for (int k = 0; k < M::linear - 1; ++k)
      set_row_along<M, rows>(J, k, rotate(pose1.rotation, across.col(k)), to_P2, r2);
    right.set_rows(J, pose1, pose2);
    return J;
  }

  void require_valid(const Bodies<M>&) const {
    require_orthonormal("directions across the slider", across);
    right.require_valid();
  }
};

/// A slider along a world axis of any length, at a world point [m] of two bodies at their current poses.
template <class M>
Slider<M> slider(const Bodies<M>& bodies, int body1, int body2, const Linear<M>& point, const Linear<M>& axis) {
  const Anchors<M> at = between<M>(bodies, body1, point, body2, point);
  return {at, tangents_of<M>(axis_in<M>(bodies, body1, axis)), orientation<M>(bodies, body1, body2)};
}

BYHAND_STORES_OF_BODIES(extern, Slider);

}  // namespace byhand
