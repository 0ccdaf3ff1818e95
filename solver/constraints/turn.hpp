#pragma once

#include "solver/constraints/orientation.hpp"
#include "solver/constraints/slide.hpp"

// The angle by which body 2 has turned against body 1, about an axis a that body 1 carries: what a hinge leaves
// free, and what limits and motors act on.
//
// In the plane C = φ, Ċ = ω2 - ω1 and J = [ 0  -1  0  1 ].
//
//   C                in space p = q1⁻¹ q2 q0 = w + v is the turn in body 1's axes; with z = v·a,
//                    φ = 2 arctan(z/w), the angle of the part of p that is about a                [rad]
//   differentiate    ṗ = ½ Ω p, Ω = ω2 - ω1 in body 1's axes: ẇ = -½ Ω·v, v̇ = ½ (wΩ + Ω × v), and
//                    φ̇ = 2 (wż - zẇ)/(w² + z²)
//   isolate V        φ̇ = g·(ω2 - ω1),  g = (w² a + w v × a + z v)/(w² + z²)     (triple product)
//   J by inspection  J = [ 0  -g  0  g ]
//
// While a hinge holds, v is along a and g is the axis itself. φ is in [-π, π] and counts from where the bodies
// stood when the turn was made; anticlockwise, or right-handed about a, is positive.
namespace byhand {

template <class M>
struct Turn {
  using Axis = std::conditional_t<M::angular == 3, Linear<M>, NoArm>;

  int body1 = 0, body2 = 0;
  Rotation<M> rest = Pose<M>().rotation;  // q0: body 1's orientation in body 2's axes at φ = 0
  [[no_unique_address]] Axis axis = {};   // a, in the frame of body 1

  /// φ at two poses [rad], for any scalar.
  template <class T>
  T value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    const Rotation<M, T> p = since_rest(pose1, pose2);
    if constexpr (M::angular == 1) {
      return principal_angle<T>(p);
    } else {
      using std::sqrt;
      const T z = p.vec().dot(axis.template cast<T>()), norm2 = p.w() * p.w() + z * z;
      if (detail::value_of(norm2) == 0) return T(0);  // half a turn across the axis has no part about it
      const T norm = sqrt(norm2), to_half = detail::value_of(p.w()) < 0 ? T(-1.0 / norm) : T(1.0 / norm);
      return angle_from_half<T>({T(z * to_half), T(p.w() * to_half)});
    }
  }

  /// J at two poses [1].
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

  /// Throws std::invalid_argument unless the axis has length 1, the rotation is one and there are two bodies.
  void require_valid(const Bodies<M>& bodies) const {
    Anchors<M>{body1, body2}.require_valid(bodies);
    require_rotation<M>(rest);
    if constexpr (M::angular == 3) require_unit_axis(axis);
  }
  /// Throws std::invalid_argument for an angle [rad] that no turn comes to.
  static void require_place(std::string_view name, double angle) {
    require_inside(name, angle, -3.14, 3.14, "rad");
  }

 private:
  template <class T>
  Rotation<M, T> since_rest(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    Pose<M> at_rest;
    at_rest.rotation = rest;
    return inverse(pose1.rotation) * pose2.rotation * cast<T, M>(at_rest).rotation;
  }
};

/// The turn of two bodies in the plane; φ is 0 as they now stand.
template <class M>
requires(M::angular == 1) Turn<M> turn(const Bodies<M>& bodies, int body1, int body2) {
  Anchors<M>{body1, body2}.require_valid(bodies);
  return {body1, body2, orientation<M>(bodies, body1, body2).rest};
}
/// The turn of two bodies in space about a world axis of any length; φ is 0 as they now stand.
template <class M>
requires(M::angular == 3) Turn<M> turn(const Bodies<M>& bodies, int body1, int body2, const Linear<M>& axis) {
  Anchors<M>{body1, body2}.require_valid(bodies);
  return {body1, body2, orientation<M>(bodies, body1, body2).rest,
          rotate(inverse(bodies.pose[body1].rotation), unit_axis(axis))};
}

}  // namespace byhand
