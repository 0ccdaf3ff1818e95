#pragma once

#include "solver/constraint.hpp"

namespace byhand {

/// The arms of a constraint's two anchors, each in the frame of its body [m]; particles have none, in no space.
template <class M>
struct Arms {
  Arm<M> first = Arm<M>::Zero(), second = Arm<M>::Zero();
};
template <int L>
struct Arms<Model<L, 0>> {
  static constexpr NoArm first = {}, second = {};
};

/// The two bodies of a constraint and the points P1 and P2 where it acts on them.
template <class M>
struct Anchors {
  int body1 = 0, body2 = 0;
  [[no_unique_address]] Arms<M> arms = {};

  /// d = P2 - P1 of (11) [m].
  template <class T>
  Linear<M, T> separation(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    return anchor<M, T>(pose2, in_world<M, T>(pose2, arms.second)) -
           anchor<M, T>(pose1, in_world<M, T>(pose1, arms.first));
  }

  /// Throws std::invalid_argument unless both bodies exist and differ and both arms are finite.
  void require_valid(const Bodies<M>& bodies) const {
    require_body(bodies, body1);
    require_body(bodies, body2);
    require(body1 != body2, "body index", body2, "another one than the constraint's first");
    if constexpr (M::angular > 0)
      for (const Arm<M>& arm : {arms.first, arms.second})
        for (const double r : arm) require_finite("arm", r, "m");
  }
  /// Throws std::invalid_argument for a rod of length <= 0 or one whose ends coincide, for then d has no
  /// direction.
  void require_rod(double length, const Bodies<M>& bodies) const {
    require_positive("length", length, "m");
    const double distance = separation(bodies.pose[body1], bodies.pose[body2]).norm();
    require(distance > 0, "distance between the rod's ends", distance, "above zero [m], or J has no direction");
  }
};

/// Anchors at two world points [m] of two bodies at their current poses.
template <class M>
Anchors<M> between(const Bodies<M>& bodies, int body1, const Linear<M>& point1, int body2,
                   const Linear<M>& point2) {
  require_body(bodies, body1);
  require_body(bodies, body2);
  Anchors<M> anchors{body1, body2};
  if constexpr (M::angular > 0)
    anchors.arms = {arm_to<M>(bodies.pose[body1], point1), arm_to<M>(bodies.pose[body2], point2)};
  return anchors;
}

/// A world axis of any length > 0 as a unit vector in a body's frame. Throws std::invalid_argument for other axes
/// and bodies.
template <class M>
Linear<M> axis_in(const Bodies<M>& bodies, int body, const Linear<M>& axis) {
  const double length = axis.norm();
  require(std::isfinite(length) && length > 0, "length of the axis", length, "positive and finite");
  require_body(bodies, body);
  return rotate(inverse(bodies.pose[body].rotation), Linear<M>(axis / length));
}

/// Unit vectors at right angles to a unit normal, as columns: in the plane n turned by -90°, in space two such
/// that (t1, t2, n) is right-handed.
template <class M>
Packed<double, M::linear, M::linear - 1> tangents_of(const Linear<M>& normal) {
  if constexpr (M::linear == 2) {
    return {normal.y(), -normal.x()};
  } else {
    Packed<double, 3, 2> t;
    const Eigen::Vector3d away = std::abs(normal.x()) < 0.6 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
    t.col(0) = (away - normal * normal.dot(away)).normalized();
    t.col(1) = normal.cross(t.col(0));
    return t;
  }
}

/// Throws std::invalid_argument unless the columns are unit vectors at right angles, to 1e-9.
template <class Matrix>
void require_orthonormal(const std::string& name, const Matrix& columns) {
  const auto product = (columns.transpose() * columns).eval();
  require_in("distance of the " + name + " from orthonormal", (product - product.Identity()).norm(), 0, 1e-9);
}

}  // namespace byhand
