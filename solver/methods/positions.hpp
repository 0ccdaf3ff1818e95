#pragma once

#include "solver/constraints/turn.hpp"
#include "solver/methods/prepared.hpp"

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
// over the step. Bounds on Λ are h times those on λ; friction's ball has the radius μΛ of its leader. Newton's
// step from where the bodies now stand is (17) again,
//
//   ΔΛ = -(JM⁻¹Jᵀ + γ)⁻¹ (C - C₀ + h rate + γΛ) within bounds,    poses moved by M⁻¹JᵀΔΛ.
//
// (Source: M. Macklin, M. Müller, N. Chentanez, XPBD: position-based simulation of compliant constrained dynamics,
// MIG 2016, eq. 18; the rows without a C are derived here.)
namespace byhand {

/// The rows of a scene as methods on positions see them: one number a row, constraints in natural order.
struct PositionRows {
  std::vector<double> impulse;   // Λ = hλ [kg m, or what C's unit makes of it]
  std::vector<double> gamma;     // γ
  std::vector<double> from;      // C₀ of rows whose change counts, 0 of rows with a C
  std::vector<double> ask;       // what the row adds to that: h rate
  std::vector<double> approach;  // JV before the step, of rows that may bounce
  std::vector<double> lambda;    // λ = Λ/h of the last step [N s]
  std::vector<int> row_of;       // for each constraint by its number, its first row
  int version = -1;              // of the scene
  int lasting = 0;               // how many rows, the first, are of constraints that were added rather than found

  int rows() const { return static_cast<int>(impulse.size()); }
};

/// Calls f(constraint, first row) for each constraint in natural order.
template <class S, class F>
void for_each_with_row(const S& scene, F&& f) {
  int row = 0;
  scene.for_each([&](const auto& constraint) {
    f(constraint, row);
    row += std::remove_cvref_t<decltype(constraint)>::rows;
  });
}

/// Makes room for the scene's rows if constraints came or went. λ of those that were added and stay is kept.
/// Returns whether anything changed.
template <class S>
bool lay_out(const S& scene, PositionRows& rows) {
  if (rows.version == scene.version()) return false;
  rows.version = scene.version();
  rows.row_of.clear();
  const int kept = rows.lasting;
  int count = 0;
  rows.lasting = 0;
  for_each_with_row(scene, [&](const auto& constraint, int row) {
    rows.row_of.push_back(row);
    count = row + std::remove_cvref_t<decltype(constraint)>::rows;
    if (static_cast<int>(rows.row_of.size()) == scene.lasting()) rows.lasting = count;
  });
  rows.lambda.resize(std::min(kept, rows.lasting));
  for (auto* numbers : {&rows.lambda, &rows.impulse, &rows.gamma, &rows.from, &rows.ask, &rows.approach})
    numbers->resize(count);
  return true;
}

/// Notes JV of a contact before the step.
template <class Kind, class M>
void note_approach(const Kind& contact, const Bodies<M>& bodies, int row, PositionRows& rows) {
  const int body1 = contact.at.body1, body2 = contact.at.body2;
  Eigen::Map<Rows<Kind::rows>>(&rows.approach[row]) = dot(contact.jacobian(bodies.pose[body1], bodies.pose[body2]),
                                                          bodies.velocity[body1], bodies.velocity[body2]);
}

/// Writes what a constraint's rows ask for over a step h [s] that begins at these poses and velocities.
template <class Kind, class M>
void begin_rows(const Kind& constraint, const Bodies<M>& bodies, double h, int row, PositionRows& rows) {
  const Pose<M>&pose1 = bodies.pose[constraint.at.body1], &pose2 = bodies.pose[constraint.at.body2];
  for (int k = 0; k < Kind::rows; ++k) rows.from[row + k] = rows.ask[row + k] = 0;
  if constexpr (Kind::drifting < Kind::rows) {
    const Rows<Kind::rows> C = constraint.template value<double>(pose1, pose2);
    for (int k = Kind::drifting; k < Kind::rows; ++k) rows.from[row + k] = C[k];
  }
  if constexpr (requires { constraint.soft(pose1, pose2, h); }) {
    const Soft soft = constraint.soft(pose1, pose2, h);
    rows.gamma[row] = soft.gamma;
    rows.ask[row] = h * soft.rate;
  } else {
    for (int k = 0; k < Kind::rows; ++k) rows.gamma[row + k] = constraint.softness;
  }
  if constexpr (requires { constraint.restitution; }) note_approach(constraint, bodies, row, rows);
}

/// Lets one-sided rows that overlap by more than `way` [m] come out by no more than that in a step that begins
/// here.
template <class Kind, class M>
void push_out_slowly(const Kind& constraint, const Bodies<M>& bodies, double way, int row, PositionRows& rows) {
  const Rows<Kind::rows> C =
      constraint.template value<double>(bodies.pose[constraint.at.body1], bodies.pose[constraint.at.body2]);
  for (int k = 0; k < Kind::drifting; ++k) rows.ask[row + k] = std::max(0.0, -(C[k] + way));
}

/// C - C₀ + h rate of a constraint's rows where its bodies now stand. An angle that passed half a turn goes on
/// there.
template <class Kind, class M>
Rows<Kind::rows> gap(const Kind& constraint, const Bodies<M>& bodies, int row, const PositionRows& rows) {
  constexpr int K = Kind::rows;
  Rows<K> change =
      constraint.template value<double>(bodies.pose[constraint.at.body1], bodies.pose[constraint.at.body2]) -
      Eigen::Map<const Rows<K>>(&rows.from[row]);
  if constexpr (Kind::drifting == 0 && std::is_same_v<std::remove_cvref_t<decltype(constraint.at)>, Turn<M>>) {
    constexpr double half_turn = 4 * detail::quarter_pi;
    if (std::abs(change[0]) > half_turn) change[0] -= change[0] > 0 ? 2 * half_turn : -2 * half_turn;
  }
  return change + Eigen::Map<const Rows<K>>(&rows.ask[row]);
}

/// Bounds of a constraint's Λ over a step h [s]: an interval's two ends; of a ball or face `upper` is μ and
/// `leader` the Λ that it multiplies.
struct ImpulseBounds {
  double lower = 0, upper = 0, leader = 0;
};
template <class Kind>
ImpulseBounds impulse_bounds(const Kind& constraint, double h, const PositionRows& rows) {
  if constexpr (Kind::bound == Bound::interval) {
    const auto [lower, upper] = constraint.bounds(h);
    return {h * lower, h * upper};
  } else if constexpr (Kind::bound == Bound::ball) {
    return {0, constraint.coefficient, rows.impulse[rows.row_of[constraint.leader]]};
  } else if constexpr (Kind::bound == Bound::face) {
    return {0, constraint.coefficient};
  } else {
    return {};
  }
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
  if constexpr (B == Bound::face) {
    const Eigen::Matrix2d E = inverse_or_zero<2>(A.template topLeftCorner<2, 2>());
    struct {
      double A00, A01, A11, E00, E01, E11;
      bool row_by_row;
    } const face{A(0, 0), A(0, 1), A(1, 1), E(0, 0), E(0, 1), E(1, 1), false};
    const auto [first, second] = ends_that_press(face, residual, impulse.data());
    const double slip = residual[2] + A(0, 2) * (first - impulse[0]) + A(1, 2) * (second - impulse[1]);
    const double rubbed = A(2, 2) > 0 ? impulse[2] - slip / A(2, 2) : 0.0;
    const double radius = bounds.upper * (first + second);
    return Rows<K>(first, second, std::clamp(rubbed, -radius, radius)) - impulse;
  } else if constexpr (B == Bound::ball) {
    return within_disc<K>(A, A.lazyProduct(impulse) - residual, bounds.upper * bounds.leader) - impulse;
  } else {
    const Rows<K> wanted = impulse - inverse_or_zero<K>(A).lazyProduct(residual);
    return bounded<K, B>(wanted, bounds.lower, bounds.upper, bounds.leader) - impulse;
  }
}

/// Moves a constraint's two bodies by M⁻¹Jᵀ ΔΛ, with ΔΛ = impulse_of(JM⁻¹Jᵀ).
template <class Kind, class M, class F>
void displace(const Kind& constraint, Bodies<M>& bodies, F&& impulse_of) {
  const int body1 = constraint.at.body1, body2 = constraint.at.body2;
  const InverseMass<M>&mass1 = bodies.inverse_mass[body1], &mass2 = bodies.inverse_mass[body2];
  Pose<M>&pose1 = bodies.pose[body1], &pose2 = bodies.pose[body2];
  const Jacobian<M, Kind::rows> J = constraint.jacobian(pose1, pose2);
  const Jacobian<M, Kind::rows> W = times_inverse_mass(J, mass1, pose1, mass2, pose2);
  const Rows<Kind::rows> change = impulse_of(inverse_effective_mass(J, W));
  if (moves(mass1)) move<M, double>(pose1, W.side1().transpose() * change, 1);
  if (moves(mass2)) move<M, double>(pose2, W.side2().transpose() * change, 1);
}

/// One Newton step of one constraint: its Λ and the poses of its two bodies.
template <class Kind, class M>
void solve_on_positions(const Kind& constraint, Bodies<M>& bodies, double h, int row, PositionRows& rows) {
  constexpr int K = Kind::rows;
  Eigen::Map<Rows<K>> impulse(&rows.impulse[row]);
  const Eigen::Map<const Rows<K>> gamma(&rows.gamma[row]);
  displace(constraint, bodies, [&](Eigen::Matrix<double, K, K> A) {
    A.diagonal() += gamma;
    const Rows<K> residual = gap(constraint, bodies, row, rows) + gamma.cwiseProduct(impulse);
    const Rows<K> change =
        bounded_newton<Kind::bound, K>(A, residual, impulse, impulse_bounds(constraint, h, rows));
    impulse += change;
    return change;
  });
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

/// Gives a contact that was met faster than `threshold` [m/s] and pressed the velocity -e JV⁻ with which it parts:
/// its rows once more, for velocities, from the λ that stands. Returns whether it bounced.
template <class Kind, class M>
bool bounce(const Kind& contact, Bodies<M>& bodies, double threshold, int row, PositionRows& rows) {
  constexpr int K = Kind::rows;
  Eigen::Map<Rows<K>> lambda(&rows.lambda[row]);
  Rows<K> parting = Rows<K>::Zero();
  for (int k = 0; k < Kind::drifting; ++k)
    if (lambda[k] > 0 && rows.approach[row + k] < -threshold)
      parting[k] = -contact.restitution * rows.approach[row + k];
  if (parting.isZero(0)) return false;
  const int body1 = contact.at.body1, body2 = contact.at.body2;
  const InverseMass<M>&mass1 = bodies.inverse_mass[body1], &mass2 = bodies.inverse_mass[body2];
  const Pose<M>&pose1 = bodies.pose[body1], &pose2 = bodies.pose[body2];
  Velocity<M>&V1 = bodies.velocity[body1], &V2 = bodies.velocity[body2];
  const Jacobian<M, K> J = contact.jacobian(pose1, pose2);
  const Jacobian<M, K> W = times_inverse_mass(J, mass1, pose1, mass2, pose2);
  const Rows<K> change = bounded_newton<Kind::bound, K>(inverse_effective_mass(J, W), dot(J, V1, V2) - parting,
                                                        lambda, impulse_bounds(contact, 1, rows));
  lambda += change;
  if (moves(mass1)) V1 += W.side1().transpose() * change;
  if (moves(mass2)) V2 += W.side2().transpose() * change;
  return true;
}

/// Ends a step h [s] of all rows: λ from Λ, and the contacts that bounce. Returns how many rows of those were
/// solved.
template <class S>
long long end_rows(S& scene, double h, double threshold, PositionRows& rows) {
  long long solved = 0;
  for (int row = 0; row < rows.rows(); ++row) rows.lambda[row] = rows.impulse[row] / h;
  for_each_with_row(scene, [&]<class Kind>(const Kind& constraint, int row) {
    if constexpr (requires { constraint.restitution; })
      if (bounce(constraint, scene.bodies, threshold, row, rows)) {
        Eigen::Map<Rows<Kind::rows>>(&rows.lambda[row]).setZero();
        solved += Kind::rows;
      }
  });
  return solved;
}

}  // namespace byhand
