#pragma once

#include <array>
#include <limits>

#include "solver/constraints/anchors.hpp"

// Two bodies do not enter each other, at a point and along a normal that are given.
//
//   C, (23)              C = ((x2 + r2) - (x1 + r1)) · n >= 0, the separation; overlap is negative       [m]
//   differentiate        Ċ = n · ((v2 + ω2 × r2) - (v1 + ω1 × r1)), with the term (P2 - P1)·ṅ dropped: n is
//   held still
//                        over a step, and P2 - P1 is small where bodies touch
//   isolate V            Ċ = n·v2 + (r2 × n)·ω2 - n·v1 - (r1 × n)·ω1      (triple product, as in (13))
//   J by inspection,(15) J = [ -n   -r1 × n   n   r2 × n ]
//
// n points from body 1 to body 2, so λ >= 0 pushes them apart: the bound is on the accumulated λ [N s].
namespace byhand {

template <class M>
struct Contact {
  static constexpr int rows = 1;
  static constexpr Bound bound = Bound::interval;
  static constexpr int position_rows = rows;

  Anchors<M> at;
  Linear<M> normal = Linear<M>::Unit(M::linear - 1);  // n, a unit vector in the world
  double softness = 0;                                // γ [1/kg] >= 0
  double restitution = 0;                             // e in [0, 1]

  static constexpr std::array<double, 2> bounds(double /*h*/) {
    return {0, std::numeric_limits<double>::infinity()};
  }

  /// (23) at two poses [m], for any scalar; n stays as it is, or (15) would not be the gradient.
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

  /// Throws std::invalid_argument unless the normal has length 1, e is in [0, 1] and softness >= 0.
  void require_valid(const Bodies<M>& bodies) const {
    at.require_valid(bodies);
    require_in("length of the normal", normal.norm(), 1 - 1e-9, 1 + 1e-9);
    require_in("restitution", restitution, 0, 1);
    require_in("softness", softness, 0, 1e300);
  }
};

BYHAND_STORES_IN_LIBRARY(Contact);

}  // namespace byhand
