#pragma once

#include "solver/constraints/anchors.hpp"

// Dry friction between two touching bodies: along tangents t_k of the contact they slip as little as a bounded
// impulse allows. There is no C, only a rate; `value` is the slip, whose rate is JV.
//
//   slip                 s_k = t_k · (P2 - P1), t_k constant over a step                           [m]
//   differentiate        ṡ_k = t_k · ((v2 + ω2 × r2) - (v1 + ω1 × r1))
//   isolate V            ṡ_k = t_k·v2 + (r2 × t_k)·ω2 - t_k·v1 - (r1 × t_k)·ω1    (triple product, as in (13))
//   J by inspection,(16) J_k = [ -t_k   -r1 × t_k   t_k   r2 × t_k ]
//
// Coulomb's bound: |λ| <= μ λ_normal [N s], an interval for one tangent, a disc for two.
namespace byhand {

/// Friction along K tangents of a contact.
template <class M, int K>
struct FrictionAlong {
  static constexpr int rows = K, position_rows = 0;
  static constexpr Bound bound = Bound::friction;
  static constexpr bool holds_where_found = true;

  Anchors<M> at;
  Packed<double, M::linear, K> tangents;  // t_k, orthonormal columns in the world
  double coefficient = 0;                 // μ >= 0
  int contact = 0;                        // handle of the contact that gives λ_normal
  double softness = 0;                    // γ [1/kg] >= 0

  template <class T>
  Rows<K, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    return tangents.transpose().template cast<T>() * at.separation(pose1, pose2);
  }

  Jacobian<M, K> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    const Arm<M> r1 = in_world<M, double>(pose1, at.arms.first), r2 = in_world<M, double>(pose2, at.arms.second);
    Jacobian<M, K> J;
    for (int k = 0; k < K; ++k) set_row_along<M, K>(J, k, Linear<M>(tangents.col(k)), r1, r2);
    return J;
  }

  void require_valid(const Bodies<M>&) const { require_orthonormal("tangents", tangents); }
};

/// Friction along all tangents of a contact: one in the plane, two in space.
template <class M>
using Friction = FrictionAlong<M, M::linear - 1>;

/// Friction along one tangent. Two at right angles bound the impulse by a square, the "box pyramid", instead of a
/// disc: along its diagonals friction is √2 times too strong, and sliding bodies veer towards its axes.
template <class M>
using AxisFriction = FrictionAlong<M, 1>;

BYHAND_STORES(extern, Friction);
extern BYHAND_STORE(SpaceParticle, AxisFriction);
extern BYHAND_STORE(SpaceBody, AxisFriction);

}  // namespace byhand
