#pragma once

#include "solver/constraints/pin.hpp"

// A door in space: two points coincide and two axes stay parallel. a2 is the axis in body 2; t_k are two
// directions across the axis in body 1. (In the plane a Pin is the hinge.)
//
//   C                three rows of Pin [m], then C_k = t_k · a2, the sine of the angle between the axes  [1]
//   differentiate    Ċ_k = (ω1 × t_k) · a2 + t_k · (ω2 × a2)
//   isolate V        Ċ_k = (a2 × t_k) · (ω2 - ω1)      (triple product, twice)
//   J by inspection  J = [ -e_k    -r1 × e_k   e_k   r2 × e_k ]
//                        [   0    -(a2 × t_k)   0    a2 × t_k ]
//
// Five rows. The sine has a second root at half a turn, where the axes are opposite: a hinge that is torn open by
// more than a right angle goes there.
namespace byhand {

template <class M>
struct Hinge {
  static_assert(std::is_same_v<M, SpaceBody>, "in the plane a Pin is the hinge");
  static constexpr int rows = 5;

  Anchors<M> at;
  Packed<double, 3, 2> across = tangents_of<M>(Linear<M>::UnitZ());  // t_k, as columns, in the frame of body 1
  Linear<M> axis = Linear<M>::UnitZ();                               // a2, in the frame of body 2
  double softness = 0;                                               // γ [1/kg] >= 0

  template <class T>
  Rows<rows, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    const Linear<M, T> a2 = rotate(pose2.rotation, axis.template cast<T>());
    Rows<rows, T> C;
    C << at.separation(pose1, pose2),
        across.transpose().template cast<T>() * Linear<M, T>(rotate(inverse(pose1.rotation), a2));
    return C;
  }

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

  void require_valid(const Bodies<M>&) const {
    require_unit("length of the axis", axis.norm());
    require_orthonormal("directions across the hinge", across);
  }
};

/// A hinge about a world axis of any length, at a world point [m] of two bodies at their current poses.
template <class M>
Hinge<M> hinge(const Bodies<M>& bodies, int body1, int body2, const Linear<M>& point, const Linear<M>& axis) {
  const Anchors<M> at = between<M>(bodies, body1, point, body2, point);
  return {at, tangents_of<M>(axis_in<M>(bodies, body1, axis)), axis_in<M>(bodies, body2, axis)};
}

extern BYHAND_STORE(SpaceBody, Hinge);

}  // namespace byhand
