#pragma once

#include "solver/constraints/anchors.hpp"

// The rotation of body 2 relative to body 1 since a rest position, which some joints hold at zero.
//
// In the plane C = φ, the angle between them, so Ċ = ω2 - ω1 and J = [ 0  -1  0  1 ].
//
// In space e = q2 q0 q1⁻¹ = w + v is the rotation off the rest position, in world axes; e = 1 at rest. A rotation
// by φ about the unit vector a has w = cos(φ/2), v = a sin(φ/2).
//
//   C                C = 4σ,  σ = v/(1 + w) = a tan(φ/4)          three numbers, φ a to third order     [rad]
//   differentiate    ė = ½(ω2 e - e ω1), that is ẇ = -½ v·(ω2 - ω1), v̇ = ½w (ω2 - ω1) - ½ v × (ω2 + ω1), and
//                    Ċ = 4v̇/(1 + w) - 4v ẇ/(1 + w)²
//   isolate V        w and v by σ:  Ċ = B ω2 - Bᵀ ω1,  B = (1 - σ²) 1 - 2 [σ]× + 2 σσᵀ
//   J by inspection  J = [ 0  -Bᵀ  0  B ]
//
// B Bᵀ = (1 + σ²)² 1: the gradient never vanishes, whereas that of v alone does at half a turn. (σ are the
// modified Rodrigues parameters: M. D. Shuster, A survey of attitude representations, J. Astronautical Sciences
// 41, 1993.) e and -e are the same rotation; the one with w >= 0 gives the shorter way back.
namespace byhand {

template <class M>
struct Orientation {
  static_assert(M::angular > 0, "a particle has no orientation");
  Rotation<M> rest = Pose<M>().rotation;  // q0: body 1's orientation in body 2's axes at rest

  /// φ or 4σ at two poses [rad], for any scalar.
  template <class T>
  Angular<M, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    const Rotation<M, T> q0 = cast<T>(Pose<M>{Linear<M>::Zero(), rest}).rotation;
    const Rotation<M, T> off = pose2.rotation * q0 * inverse(pose1.rotation);
    if constexpr (M::angular == 1) {
      return Angular<M, T>(principal_angle<T>(off));
    } else {
      const double sign = detail::value_of(off.w()) < 0 ? -1 : 1;
      return Angular<M, T>(off.vec() * T(4 * sign / (1.0 + sign * off.w())));
    }
  }

  /// B at two poses: 1 in the plane.
  Eigen::Matrix<double, M::angular, M::angular> slope(const Pose<M>& pose1, const Pose<M>& pose2) const {
    if constexpr (M::angular == 1) {
      return Eigen::Matrix<double, 1, 1>(1);
    } else {
      const Eigen::Vector3d s = value<double>(pose1, pose2) / 4;
      Eigen::Matrix3d B = 2 * s * s.transpose();
      B.diagonal().array() += 1 - s.squaredNorm();
      B(0, 1) += 2 * s.z(), B(0, 2) -= 2 * s.y(), B(1, 2) += 2 * s.x();
      B(1, 0) -= 2 * s.z(), B(2, 0) += 2 * s.y(), B(2, 1) -= 2 * s.x();
      return B;
    }
  }

  /// Sets the last rows of J.
  template <int K>
  void set_rows(Jacobian<M, K>& J, const Pose<M>& pose1, const Pose<M>& pose2) const {
    const auto B = slope(pose1, pose2);
    auto rows = J.matrix.template bottomRows<M::angular>();
    rows.setZero();
    rows.template middleCols<M::angular>(M::linear) = -B.transpose();
    rows.template rightCols<M::angular>() = B;
  }

  void require_valid() const { byhand::require_valid(Pose<M>{Linear<M>::Zero(), rest}); }
};

/// The orientation whose rest position is the bodies' current poses. Throws std::invalid_argument for other
/// bodies.
template <class M>
Orientation<M> orientation(const Bodies<M>& bodies, int body1, int body2) {
  for (const int body : {body1, body2}) require_body(bodies, body);
  return {inverse(bodies.pose[body2].rotation) * bodies.pose[body1].rotation};
}

}  // namespace byhand
