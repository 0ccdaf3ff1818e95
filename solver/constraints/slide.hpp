#pragma once

#include "solver/constraints/anchors.hpp"

// How far a point of body 2 has gone along an axis u that body 1 carries: what a slider leaves free, and what
// limits and motors act on.
//
//   C                s = u · d,   d = P2 - P1                                                 [m]
//   differentiate    ṡ = u · ((v2 + ω2 × r2) - (v1 + ω1 × r1)) + (ω1 × u) · d
//   isolate V        (ω1 × u) · d = -(d × u) · ω1, so
//                    ṡ = u·v2 + (r2 × u)·ω2 - u·v1 - ((r1 + d) × u)·ω1
//   J by inspection  J = [ -u   -(r1 + d) × u   u   r2 × u ]
//
// r1 + d reaches from the centre of body 1 to P2: the axis takes hold of body 1 where the slide now is.
namespace byhand {

/// The axis that a joint takes hold along, as a vector of length 1. Throws std::invalid_argument for one without
/// direction.
template <class V>
V unit_axis(const V& axis) {
  const double length = axis.norm();
  require(std::isfinite(length) && length > 0, "length of the axis", length, "positive and finite");
  return axis / length;
}
template <class V>
void require_unit_axis(const V& axis) {
  require_in("length of the axis", axis.norm(), 1 - 1e-9, 1 + 1e-9);
}

/// Throws std::invalid_argument unless the columns are unit vectors at right angles.
template <class Matrix>
void require_orthonormal(std::string_view name, const Matrix& columns) {
  const auto product = (columns.transpose() * columns).eval();
  const double off = (product - product.Identity(product.rows(), product.cols())).norm();
  require_in("distance of the " + std::string(name) + " from orthonormal", off, 0, 1e-9);
}

/// Sets the row of a world direction u that body 1 carries.
template <class M, int K>
void set_row_carried(Jacobian<M, K>& J, int k, const Linear<M>& u, const Linear<M>& r1, const Linear<M>& r2,
                     const Linear<M>& d) {
  J.set_row(k, -u, -cross(Linear<M>(r1 + d), u), u, cross(r2, u));
}

template <class M>
struct Slide : Anchors<M> {
  static_assert(M::angular > 0, "a particle carries no axis");
  Linear<M> axis = Linear<M>::Unit(0);  // u, a unit vector in the frame of body 1

  /// s at two poses [m], for any scalar.
  template <class T>
  T value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    return this->separation(pose1, pose2).dot(rotate(pose1.rotation, axis.template cast<T>()));
  }

  /// J at two poses [1, and m].
  Jacobian<M, 1> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    const Linear<M> r1 = in_world<M, double>(pose1, this->arms.first);
    const Linear<M> r2 = in_world<M, double>(pose2, this->arms.second);
    Jacobian<M, 1> J;
    set_row_carried<M, 1>(J, 0, rotate(pose1.rotation, axis), r1, r2, this->separation(pose1, pose2));
    return J;
  }

  /// Throws std::invalid_argument unless the axis has length 1 and the anchors name bodies.
  void require_valid(const Bodies<M>& bodies) const {
    Anchors<M>::require_valid(bodies);
    require_unit_axis(axis);
  }
  /// Throws std::invalid_argument for a place [m] that no slide comes to.
  static void require_place(std::string_view name, double place) { require_finite(name, place, "m"); }
};

/// A slide of bodies as they now stand, along a world axis of any length; s is 0 where they stand, at a world
/// point [m].
template <class M>
Slide<M> slide(const Bodies<M>& bodies, int body1, int body2, const Linear<M>& point, const Linear<M>& axis) {
  const Anchors<M> at = between<M>(bodies, body1, point, body2, point);
  return {at, rotate(inverse(bodies.pose[body1].rotation), unit_axis(axis))};
}

}  // namespace byhand
