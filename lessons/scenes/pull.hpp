#pragma once

#include <array>

#include "solver/constraints/spring.hpp"

// A hand pulls a point of a body along a direction u that is fixed in the world, like a spring of limited
// strength. Body 1 is the hand; two of these, along x and y, pull in the plane.
//
//   C                C = u · (P2 - P1)                                                       [m]
//   differentiate    Ċ = u · ((v2 + ω2 × r2) - (v1 + ω1 × r1))
//   J by inspection  J = [ -u   -r1 × u   u   r2 × u ], bias and γ as in Spring
//
// Its strength bounds the impulse of a step: |λ| <= strength h.
namespace byhand {

template <class M>
struct Pull {
  static constexpr int rows = 1, position_rows = 0;  // the row has its own bias
  static constexpr Bound bound = Bound::interval;

  Anchors<M> at;
  Linear<M> along = Linear<M>::Unit(0);  // u, of length 1
  double strength = 0;                   // [N] >= 0
  Elastic elastic = {};

  template <class T>
  Rows<1, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    const Linear<M, T> d = at.separation(pose1, pose2), u = along.template cast<T>();
    return Rows<1, T>(T(u.dot(d)));
  }
  Jacobian<M, 1> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    Jacobian<M, 1> J;
    set_row_along<M, 1>(J, 0, along, in_world<M, double>(pose1, at.arms.first),
                        in_world<M, double>(pose2, at.arms.second));
    return J;
  }
  Soft soft(const Pose<M>& pose1, const Pose<M>& pose2, double h) const {
    return elastic.soft(value<double>(pose1, pose2)[0], h);
  }
  std::array<double, 2> bounds(double h) const { return {-strength * h, strength * h}; }

  void require_valid(const Bodies<M>&) const {
    require_unit("length of the direction", along.norm());
    require_in("strength of the hand", strength, 0, 1e300, "N");
    elastic.require_valid();
  }
};

}  // namespace byhand
