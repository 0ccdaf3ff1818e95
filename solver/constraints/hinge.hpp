#pragma once

#include "solver/constraints/friction.hpp"
#include "solver/constraints/pin.hpp"
#include "solver/constraints/slide.hpp"

// A door in space: two points coincide and two axes stay parallel. a2 is the axis in body 2; t_k are two
// directions across the axis in body 1. (In the plane a Pin is the hinge.)
//
//   C                three rows of Pin [m], then C_k = t_k · a2, the sine of what is off            [1]
//   differentiate    Ċ_k = (ω1 × t_k) · a2 + t_k · (ω2 × a2)
//   isolate V        Ċ_k = (a2 × t_k) · (ω2 - ω1)      (triple product, twice)
//   J by inspection  J = [ -e_k    -r1 × e_k   e_k   r2 × e_k ]
//                        [   0    -(a2 × t_k)   0    a2 × t_k ]
//
// Five rows. The sine has its second root at half a turn, where the axes point at each other: a hinge that is torn
// further than a right angle goes there.
namespace byhand {

template <class M>
struct Hinge {
  static_assert(std::is_same_v<M, SpaceBody>, "in the plane a Pin is the hinge");
  static constexpr int rows = 5;
  static constexpr Bound bound = Bound::none;
  static constexpr int position_rows = rows;

  Anchors<M> at;
  Eigen::Matrix<double, 3, 2> across =
      tangents_of<M>(Linear<M>::UnitZ());  // t_k, as columns, in the frame of body 1
  Linear<M> axis = Linear<M>::UnitZ();     // a2, in the frame of body 2
  double softness = 0;                     // γ [1/kg] >= 0

  /// P2 - P1 and t_k · a2 at two poses [m, 1], for any scalar.
  template <class T>
  Rows<rows, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    const Linear<M, T> a2 = rotate(pose2.rotation, axis.template cast<T>());
    Rows<rows, T> C;
    C << at.separation(pose1, pose2),
        across.transpose().template cast<T>() * Linear<M, T>(rotate(inverse(pose1.rotation), a2));
    return C;
  }

  /// J at two poses [1 and m; 1].
  Jacobian<M, rows> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    const Linear<M> a2 = rotate(pose2.rotation, axis), none = Linear<M>::Zero();
    Jacobian<M, rows> J;
    J.matrix.template topRows<3>() = Pin<M>{at}.jacobian(pose1, pose2).matrix;
    for (int k = 0; k < 2; ++k) {
      const Linear<M> about = cross(a2, Linear<M>(rotate(pose1.rotation, across.col(k))));
      J.set_row(3 + k, none, -about, none, about);
    }
    return J;
  }

  /// Throws std::invalid_argument for softness < 0, axes that are not of length 1, or anchors that name no bodies.
  void require_valid(const Bodies<M>& bodies) const {
    at.require_valid(bodies);
    require_unit_axis(axis);
    require_orthonormal("directions across the hinge", across);
    require_in("softness", softness, 0, 1e300);
  }
};

/// A hinge about a world axis of any length, at a world point [m] of two bodies as they now stand.
template <class M>
Hinge<M> hinge(const Bodies<M>& bodies, int body1, int body2, const Linear<M>& point, const Linear<M>& axis) {
  const Anchors<M> at = between<M>(bodies, body1, point, body2, point);
  const auto carried_by = [&](int body) {
    return Linear<M>(rotate(inverse(bodies.pose[body].rotation), unit_axis(axis)));
  };
  return {at, tangents_of<M>(carried_by(body1)), carried_by(body2)};
}

BYHAND_STORE_IN_LIBRARY(SpaceBody, Hinge);

}  // namespace byhand
