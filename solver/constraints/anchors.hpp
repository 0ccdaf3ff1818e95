#pragma once

#include "solver/constraint.hpp"

namespace byhand {

/// The arms of a constraint's two anchors, each in the frame of its body [m]; a particle has none, and they take
/// no space.
template <class M>
struct Arms {
  Arm<M> first = Arm<M>::Zero(), second = Arm<M>::Zero();
};
template <int L>
struct Arms<Model<L, 0>> {
  static constexpr NoArm first = {}, second = {};
};

/// The two bodies of a constraint and the points where it holds them; the arms are in the frames of their
/// bodies [m].
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

  /// Throws std::invalid_argument unless both indices name bodies, two different ones, and both arms are
  /// finite.
  void require_valid(const Bodies<M>& bodies) const {
    require_body(bodies, body1);
    require_body(bodies, body2);
    require(body1 != body2, "body index", body2, "another one than the constraint's first");
    if constexpr (M::angular > 0)
      for (const Arm<M>& arm : {arms.first, arms.second})
        for (const double r : arm) require_finite("arm", r, "m");
  }
};

/// Anchors at two world points [m] of two bodies as they now stand.
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

}  // namespace byhand
