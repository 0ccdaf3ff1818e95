#pragma once

#include "solver/constraints/friction.hpp"
#include "solver/constraints/orientation.hpp"
#include "solver/constraints/slide.hpp"

// Two bodies move along one axis against each other: they keep off every other direction t_k, which body 1
// carries, and do not turn.
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
  static constexpr Bound bound = Bound::none;
  static constexpr int position_rows = rows;
  using Tangents = Eigen::Matrix<double, M::linear, M::linear - 1>;

  Anchors<M> at;
  Tangents across = tangents_of<M>(Linear<M>::Unit(0));  // t_k, as columns, in the frame of body 1
  Orientation<M> right = {};
  double softness = 0;  // γ [1/kg] >= 0

  /// t_k · d and φ or 4σ at two poses [m, rad], for any scalar.
  template <class T>
  Rows<rows, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    const Linear<M, T> d = rotate(inverse(pose1.rotation), at.separation(pose1, pose2));
    Rows<rows, T> C;
    C << across.transpose().template cast<T>().lazyProduct(d), right.template value<T>(pose1, pose2);
    return C;
  }

  /// J at two poses [1 and m; 1].
  Jacobian<M, rows> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    const Linear<M> r1 = in_world<M, double>(pose1, at.arms.first),
                    r2 = in_world<M, double>(pose2, at.arms.second);
    const Linear<M> d = at.separation(pose1, pose2);
    Jacobian<M, rows> J;
    for (int k = 0; k < M::linear - 1; ++k)
      set_row_carried<M, rows>(J, k, rotate(pose1.rotation, across.col(k)), r1, r2, d);
    right.set_rows(J, pose1, pose2);
    return J;
  }

  /// Throws std::invalid_argument for softness < 0, directions that are not orthonormal, a rotation that is none,
  /// or anchors that name no bodies.
  void require_valid(const Bodies<M>& bodies) const {
    at.require_valid(bodies);
    require_orthonormal("directions across the slider", across);
    require_rotation<M>(right.rest);
    require_in("softness", softness, 0, 1e300);
  }
};

/// A slider along a world axis of any length, at a world point [m] of two bodies as they now stand.
template <class M>
Slider<M> slider(const Bodies<M>& bodies, int body1, int body2, const Linear<M>& point, const Linear<M>& axis) {
  const Anchors<M> at = between<M>(bodies, body1, point, body2, point);
  const Linear<M> carried = rotate(inverse(bodies.pose[body1].rotation), unit_axis(axis));
  return {at, tangents_of<M>(carried), orientation<M>(bodies, body1, body2)};
}

BYHAND_STORE_IN_LIBRARY(PlaneBody, Slider);
BYHAND_STORE_IN_LIBRARY(SpaceBody, Slider);

}  // namespace byhand
