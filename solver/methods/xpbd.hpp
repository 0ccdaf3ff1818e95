#pragma once

#include <string>

#include "solver/integrate/euler.hpp"
#include "solver/integrate/gyroscopic.hpp"
#include "solver/methods/positions.hpp"
#include "solver/scene.hpp"
#include "solver/touching.hpp"

// Extended position-based dynamics of rigid bodies. A substep h moves the poses freely, puts them onto the
// constraints, and reads the velocities off where they went:
//
//   x* = x₀ + h (v₀ + h g)           poses as nothing holds them
//   C(x* + M⁻¹JᵀΛ) + γΛ = 0          each constraint in turn, by positions.hpp, from Λ = 0
//   v₁ = (x₁ - x₀)/h                 a chord, not a tangent
//
// Without γ, C is kept to rounding in as many iterations as Newton needs. But v₁ points along the chord, x* of the
// next substep leaves the constraint by twice what a tangent would, and putting it back shortens the way: a
// particle on a circle that turned by φ in one substep turns by tan φ₁ = sin φ/(2 - cos φ), or φ - φ³, in the
// next. Its spin falls as ω₀/√(1 + 2ω₀² h t) though nothing brakes it. More substeps cure that and more iterations
// do not. The linear momentum of free bodies is kept: a constraint moves its two bodies by opposite m Δx.
//
// Bodies in space read their spin off as the exact logarithm of the turn between both orientations, as `move`
// takes the exact exponential of it; twice the vector part, as in the paper, is sin(φ/2)/(φ/2) of that, and would
// brake a free body.
//
// An overlap would leave with the velocity C/h at which it is pushed out, which small substeps make large: a
// one-sided row asks for C >= C₀ + h·(push speed) while that is below zero. Contacts that were met fast are solved
// once more for the velocity -e JV⁻ with which they part. (The paper takes the speed off every contact that
// pressed instead. With one iteration that takes back part of the support which the sweep has just built up: two
// boxes, one upon the other, begin to rock and ten are thrown about, while as it is here they stand.)
//
// (Sources: M. Müller, M. Macklin, N. Chentanez, S. Jeschke, T.-Y. Kim, Detailed rigid body simulation with
// extended position based dynamics, SCA 2020; the law of the circle is derived here.)
namespace byhand {

/// XPBD, as choices. Cost of a step: substeps × iterations × rows, and once those of contacts that bounce.
struct Xpbd {
  template <class M>
  struct Work;

  int substeps = 20;                         // >= 1
  int iterations = 1;                        // of each substep >= 1
  Gyroscopic gyroscopic = Gyroscopic::none;  // of bodies in space
  double push_speed = 1;                     // with which overlap is pushed out at most [m/s] > 0
  double bounce_threshold = 0.5;             // slower than this nothing bounces [m/s] >= 0
};

/// Throws std::invalid_argument for a choice outside its range.
void require_valid(const Xpbd& method);

/// Why this scene cannot be run so: it always can.
template <class S>
std::string refusal(const S&, const Xpbd&) {
  return {};
}

/// What is kept between steps: scratch, and what can be measured.
template <class M>
struct Xpbd::Work {
  PositionRows rows;
  std::vector<double> lambda;  // Λ/h of the last substep, one number a row, constraints in natural order [N s]
  std::vector<Pose<M>> before;
  std::vector<double> approach;  // JV before the substep, of rows that may bounce
  std::conditional_t<M::angular == 0, NoTouching, Touching<M>> touching;
  double h = 0;              // the substep that λ belongs to [s]
  long long row_solves = 0;  // so far
};

/// The velocity that `move` needs to come from one pose to another in a time h [s]; less than half a turn.
template <class M>
Velocity<M> velocity_between(const Pose<M>& before, const Pose<M>& after, double h) {
  Velocity<M> V;
  V.template head<M::linear>() = (after.position - before.position) / h;
  if constexpr (M::angular == 1) V[M::linear] = principal_angle(after.rotation * inverse(before.rotation)) / h;
  if constexpr (M::angular == 3) V.template tail<3>() = turn_of(after.rotation * inverse(before.rotation)) / h;
  return V;
}

namespace detail {

/// JV of a constraint at the current poses.
template <class Kind, class M>
Rows<Kind::rows> rate_of(const Kind& constraint, const Bodies<M>& bodies) {
  const int body1 = constraint.at.body1, body2 = constraint.at.body2;
  return dot(constraint.jacobian(bodies.pose[body1], bodies.pose[body2]), bodies.velocity[body1],
             bodies.velocity[body2]);
}

/// Gives a contact that was met fast and pressed the velocity with which it parts.
template <class Kind, class M>
void bounce(const Kind& contact, Bodies<M>& bodies, double threshold, int row, Xpbd::Work<M>& work) {
  constexpr int K = Kind::rows;
  Eigen::Map<Rows<K>> lambda(&work.lambda[row]);
  Rows<K> parting = Rows<K>::Zero();
  for (int k = 0; k < Kind::drifting; ++k)
    if (lambda[k] > 0 && work.approach[row + k] < -threshold)
      parting[k] = -contact.restitution * work.approach[row + k];
  if (parting.isZero(0)) return;
  const int body1 = contact.at.body1, body2 = contact.at.body2;
  const InverseMass<M>&mass1 = bodies.inverse_mass[body1], &mass2 = bodies.inverse_mass[body2];
  const Pose<M>&pose1 = bodies.pose[body1], &pose2 = bodies.pose[body2];
  Velocity<M>&V1 = bodies.velocity[body1], &V2 = bodies.velocity[body2];
  const Jacobian<M, K> J = contact.jacobian(pose1, pose2);
  const Jacobian<M, K> W = times_inverse_mass(J, mass1, pose1, mass2, pose2);
  const Rows<K> change = bounded_newton<Kind::bound, K>(inverse_effective_mass(J, W), dot(J, V1, V2) - parting,
                                                        lambda, impulse_bounds(contact, 1, work.rows));
  lambda += change;
  if (moves(mass1)) V1 += W.side1().transpose() * change;
  if (moves(mass2)) V2 += W.side2().transpose() * change;
  work.row_solves += K;
}

}  // namespace detail

//! [step]
/// One time step [s]. Throws std::invalid_argument for a step <= 0 or a method outside its range.
template <class S, class M = typename S::model>
void advance(S& scene, const Xpbd& method, double step, Xpbd::Work<M>& work) {
  require_positive("time step", step, "s");
  for (const double g : scene.gravity) require_finite("gravity", g, "m/s²");
  require_valid(method);
  if constexpr (S::touches) work.touching.find(scene);
  if (lay_out(scene, work.rows)) {
    work.lambda.assign(work.rows.rows(), 0);
    work.approach.assign(work.rows.rows(), 0);
  }
  Bodies<M>& bodies = scene.bodies;
  const double h = work.h = step / method.substeps;
  for (int substep = 0; substep < method.substeps; ++substep) {
    for_each_with_row(scene, [&]<class Kind>(const Kind& constraint, int row) {
      begin_rows(constraint, bodies, h, row, work.rows);
      if constexpr (Kind::bound != Bound::none && Kind::drifting > 0)
        push_out_slowly(constraint, bodies, method.push_speed * h, row, work.rows);
      if constexpr (requires { constraint.restitution; })
        Eigen::Map<Rows<Kind::rows>>(&work.approach[row]) = detail::rate_of(constraint, bodies);
    });
    std::fill(work.rows.impulse.begin(), work.rows.impulse.end(), 0.0);
    begin_turn(method.gyroscopic, bodies, h);
    add_gravity(bodies, scene.gravity, h);
    work.before = bodies.pose;
    advance_poses(bodies, h);
    for (int i = 0; i < method.iterations; ++i)
      for_each_with_row(scene, [&](const auto& constraint, int row) {
        solve_on_positions(constraint, bodies, h, row, work.rows);
      });
    for (int i = 0; i < bodies.size(); ++i)
      if (moves(bodies.inverse_mass[i]))
        bodies.velocity[i] = velocity_between<M>(work.before[i], bodies.pose[i], h);
    end_turn(method.gyroscopic, bodies, h);
    for (int row = 0; row < work.rows.rows(); ++row) work.lambda[row] = work.rows.impulse[row] / h;
    for_each_with_row(scene, [&](const auto& constraint, int row) {
      if constexpr (requires { constraint.restitution; })
        detail::bounce(constraint, bodies, method.bounce_threshold, row, work);
    });
    work.row_solves += static_cast<long long>(method.iterations) * work.rows.rows();
  }
}
//! [step]

}  // namespace byhand
