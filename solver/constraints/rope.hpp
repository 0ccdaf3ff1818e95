#pragma once

#include "solver/constraints/normalised_distance.hpp"

// A rope pulls and never pushes: the distance of two points is at most L.
//
//   C                C = L - |P2 - P1| >= 0, the slack; C < 0 if the rope is stretched                     [m]
//   differentiate    Ċ = -n · ((v2 + ω2 × r2) - (v1 + ω1 × r1)),   n = d/|d|,   d = P2 - P1 (11)
//   isolate V        Ċ = -n·v2 - (r2 × n)·ω2 + n·v1 + (r1 × n)·ω1      (triple product, as in (13))
//   J by inspection  J = [ n   r1 × n   -n   -r2 × n ], the negative of a rod's
//
// One-sided: the accumulated λ >= 0 is the impulse of the tension [N s].
namespace byhand {

template <class M>
struct Rope {
  static constexpr int rows = 1;
  static constexpr Bound bound = Bound::interval;

  Anchors<M> at;
  double length = 1;    // L [m] > 0
  double softness = 0;  // γ [1/kg] >= 0

  template <class T>
  Rows<1, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    return -NormalisedDistance<M>{at, length}.template value<T>(pose1, pose2);
  }

  /// J at two poses; zero where the points coincide, for the rope is slack there.
  Jacobian<M, 1> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    Jacobian<M, 1> J = NormalisedDistance<M>{at, length}.jacobian(pose1, pose2);
    J.matrix *= -1;
    return J;
  }

  void require_valid(const Bodies<M>&) const { require_positive("length", length, "m"); }
};

BYHAND_STORES(extern, Rope);

}  // namespace byhand
