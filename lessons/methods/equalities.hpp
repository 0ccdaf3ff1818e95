#pragma once

#include <cmath>
#include <limits>
#include <stdexcept>

#include "solver/direct/equations.hpp"
#include "solver/integrate/euler.hpp"
#include "solver/rows/operators.hpp"
#include "solver/support/attempt.hpp"

// Shared by methods that hold constraints exactly, as differential-algebraic equations M V̇ = F + Jᵀf with C = 0.
// They run scenes of equalities only.
namespace byhand {

/// What they keep between steps. λ/h is the force in the middle of a substep, to second order.
template <class M>
struct EqualitiesWork : StepWork<M> {
  DirectWork<M> direct;
  std::vector<double> offset, change;  // by row
  Bodies<M> begin;                     // at the start of the substep
};

/// Thrown if the equations of an implicit step are not solved by iteration.
struct NoConvergence : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws std::invalid_argument for fewer than one substep or a regularisation outside [0, 1].
inline void require_valid_equalities(int substeps, double regularisation) {
  require(substeps >= 1, "number of substeps", substeps, "at least 1");
  require_in("regularisation", regularisation, 0, 1);
}

/// Why `method` cannot run this scene; empty if it can.
template <class M>
std::string refusal_unless_equalities(const Scene<M>& scene, const char* method) {
  if (!scene.colliders().shapes.empty())
    return std::string(method) + " knows no contacts, and this scene has bodies that may touch";
  for (const auto& entry : scene.entries()) {
    const ConstraintStore<M>& store = scene.store(entry.kind);
    const double softness = store.softness(entry.index);
    const auto refused = [&](const std::string& reason) {
      return std::string(method) + " holds equalities alone, and constraint " + std::to_string(entry.id) + reason;
    };
    if (store.bound != Bound::none) return refused(" is bounded");
    if (store.position_rows < store.rows) return refused(" is a spring");
    if (softness != 0) return refused(" is soft: it gives way by " + text_of(softness) + " in a step");
  }
  return {};
}

/// M⁻¹F of a body at its pose and velocity: weight, damping, applied forces and, in space, -ω × Iω [m/s², rad/s²].
template <class M>
Velocity<M> free_acceleration(const Bodies<M>& bodies, int body, const Linear<M>& gravity) {
  const BodyForces own = bodies.forces.empty() ? BodyForces{} : bodies.forces[body];
  const Velocity<M>& V = bodies.velocity[body];
  Velocity<M> a = Velocity<M>::Zero();
  a.template head<M::linear>() = own.gravity_scale * gravity - own.linear_damping * V.template head<M::linear>();
  if constexpr (M::angular == 3) {  // Euler's equations, I Ω̇ = IΩ × Ω in the body's axes
    const Eigen::Quaterniond& q = bodies.pose[body].rotation;
    const Eigen::Vector3d &inverse_moments = bodies.inverse_mass[body].angular,
                          spin = rotate(inverse(q), V.template tail<3>());
    const Eigen::Vector3d momentum = spin.cwiseQuotient(inverse_moments);
    a.template tail<3>() = rotate(q, momentum.cross(spin).cwiseProduct(inverse_moments));
  }
  if constexpr (M::angular > 0)
    a.template tail<M::angular>() -= own.angular_damping * V.template tail<M::angular>();
  return a + applied_acceleration(bodies, body);
}

/// Throws std::invalid_argument unless explicit stages and fixed-point iterations of h [s] follow every damping:
/// they are stable below 2.
template <class M>
void require_slow_damping(const Bodies<M>& bodies, double h) {
  for (const BodyForces& own : bodies.forces)
    for (const double rate : {own.linear_damping, own.angular_damping})
      require(rate * h <= 1, "damping in a substep", rate * h,
              "at most 1 for integration of accelerations; take smaller substeps or another method");
}

/// Begins a step of substeps h [s]: if the scene has changed, lays the rows out in the order of elimination.
template <class M>
void begin_equalities(const Scene<M>& scene, double h, EqualitiesWork<M>& work) {
  require_finite<M>(scene.bodies().pose, scene.bodies().velocity, "");
  work.h = h;
  if (work.version == scene.version()) return;
  work.version = scene.version();
  scene.lay_out(elimination_order(scene.graph(), M::dof, work.direct.plan), work.system);
  for (auto* numbers : {&work.offset, &work.change}) numbers->assign(work.system.rows(), 0.0);
}

/// x of JM⁻¹Jᵀ x = -(JV + offset) into `work.change`, for the V of `bodies`.
template <class M>
void solve_rows(double regularisation, const Bodies<M>& bodies, EqualitiesWork<M>& work) {
  if (work.system.rows() == 0) return;
  const Direct solver{.regularisation = regularisation};
  solve_equations(solver, work.system, work.offset, bodies, work.direct, work.change);
  work.row_solves += direct_row_solves(solver, work.direct.plan, work.system.rows(), M::dof);
  ++work.executed.solves;
  work.executed.prepared_rows += work.system.rows();
}

/// Makes a number of substeps.
template <class M, class F>
void run_substeps(int substeps, Scene<M>& scene, EqualitiesWork<M>& work, F&& substep) {
  for (int i = 0; i < substeps; ++i) {
    work.begin = scene.bodies();
    std::fill(work.system.lambda.begin(), work.system.lambda.end(), 0.0);
    substep();
  }
}

/// m|v|² + I|ω|² with the largest moment I, by which velocities in m/s and in rad/s compare.
template <class M>
double square_of(const InverseMass<M>& mass, const Velocity<M>& V) {
  double sum = V.template head<M::linear>().squaredNorm() / mass.linear;
  if constexpr (M::angular > 0) sum += V.template tail<M::angular>().squaredNorm() / mass.angular.minCoeff();
  return sum;
}

/// What an implicit step may leave of its error, as the root of a `square_of`: 1e-9 of the velocities, and of
/// those that lead across the scene or turn by 1 rad in h [s].
template <class M>
double tolerance(const Bodies<M>& bodies, double h) {
  Velocity<M> across = Velocity<M>::Constant(1 / h);
  double size = 0, sum = 0;
  for (const Pose<M>& pose : bodies.pose) size = std::max(size, pose.position.norm());
  across.template head<M::linear>() *= size;
  for (int i = 0; i < bodies.size(); ++i)
    if (const InverseMass<M>& mass = bodies.inverse_mass[i]; moves(mass))
      sum += square_of<M>(mass, bodies.velocity[i]) + square_of<M>(mass, across);
  return 1e-9 * std::sqrt(sum);
}

/// Calls `improve` until error() is at most `enough` and decreases no more, except by rounding, 99 times at most.
/// Throws NoConvergence if it is not at most `enough` then, and for an error that is not finite.
template <class Error, class Improve>
void iterate(double enough, Error&& error, Improve&& improve) {
  double last = std::numeric_limits<double>::infinity();
  for (int count = 1;; ++count) {
    const double now = error();
    if (now == 0 || (now <= enough && (now > 0.9 * last || count == 100))) return;
    if (!std::isfinite(now))
      throw NoConvergence(
          "the equations of an implicit step led to numbers that are not finite; take a smaller step");
    if (count == 100)
      throw NoConvergence("after 100 iterations the equations of an implicit step are wrong by " +
                          text_of(std::ceil(now / enough)) +
                          " times their tolerance, as directions change too much within it; "
                          "take a smaller step or more substeps");
    last = now;
    improve();
  }
}

}  // namespace byhand
