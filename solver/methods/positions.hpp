#pragma once

#include "solver/gauss_seidel.hpp"
#include "solver/methods/step_work.hpp"

// One constraint solved on positions: what projection, XPBD and AVBD share.
//
// A row of a step h asks of the velocities, by (21) with softness,  JV + b + γλ = 0.  Times h, with hJV the change
// of the row's value C over the step and Λ = hλ, it asks of the poses, and nothing is linearised any more:
//
//   rows with a C (rods, joints, contacts), whose whole error is removed, b = C₀/h:
//                    C + γΛ = 0              so γ = α/h² is XPBD's compliance α: C = -αf for a force f = Λ/h²
//   rows without (springs, servos, motors, friction), b = `rate`:
//                    C - C₀ + h rate + γΛ = 0
//
// A spring has rate = k/(c+hk) C₀ and γ = 1/(h(c+hk)); its row is Λ = -h²(kC + c (C-C₀)/h), implicit Euler with
// the force at the end of the step, C and not its tangent. A motor's row is C - C₀ = hs, friction's is no slip
// over the step. Bounds on Λ are h times those on λ; friction's ball has the radius μΛ of its normal row. Newton's
// step from where the bodies now stand is (17) again,
//
//   ΔΛ = -(JM⁻¹Jᵀ + γ)⁻¹ (C - C₀ + h rate + γΛ) within bounds,    poses moved by M⁻¹JᵀΔΛ.
//
// (Source: M. Macklin, M. Müller, N. Chentanez, XPBD: position-based simulation of compliant constrained dynamics,
// MIG 2016, eq. 18; the rows without a C are derived here.)
namespace byhand {

/// What methods on positions keep besides the rows of the system, which they lay out in natural order: one number
/// a row.
template <class M>
struct PositionWork : StepWork<M> {
  std::vector<double> impulse;  // Λ = hλ [kg m, or what C's unit makes of it]
  std::vector<double> from;     // C₀ of rows whose change counts, 0 of rows with a C
  std::vector<double> target;   // what the row adds to that: h rate
  std::vector<Pose<M>> before;  // of the bodies, at the beginning of the step
};

/// Begins a step: finds contacts, and makes room for all rows. Returns whether they were laid out anew.
template <class M>
bool begin_rows(Scene<M>& scene, PositionWork<M>& work);

/// Writes what the rows ask for over a substep h [s] that begins at these poses and velocities, and notes JV of
/// those that may bounce.
template <class M>
void write_targets(const Scene<M>& scene, double h, PositionWork<M>& work);

/// C - C₀ + h rate of a block's rows, given their values C. An angle that passed half a turn goes on there.
template <class M, int K>
Rows<K> position_error(const Rows<K>& C, bool periodic, int row, const PositionWork<M>& work) {
  Rows<K> change = C - Eigen::Map<const Rows<K>>(&work.from[row]);
  if (periodic) {
    constexpr double half_turn = 4 * detail::quarter_pi;
    if (std::abs(change[0]) > half_turn) change[0] -= change[0] > 0 ? 2 * half_turn : -2 * half_turn;
  }
  return change + Eigen::Map<const Rows<K>>(&work.target[row]);
}

/// Bounds of a block's Λ: an interval's two ends; with friction `upper` is μ and `normal` the Λ that it
/// multiplies.
struct ImpulseBounds {
  double lower = 0, upper = 0, normal = 0;
};
/// Those over a substep h [s].
template <class M, int K, Bound B>
ImpulseBounds impulse_bounds(const Block<M, K, B>& block, double h, const PositionWork<M>& work) {
  const System<M>& system = work.system;
  if constexpr (B == Bound::interval)
    return {h * system.lower[block.row], h * system.upper[block.row]};
  else
    return {0, system.upper[block.row], B == Bound::friction ? work.impulse[block.normal_row] : 0.0};
}

/// x of Ax = b, or where that is outside the disc of `radius`, of (A + s)x = b on its rim: friction within
/// Coulomb's disc, whose slip Ax - b = -sx then opposes it. By Newton on 1/|x| = 1/radius, from s = 0 upwards.
/// (Source: J. J. Moré, D. C. Sorensen, Computing a trust region step, SIAM J. Sci. Stat. Comput. 4, 1983.)
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

//! [newton]
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

/// Moves the two bodies of a block by M⁻¹JᵀΔΛ.
template <class M, int K, Bound B>
void displace(const Block<M, K, B>& block, const Rows<K>& change, std::vector<Pose<M>>& poses) {
  if (block.moves1) move<M, double>(poses[block.body1], block.W.side1().transpose() * change, 1);
  if (block.moves2) move<M, double>(poses[block.body2], block.W.side2().transpose() * change, 1);
}
//! [newton]

/// The velocity with which `move` comes from one pose to another in a time h [s], by less than half a turn: in
/// space the exact logarithm, as `move` takes the exact exponential. (Twice the vector part of the turn, as XPBD's
/// paper has it, is sin(φ/2)/(φ/2) of that, and brakes a body that nothing holds.)
template <class M>
Velocity<M> velocity_between(const Pose<M>& before, const Pose<M>& after, double h);
/// That velocity for all bodies that move.
template <class M>
void velocities_between(const std::vector<Pose<M>>& before, double h, Bodies<M>& bodies);

/// Ends a substep h [s]: λ from Λ; contacts that met faster than `threshold` [m/s] and pressed get the velocity -e
/// JV⁻ with which they part, one after the other from the λ that stands.
template <class M>
void end_rows(Scene<M>& scene, double h, double threshold, PositionWork<M>& work);

}  // namespace byhand
