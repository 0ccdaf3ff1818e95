#pragma once

#include "solver/constraints/orientation.hpp"

namespace byhand {

// Freedoms q that joints leave, and on which limits, motors and servos act.
//
// Of a slider: the distance s that a point of body 2 has moved along an axis u of body 1.
//
//   C                s = u · d,   d = P2 - P1                                                 [m]
//   differentiate    ṡ = u · ((v2 + ω2 × r2) - (v1 + ω1 × r1)) + (ω1 × u) · d
//   isolate V        (ω1 × u) · d = -(d × u) · ω1, so
//                    ṡ = u·v2 + (r2 × u)·ω2 - u·v1 - ((r1 + d) × u)·ω1
//   J by inspection  J = [ -u   -(r1 + d) × u   u   r2 × u ]
//
// r1 + d is the arm from the centre of body 1 to P2, where the axis acts on body 1.
template <class M>
struct Slide : Anchors<M> {
  static_assert(M::angular > 0, "an axis needs a body that turns");
  Linear<M> axis = Linear<M>::Unit(0);  // u, a unit vector in the frame of body 1

  /// s at two poses [m], for any scalar.
  template <class T>
  T value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    return this->separation(pose1, pose2).dot(rotate(pose1.rotation, axis.template cast<T>()));
  }

  Jacobian<M, 1> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    const Linear<M> r1 = in_world<M, double>(pose1, this->arms.first);
    const Linear<M> r2 = in_world<M, double>(pose2, this->arms.second);
    Jacobian<M, 1> J;
    set_row_along<M, 1>(J, 0, rotate(pose1.rotation, axis), r1 + this->separation(pose1, pose2), r2);
    return J;
  }

  void require_valid(const Bodies<M>& bodies) const {
    Anchors<M>::require_valid(bodies);
    require_unit("length of the axis", axis.norm());
  }
  /// Throws std::invalid_argument for an s [m] that cannot be reached.
  static void require_place(std::string_view name, double place) { require_finite(name, place, "m"); }
};

/// A slide along a world axis of any length from a world point [m]; s = 0 at the bodies' current poses.
template <class M>
Slide<M> slide(const Bodies<M>& bodies, int body1, int body2, const Linear<M>& point, const Linear<M>& axis) {
  return {between<M>(bodies, body1, point, body2, point), axis_in<M>(bodies, body1, axis)};
}

// Of a hinge: the angle φ of body 2 relative to body 1, about an axis a of body 1.
//
// In the plane C = φ, Ċ = ω2 - ω1 and J = [ 0  -1  0  1 ].
//
//   C                in space p = q1⁻¹ q2 q0 = w + v is the rotation in body 1's axes; with z = v·a,
//                    φ = 2 arctan(z/w), the angle of the part of p that is about a                [rad]
//   differentiate    ṗ = ½ Ω p, Ω = ω2 - ω1 in body 1's axes: ẇ = -½ Ω·v, v̇ = ½ (wΩ + Ω × v), and
//                    φ̇ = 2 (wż - zẇ)/(w² + z²)
//   isolate V        φ̇ = g·(ω2 - ω1),  g = (w² a + w v × a + z v)/(w² + z²)     (triple product)
//   J by inspection  J = [ 0  -g  0  g ]
//
// While a hinge holds, v is along a and g is the axis itself. φ is in [-π, π], zero at the poses at which the turn
// was made, and positive anticlockwise, or right-handed about a.
template <class M>
struct Turn {
  using Axis = std::conditional_t<M::angular == 3, Linear<M>, NoArm>;

  int body1 = 0, body2 = 0;
  Rotation<M> rest = Pose<M>().rotation;  // q0: body 1's orientation in body 2's axes at φ = 0
  [[no_unique_address]] Axis axis = {};   // a, a unit vector in the frame of body 1

  /// φ at two poses [rad], for any scalar.
  template <class T>
  T value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    const Rotation<M, T> p = since_rest(pose1, pose2);
    if constexpr (M::angular == 1) {
      return principal_angle<T>(p);
    } else {
      using std::sqrt;
      const T z = p.vec().dot(axis.template cast<T>()), norm2 = p.w() * p.w() + z * z;
      if (detail::value_of(norm2) == 0) return T(0);  // half a turn about an axis across a
      const T norm = sqrt(norm2), to_half = detail::value_of(p.w()) < 0 ? T(-1.0 / norm) : T(1.0 / norm);
      return angle_from_half<T>({T(z * to_half), T(p.w() * to_half)});
    }
  }

  Jacobian<M, 1> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    Angular<M> g = Angular<M>::Zero();
    if constexpr (M::angular == 1) {
      g[0] = 1;
    } else {
      const Rotation<M> p = since_rest(pose1, pose2);
      const Linear<M> v = p.vec();
      const double w = p.w(), z = v.dot(axis), norm2 = w * w + z * z;
      if (norm2 > 0) g = rotate(pose1.rotation, Linear<M>((w * w * axis + w * v.cross(axis) + z * v) / norm2));
    }
    Jacobian<M, 1> J;
    J.set_row(0, Linear<M>::Zero(), -g, Linear<M>::Zero(), g);
    return J;
  }

  void require_valid(const Bodies<M>& bodies) const {
    Anchors<M>{body1, body2}.require_valid(bodies);
    Orientation<M>{rest}.require_valid();
    if constexpr (M::angular == 3) require_unit("length of the axis", axis.norm());
  }
  /// Throws std::invalid_argument for a φ [rad] that cannot be reached.
  static void require_place(std::string_view name, double angle) {
    require_inside(name, angle, -3.14, 3.14, "rad");
  }

 private:
  template <class T>
  Rotation<M, T> since_rest(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    return inverse(pose1.rotation) * pose2.rotation * cast<T>(Pose<M>{Linear<M>::Zero(), rest}).rotation;
  }
};

/// The turn of two bodies in the plane; φ = 0 at their current poses.
template <class M>
requires(M::angular == 1) Turn<M> turn(const Bodies<M>& bodies, int body1, int body2) {
  Anchors<M>{body1, body2}.require_valid(bodies);
  return {body1, body2, orientation<M>(bodies, body1, body2).rest};
}
/// The turn of two bodies in space about a world axis of any length; φ = 0 at their current poses.
template <class M>
requires(M::angular == 3) Turn<M> turn(const Bodies<M>& bodies, int body1, int body2, const Linear<M>& axis) {
  Anchors<M>{body1, body2}.require_valid(bodies);
  return {body1, body2, orientation<M>(bodies, body1, body2).rest, axis_in<M>(bodies, body1, axis)};
}

// Of a ball joint in space: the angle ψ between an axis a of body 1 and an axis b of body 2. A stop keeps b within
// a cone about a.
//
//   C                ψ = 2 arctan(|a - b| / |a + b|)                                               [rad]
//   differentiate    cos ψ = a·b, so -sin ψ ψ̇ = (ω1 × a)·b + a·(ω2 × b), with a × b = sin ψ n
//   isolate V        ψ̇ = n·(ω2 - ω1)                                                  (triple product)
//   J by inspection  J = [ 0  -n  0  n ]
//
// ψ is in [0, π]. Where the axes are parallel n has no direction, and J is 0.
template <class M>
struct Swing {
  static_assert(M::angular == 3, "in the plane two axes make one angle: see Turn");
  int body1 = 0, body2 = 0;
  Linear<M> axis1 = Linear<M>::Unit(0), axis2 = Linear<M>::Unit(0);  // a and b, unit vectors in the bodies' frames

  template <class T>
  T value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    const Linear<M, T> a = rotate(pose1.rotation, axis1.template cast<T>()),
                       b = rotate(pose2.rotation, axis2.template cast<T>());
    return angle_from_half<T>({T((a - b).norm() / 2.0), T((a + b).norm() / 2.0)});
  }

  Jacobian<M, 1> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    const Linear<M> n = rotate(pose1.rotation, axis1).cross(rotate(pose2.rotation, axis2)).stableNormalized();
    Jacobian<M, 1> J;
    J.set_row(0, Linear<M>::Zero(), -n, Linear<M>::Zero(), n);
    return J;
  }

  void require_valid(const Bodies<M>& bodies) const {
    Anchors<M>{body1, body2}.require_valid(bodies);
    for (const Linear<M>& axis : {axis1, axis2}) require_unit("length of the axis", axis.norm());
  }
  /// Throws std::invalid_argument for a ψ [rad] that has no cone.
  static void require_place(std::string_view name, double angle) { require_inside(name, angle, 0, 3.14, "rad"); }
};

/// The swing of a world axis of any length that both bodies take along; ψ = 0 at their current poses.
template <class M>
Swing<M> swing(const Bodies<M>& bodies, int body1, int body2, const Linear<M>& axis) {
  Anchors<M>{body1, body2}.require_valid(bodies);
  return {body1, body2, axis_in<M>(bodies, body1, axis), axis_in<M>(bodies, body2, axis)};
}

/// BYHAND_STORE for a kind that acts on a freedom.
#define BYHAND_STORE_OF_FREEDOM(M, Kind, Freedom) \
  template std::unique_ptr<ConstraintStore<M>> make_store<M, Kind<M, Freedom>>()
#define BYHAND_STORES_OF_FREEDOMS(prefix, Kind)           \
  prefix BYHAND_STORE_OF_FREEDOM(PlaneBody, Kind, Slide); \
  prefix BYHAND_STORE_OF_FREEDOM(PlaneBody, Kind, Turn);  \
  prefix BYHAND_STORE_OF_FREEDOM(SpaceBody, Kind, Slide); \
  prefix BYHAND_STORE_OF_FREEDOM(SpaceBody, Kind, Turn)

}  // namespace byhand
