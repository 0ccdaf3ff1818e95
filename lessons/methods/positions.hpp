#pragma once

#include "solver/contact/restitution.hpp"
#include "solver/cures/bounded_newton.hpp"
#include "solver/direct/graph.hpp"
#include "solver/integrate/gyroscopic.hpp"
#include "solver/integrate/rotation.hpp"
#include "solver/support/attempt.hpp"

// One constraint solved on positions: shared by projection, XPBD and AVBD.
//
// Over a step h, (21) with softness asks of a row's velocities  JV + b + γλ = 0.  Times h, with hJV the change of
// the row's value C and Λ = hλ, it asks of the poses, without linearisation:
//
//   rows with a C (rods, joints, contacts), whose whole error is removed, b = C₀/h:
//                    C + γΛ = 0              so γ = α/h² with XPBD's compliance α: C = -αf for a force f = Λ/h²
//   rows without (springs, servos, motors, friction), b = `rate`:
//                    C - C₀ + h rate + γΛ = 0
//
// A spring has rate = k/(c+hk) C₀ and γ = 1/(h(c+hk)). Its row is Λ = -h²(kC + c (C-C₀)/h): implicit Euler with
// the force at the end of the step, C itself and not its tangent. A motor's row is C - C₀ = hs, friction's C = C₀.
// Bounds on Λ are h times those on λ; friction's ball has the radius μΛ of its normal row. Newton's step from the
// current poses is (17) again,
//
//   ΔΛ = -(JM⁻¹Jᵀ + γ)⁻¹ (C - C₀ + h rate + γΛ) within bounds,    poses moved by M⁻¹JᵀΔΛ.
//
// Source: M. Macklin, M. Müller, N. Chentanez, XPBD: position-based simulation of compliant constrained dynamics,
// MIG 2016, eq. 18. The rows without a C are derived here.
namespace byhand {

/// What methods on positions keep between steps. Their rows are in natural order; the vectors have one number a
/// row.
template <class M>
struct PositionWork : StepWork<M> {
  std::vector<double> impulse;            // Λ = hλ
  std::vector<double> from;               // C₀ of rows without a C; 0 of rows with one
  std::vector<double> target;             // h rate
  std::vector<Pose<M>> free;              // where the bodies would be without rows
  std::vector<Velocity<M>> displacement;  // of the bodies since the start of the substep [m, rad]
};

/// Lays the rows out in natural order if the scene has changed. Returns whether it has.
template <class M>
bool lay_out_naturally(const Scene<M>& scene, StepWork<M>& work) {
  if (work.version == scene.version()) return false;
  work.version = scene.version();
  const ConstraintList<M>& contacts = work.contacts.constraints();
  scene.lay_out(natural_order(scene.count() + contacts.count()), work.system, contacts);
  work.executed.laid_out_rows += work.system.rows();
  return true;
}

/// Begins a step [s]: finds contacts and makes room for all rows. Returns whether the layout has changed.
template <class M>
bool begin_rows(Scene<M>& scene, double step, PositionWork<M>& work) {
  find_contacts(scene, step, work);
  const bool changed = lay_out_naturally(scene, work);
  work.contacts.write_impulses(work.system);
  for (auto* numbers : {&work.impulse, &work.from, &work.target}) numbers->resize(work.system.rows());
  return changed;
}

/// Writes rows, C₀ and h rate for a substep h [s] from the current state. Contacts that meet faster than
/// `threshold` [m/s] will bounce.
template <class M>
void write_targets(Scene<M>& scene, double h, double threshold, PositionWork<M>& work) {
  System<M>& system = work.system;
  write_rows(scene, h, work);
  note_parting(scene, h, threshold, system, work.parting);
  for_each_block(system, [&](const BlockHeader& block, const Run& run) {
    const ConstraintStore<M>& store = scene.store(run, work.contacts.constraints());
    double C[most_rows<M>] = {};
    if (store.position_rows < store.rows && !store.holds_where_found)
      store.write_value(block.constraint, scene.bodies(), C);
    for (int k = 0; k < store.rows; ++k) {
      work.from[block.row + k] = k < store.position_rows ? 0 : C[k];
      work.target[block.row + k] = h * system.target_rate[block.row + k];
    }
  });
}

/// Moves the bodies freely for a substep h [s].
template <class M>
void advance_freely(Gyroscopic gyroscopic, Bodies<M>& bodies, double h, PositionWork<M>& work) {
  move_freely(gyroscopic, bodies, h);
  work.displacement = bodies.velocity;
  for (Velocity<M>& way : work.displacement) way *= h;
}

/// C + JΔ of a block that holds where it was found, with Δ the displacement since; 0 + JΔ of rows without a C.
template <class M, int K, Bound B>
Rows<K> displaced_value(const Block<M, K, B>& block, const PositionWork<M>& work) {
  return Eigen::Map<const Rows<K>>(&work.system.C[block.row]) +
         dot(block.J, work.displacement[block.body1], work.displacement[block.body2]);
}

/// C of a block's rows at the present poses. Linearises the block there, unless it holds where it was found.
template <class M, int K, Bound B>
Rows<K> linearised(const ConstraintStore<M>& store, const Bodies<M>& bodies, Block<M, K, B>& block,
                   const PositionWork<M>& work) {
  if (store.holds_where_found) return displaced_value(block, work);
  Rows<K> C;
  store.linearise(bodies, block, C.data());
  return C;
}

/// C - C₀ + h rate of a block's rows with values C. The change of an angle (`periodic`) is at most half a turn.
template <class M, int K>
Rows<K> position_error(const Rows<K>& C, bool periodic, int row, const PositionWork<M>& work) {
  Rows<K> change = C - Eigen::Map<const Rows<K>>(&work.from[row]);
  if (periodic) {
    constexpr double half_turn = 4 * detail::quarter_pi;
    if (std::abs(change[0]) > half_turn) change[0] -= change[0] > 0 ? 2 * half_turn : -2 * half_turn;
  }
  return change + Eigen::Map<const Rows<K>>(&work.target[row]);
}

/// Bounds of a block's Λ, h times those of its λ.
template <class M, int K, Bound B>
ImpulseBounds impulse_bounds(const Block<M, K, B>& block, double h, const PositionWork<M>& work) {
  const System<M>& system = work.system;
  if constexpr (B == Bound::interval) return {h * system.lower[block.row], h * system.upper[block.row]};
  return {0, system.upper[block.row], B == Bound::friction ? work.impulse[block.normal_row] : 0.0};
}

/// The velocity with which `move` goes from one pose to another in a time h [s], turning less than half a turn. In
/// space it is the exact logarithm; XPBD's paper takes twice the vector part of the turn, which is smaller by
/// sin(φ/2)/(φ/2) and slows down a free body.
template <class M>
Velocity<M> velocity_between(const Pose<M>& before, const Pose<M>& after, double h) {
  Velocity<M> V;
  V.template head<M::linear>() = (after.position - before.position) / h;
  if constexpr (M::angular == 1) V[M::linear] = principal_angle(after.rotation * inverse(before.rotation)) / h;
  if constexpr (M::angular == 3) V.template tail<3>() = turn_of(after.rotation * inverse(before.rotation)) / h;
  return V;
}

/// Ends a substep h [s]: adds to the velocities of the free motion what moves its poses to the present ones,
/// however often a body has turned; λ from Λ. Then contacts that press and bounce get their velocity, one after
/// the other.
template <class M>
void end_substep(Scene<M>& scene, double h, PositionWork<M>& work) {
  System<M>& system = work.system;
  Bodies<M>& bodies = scene.state();
  for (int i = 0; i < bodies.size(); ++i)
    if (moves(bodies.inverse_mass[i])) bodies.velocity[i] += velocity_between<M>(work.free[i], bodies.pose[i], h);
  for (int row = 0; row < system.rows(); ++row) system.lambda[row] = work.impulse[row] / h;
  if (work.parting.empty()) return;
  for_each_block(system, [&]<int K, Bound B>(Block<M, K, B>& block, const Run&) {
    if constexpr (constexpr int count = bouncing<K, B>; count > 0) {
      Eigen::Map<Rows<K>> lambda(&system.lambda[block.row]);
      Rows<K> parting = Rows<K>::Zero();
      for (int k = 0; k < count; ++k)
        if (lambda[k] > 0) parting[k] = std::max(0.0, work.parting[block.row + k]);
      if (parting.isZero(0)) return;
      Velocity<M>&V1 = bodies.velocity[block.body1], &V2 = bodies.velocity[block.body2];
      const ImpulseBounds bounds{system.lower[block.row], system.upper[block.row]};
      const Rows<K> change = bounded_newton<B, K>(inverse_effective_mass(block.J, block.W),
                                                  dot(block.J, V1, V2) - parting, lambda, bounds);
      if (block.moves1) V1 += block.W.side1().transpose() * change;
      if (block.moves2) V2 += block.W.side2().transpose() * change;
      lambda.setZero();  // they part: no warm start from this push
      work.row_solves += K;
    }
  });
}

}  // namespace byhand
