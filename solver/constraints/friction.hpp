#pragma once

#include "solver/constraints/anchors.hpp"

// Two touching bodies rub: along each tangent t_k of the contact (one axis in the plane, two in space) they
// slip as little as a limited impulse allows. There is no C to keep, only a velocity; `value` is the slip
// whose rate J measures.
//
//   slip              s_k = t_k · (P2 - P1), t held still over a step                             [m]
//   differentiate     ṡ_k = t_k · ((v2 + ω2 × r2) - (v1 + ω1 × r1))
//   isolate V         ṡ_k = t_k·v2 + (r2 × t_k)·ω2 - t_k·v1 - (r1 × t_k)·ω1     (triple product, as in (13))
//   J by inspection,  J_k = [ -t_k   -r1 × t_k   t_k   r2 × t_k ]
//   (16)
//
// The bound is Coulomb's: |λ| <= μ λ_normal, in the plane an interval, in space a disc [N s].
namespace byhand {

template <class M>
struct Friction {
  static constexpr int rows = M::linear - 1;
  static constexpr Bound bound = Bound::friction;
  static constexpr int position_rows = 0;

  Anchors<M> at;
  Eigen::Matrix<double, M::linear, rows> tangents;  // t_k, unit vectors in the world, as columns
  double coefficient = 0;                           // μ >= 0
  int contact = 0;                                  // the contact that presses, by its handle
  double softness = 0;                              // γ [1/kg] >= 0

  /// The slip at two poses [m], for any scalar.
  template <class T>
  Rows<rows, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    return tangents.transpose().template cast<T>() * at.separation(pose1, pose2);
  }

  //! [jacobian]
  /// (16) at two poses [1, and m where a body turns].
  Jacobian<M, rows> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    const Arm<M> r1 = in_world<M, double>(pose1, at.arms.first), r2 = in_world<M, double>(pose2, at.arms.second);
    Jacobian<M, rows> J;
    for (int k = 0; k < rows; ++k) set_row_along<M, rows>(J, k, Linear<M>(tangents.col(k)), r1, r2);
    return J;
  }
  //! [jacobian]

  /// Throws std::invalid_argument unless the tangents are orthonormal, μ >= 0 and softness >= 0.
  void require_valid(const Bodies<M>& bodies) const {
    at.require_valid(bodies);
    const double off = (tangents.transpose() * tangents - Eigen::Matrix<double, rows, rows>::Identity()).norm();
    require_in("distance of the tangents from orthonormal", off, 0, 1e-9);
    require_in("friction coefficient", coefficient, 0, 1e300);
    require_in("softness", softness, 0, 1e300);
  }
};

/// Unit tangents of a unit normal, as columns: in the plane n turned by -90°, in space two that make (t1, t2,
/// n) right-handed.
template <class M>
Eigen::Matrix<double, M::linear, M::linear - 1> tangents_of(const Linear<M>& normal) {
  if constexpr (M::linear == 2) {
    return {normal.y(), -normal.x()};
  } else {
    Eigen::Matrix<double, 3, 2> t;
    const Eigen::Vector3d away = std::abs(normal.x()) < 0.6 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
    t.col(0) = (away - normal * normal.dot(away)).normalized();
    t.col(1) = normal.cross(t.col(0));
    return t;
  }
}

BYHAND_STORES_IN_LIBRARY(Friction);

}  // namespace byhand
