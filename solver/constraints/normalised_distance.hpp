#pragma once

#include "solver/constraints/anchors.hpp"

// The same rod with an error in metres.
//
//   C                C = |P2 - P1| - L                                                       [m]
//   differentiate    Ċ = n · ((v2 + ω2 × r2) - (v1 + ω1 × r1)),   n = d/|d|,   d = P2 - P1 (11)
//   isolate V        Ċ = n·v2 + (r2 × n)·ω2 - n·v1 - (r1 × n)·ω1      (triple product, as in (13))
//   J by inspection  J = [ -n   -r1 × n   n   r2 × n ],  (14) divided by |d|
//
// The impulse on the bodies is that of (14) when b = 0; λ is in N s here, and β acts alike for every length.
// This J belongs to this C: mixed with (2), the gain of the correction becomes β L.
namespace byhand {

template <class M>
struct NormalisedDistance {
  static constexpr int rows = 1;
  static constexpr Bound bound = Bound::none;
  static constexpr int position_rows = rows;

  Anchors<M> at;
  double length = 1;    // L [m] > 0
  double softness = 0;  // γ [1/kg] >= 0

  /// |d| - L at two poses [m], for any scalar.
  template <class T>
  Rows<1, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    using std::sqrt;
    const Linear<M, T> d = at.separation(pose1, pose2);
    return Rows<1, T>(T(sqrt(d.squaredNorm()) - length));
  }

  /// J at two poses [1, and m where a body turns]; zero where the points coincide and no direction is
  /// defined.
  Jacobian<M, 1> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    const Arm<M> r1 = in_world<M, double>(pose1, at.arms.first), r2 = in_world<M, double>(pose2, at.arms.second);
    const Linear<M> d = anchor<M, double>(pose2, r2) - anchor<M, double>(pose1, r1);
    const double distance = d.norm();
    const Linear<M> n = distance > 0 ? Linear<M>(d / distance) : Linear<M>::Zero();
    Jacobian<M, 1> J;
    set_row_along<M, 1>(J, 0, n, r1, r2);
    return J;
  }

  /// Throws std::invalid_argument for length <= 0, softness < 0, or points that coincide: n has no direction
  /// there.
  void require_valid(const Bodies<M>& bodies) const {
    at.require_valid(bodies);
    require_positive("length", length, "m");
    require_in("softness", softness, 0, 1e300);
    const double distance = at.separation(bodies.pose[at.body1], bodies.pose[at.body2]).norm();
    require(distance > 0, "distance between the rod's ends", distance, "above zero [m], or J has no direction");
  }
};

BYHAND_STORES_IN_LIBRARY(NormalisedDistance);

}  // namespace byhand
