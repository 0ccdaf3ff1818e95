#pragma once

#include "solver/constraints/anchors.hpp"

// The article's rod: two points keep the distance L.
//
//   C, (2)                  C = ½[(P2 - P1)² - L²]                                              [m²]
//   differentiate, (9)(10)  Ċ = d · ((v2 + ω2 × r2) - (v1 + ω1 × r1)),   d = P2 - P1 (11)       [m²/s]
//   isolate V, (12)(13)     d · (ω × r) = ω · (r × d), the triple product, so
//                           Ċ = d·v2 + (r2 × d)·ω2 - d·v1 - (r1 × d)·ω1
//   J by inspection, (14)   J = [ -d   -r1 × d   d   r2 × d ]
//
// P: anchor points, r: arms from the centres of mass to them, v and ω: velocities, L: length of the rod.
// (14) is not divided by |d|: its λ is in N s/m, and a rod under tension has λ < 0.
namespace byhand {

template <class M>
struct Distance {
  static constexpr int rows = 1;

  Anchors<M> at;
  double length = 1;    // L [m] > 0
  double softness = 0;  // γ [m²/kg, the unit of JM⁻¹Jᵀ] >= 0

  //! [value]
  /// (2) at two poses [m²], for any scalar.
  template <class T>
  Rows<1, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    const Linear<M, T> d = at.separation(pose1, pose2);
    return Rows<1, T>(0.5 * (d.squaredNorm() - length * length));
  }
  //! [value]

  Jacobian<M, 1> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    const Arm<M> r1 = in_world<M, double>(pose1, at.arms.first), r2 = in_world<M, double>(pose2, at.arms.second);
    Jacobian<M, 1> J;
    set_row_along<M, 1>(J, 0, Linear<M>(anchor<M, double>(pose2, r2) - anchor<M, double>(pose1, r1)), r1, r2);
    return J;
  }

  void require_valid(const Bodies<M>& bodies) const { at.require_rod(length, bodies); }
};

BYHAND_STORES(extern, Distance);

}  // namespace byhand
