#pragma once

#include <array>
#include <limits>

#include "solver/constraints/normalised_distance.hpp"

// A rope pulls and never pushes: two points come no further apart than L.
//
//   C                C = L - |P2 - P1| >= 0, the slack; a rope that is too long by C < 0 pulls             [m]
//   differentiate    Ċ = -n · ((v2 + ω2 × r2) - (v1 + ω1 × r1)),   n = d/|d|,   d = P2 - P1 (11)
//   isolate V        Ċ = -n·v2 - (r2 × n)·ω2 + n·v1 + (r1 × n)·ω1      (triple product, as in (13))
//   J by inspection  J = [ n   r1 × n   -n   -r2 × n ], that of a rod with its sign turned
//
// One-sided like a contact: the accumulated λ >= 0 is the impulse of the tension [N s].
namespace byhand {

template <class M>
struct Rope {
  static constexpr int rows = 1;
  static constexpr Bound bound = Bound::interval;
  static constexpr int position_rows = rows;

  Anchors<M> at;
  double length = 1;    // L [m] > 0
  double softness = 0;  // γ [1/kg] >= 0

  static constexpr std::array<double, 2> bounds(double /*h*/) {
    return {0, std::numeric_limits<double>::infinity()};
  }

  /// L - |P2 - P1| at two poses [m], for any scalar.
  template <class T>
  Rows<1, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    return -rod().template value<T>(pose1, pose2);
  }

  /// J at two poses [1, and m where a body turns]; zero where the points coincide: the rope is slack there.
  Jacobian<M, 1> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    Jacobian<M, 1> J = rod().jacobian(pose1, pose2);
    J.matrix *= -1;
    return J;
  }

  /// Throws std::invalid_argument for length <= 0, softness < 0, or anchors that name no bodies.
  void require_valid(const Bodies<M>& bodies) const {
    at.require_valid(bodies);
    require_positive("length", length, "m");
    require_in("softness", softness, 0, 1e300);
  }

 private:
  NormalisedDistance<M> rod() const { return {at, length}; }
};

BYHAND_STORES_IN_LIBRARY(Rope);

}  // namespace byhand
