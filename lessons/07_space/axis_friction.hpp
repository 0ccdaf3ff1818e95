#pragma once

#include "solver/constraints/anchors.hpp"

namespace byhand::space {

/// One axis of friction by itself: (16) along `tangent`, its impulse within ±μ times the leader's, whatever the
/// other axis does. Two of them at right angles are the pyramid. As Friction, but for its one row.
template <class M>
struct AxisFriction {
  static constexpr int rows = 1;
  static constexpr Bound bound = Bound::ball;
  static constexpr int drifting = 0;

  Anchors<M> at;
  Linear<M> tangent;
  double coefficient = 0;
  int leader = 0;
  double softness = 0;

  Jacobian<M, 1> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    const Arm<M> r1 = in_world<M, double>(pose1, at.arms.first), r2 = in_world<M, double>(pose2, at.arms.second);
    Jacobian<M, 1> J;
    set_row_along<M, 1>(J, 0, tangent, r1, r2);
    return J;
  }

  void require_valid(const Bodies<M>& bodies) const { at.require_valid(bodies); }
};

}  // namespace byhand::space
