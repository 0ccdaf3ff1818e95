#pragma once

#include "solver/constraints/anchors.hpp"

// Two bodies do not penetrate each other at a given point along a given normal n, from body 1 to body 2.
//
//   C, (23)              C = ((x2 + r2) - (x1 + r1)) · n >= 0, the separation; overlap is negative       [m]
//   differentiate        Ċ = n · ((v2 + ω2 × r2) - (v1 + ω1 × r1)); n is constant over a step, so the term
//                        (P2 - P1)·ṅ is dropped, which is small where bodies touch
//   isolate V            Ċ = n·v2 + (r2 × n)·ω2 - n·v1 - (r1 × n)·ω1      (triple product, as in (13))
//   J by inspection,(15) J = [ -n   -r1 × n   n   r2 × n ]
//
// One-sided: the accumulated λ >= 0 pushes the bodies apart [N s].
namespace byhand {

template <class M>
struct Contact {
  static constexpr int rows = 1;
  static constexpr Bound bound = Bound::interval;
  static constexpr bool holds_where_found = true;

  Anchors<M> at;
  Linear<M> normal = Linear<M>::Unit(M::linear - 1);  // n, a unit vector in the world
  double softness = 0;                                // γ [1/kg] >= 0
  double restitution = 0;                             // e in [0, 1]

  template <class T>
  Rows<1, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    return Rows<1, T>(at.separation(pose1, pose2).dot(normal.template cast<T>()));
  }

  //! [jacobian]
  /// (15) at two poses [1, and m where a body turns].
  Jacobian<M, 1> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    const Arm<M> r1 = in_world<M, double>(pose1, at.arms.first), r2 = in_world<M, double>(pose2, at.arms.second);
    Jacobian<M, 1> J;
    set_row_along<M, 1>(J, 0, normal, r1, r2);
    return J;
  }
  //! [jacobian]

  void require_valid(const Bodies<M>&) const { require_unit("length of the normal", normal.norm()); }
};

BYHAND_STORES(extern, Contact);

}  // namespace byhand
