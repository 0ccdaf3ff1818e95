#pragma once

#include <algorithm>

#include "solver/rows/normal_rows.hpp"

// One step of Newton's method for one constraint on positions, within bounds on its accumulated Λ.
namespace byhand {

/// Bounds of a block's Λ: the ends of an interval; for friction `upper` is μ and `normal` the Λ it multiplies.
struct ImpulseBounds {
  double lower = 0, upper = 0, normal = 0;
};

/// Friction within Coulomb's disc: x of Ax = b if |x| <= `radius`, else of (A + s)x = b with |x| = radius, so that
/// the slip Ax - b = -sx opposes x. Newton's method on 1/|x| = 1/radius, from s = 0 upwards. Source: J. J. Moré,
/// D. C. Sorensen, Computing a trust region step, SIAM J. Sci. Stat. Comput. 4, 1983.
template <int K>
Rows<K> within_disc(Eigen::Matrix<double, K, K> A, const Rows<K>& b, double radius) {
  if (!(radius > 0)) return Rows<K>::Zero();
  Rows<K> x = inverse_or_zero<K>(A).lazyProduct(b);
  double length = x.norm();
  for (int i = 0; i < 8 && length > radius * (1 + 1e-12); ++i) {
    const Rows<K> slope = inverse_or_zero<K>(A).lazyProduct(x);
    A.diagonal().array() += (length - radius) / radius * length * length / x.dot(slope);
    x = inverse_or_zero<K>(A).lazyProduct(b);
    length = x.norm();
  }
  return length > radius ? Rows<K>(x * (radius / length)) : x;
}

/// ΔΛ = -A⁻¹ `residual` of K rows with A = JM⁻¹Jᵀ + γ, such that Λ + ΔΛ is within its bounds.
template <Bound B, int K>
Rows<K> bounded_newton(const Eigen::Matrix<double, K, K>& A, const Rows<K>& residual, const Rows<K>& impulse,
                       const ImpulseBounds& bounds) {
  if constexpr (B == Bound::manifold) {
    const auto [first, second] = pressing_normals(NormalRows(A, false), residual, impulse.data());
    const double slip = residual[2] + A(0, 2) * (first - impulse[0]) + A(1, 2) * (second - impulse[1]);
    const double friction = A(2, 2) > 0 ? impulse[2] - slip / A(2, 2) : 0.0;
    const double radius = bounds.upper * (first + second);
    return Rows<K>(first, second, std::clamp(friction, -radius, radius)) - impulse;
  } else if constexpr (B == Bound::friction) {
    return within_disc<K>(A, A.lazyProduct(impulse) - residual, bounds.upper * bounds.normal) - impulse;
  } else {
    const Rows<K> wanted = impulse - inverse_or_zero<K>(A).lazyProduct(residual);
    return bounded<K, B>(wanted, bounds.lower, bounds.upper, bounds.normal) - impulse;
  }
}

/// Calls displace(body, M⁻¹JᵀΔΛ) for those bodies of a block that move.
template <class M, int K, Bound B>
void apply_displacement(const Block<M, K, B>& block, const Rows<K>& change, auto&& displace) {
  if (block.moves1) displace(block.body1, Velocity<M>(block.W.side1().transpose() * change));
  if (block.moves2) displace(block.body2, Velocity<M>(block.W.side2().transpose() * change));
}

}  // namespace byhand
