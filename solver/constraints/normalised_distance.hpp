#pragma once

#include "solver/constraints/anchors.hpp"

// The same rod with an error in metres.
//
//   C                C = |P2 - P1| - L                                                       [m]
//   differentiate    Ċ = n · ((v2 + ω2 × r2) - (v1 + ω1 × r1)),   n = d/|d|,   d = P2 - P1 (11)
//   isolate V        Ċ = n·v2 + (r2 × n)·ω2 - n·v1 - (r1 × n)·ω1      (triple product, as in (13))
//   J by inspection  J = [ -n   -r1 × n   n   r2 × n ],  (14) divided by |d|
//
// With b = 0 the bodies get the same impulse as from (14). λ is in N s here, and β corrects the same share of the
// error whatever the length. This J belongs to this C: combined with (2), the gain of the correction would be β L.
namespace byhand {

template <class M>
struct NormalisedDistance {
  static constexpr int rows = 1;

  Anchors<M> at;
  double length = 1;    // L [m] > 0
  double softness = 0;  // γ [1/kg] >= 0

  template <class T>
  Rows<1, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    using std::sqrt;
    const Linear<M, T> d = at.separation(pose1, pose2);
    return Rows<1, T>(T(sqrt(d.squaredNorm()) - length));
  }

  /// J at two poses; zero where the points coincide, for then n is undefined.
  Jacobian<M, 1> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    const Arm<M> r1 = in_world<M, double>(pose1, at.arms.first), r2 = in_world<M, double>(pose2, at.arms.second);
    const Linear<M> d = anchor<M, double>(pose2, r2) - anchor<M, double>(pose1, r1);
    const double distance = d.norm();
    const Linear<M> n = distance > 0 ? Linear<M>(d / distance) : Linear<M>::Zero();
    Jacobian<M, 1> J;
    set_row_along<M, 1>(J, 0, n, r1, r2);
    return J;
  }

  void require_valid(const Bodies<M>& bodies) const { at.require_rod(length, bodies); }
};

BYHAND_STORES(extern, NormalisedDistance);

}  // namespace byhand
