#pragma once

#include <string>
#include <variant>

#include "solver/integrate/euler.hpp"
#include "solver/integrate/gyroscopic.hpp"
#include "solver/methods/drift.hpp"
#include "solver/methods/restitution.hpp"
#include "solver/methods/row_solvers.hpp"
#include "solver/touching.hpp"

namespace byhand {

template <class M>
struct Work;

/// The article's method, as choices: how rows are solved, how drift is cured, when positions move, and into
/// how many equal substeps a step is cut. Cost of a step: substeps × (rows written once + sweeps over them).
struct VelocityStepping {
  template <class M>
  using Work = byhand::Work<M>;

  RowSolver solver = GaussSeidel{};
  DriftCure drift = Baumgarte{};
  Euler euler = Euler::symplectic;
  int substeps = 1;                          // >= 1
  Gyroscopic gyroscopic = Gyroscopic::none;  // of bodies in space
  double bounce_threshold = 0.5;  // slower than this nothing bounces, or what rests would rattle [m/s] >= 0
};

/// Throws std::invalid_argument for a choice outside its range.
void require_valid(const VelocityStepping& method);

/// Why this scene cannot be run so, in one sentence; empty where it can.
template <class S>
std::string refusal(const S& scene, const VelocityStepping& method) {
  if (std::holds_alternative<ConjugateGradients>(method.solver) && has_bounds(scene))
    return "conjugate gradients hold no bounds, and this scene has contacts or other rows with bounds: conjugate "
           "sweeps or an accelerated gradient would";
  return {};
}

/// What split impulse keeps: the impulses of its pseudo-velocities, by row, and the layout they belong to.
struct Pushes {
  std::vector<double> lambda;
  int version = 0;
  Layout layout = Layout::none;
};

/// What is kept between steps.
template <class M>
struct Work : RowWork<M> {
  std::conditional_t<M::angular == 0, NoTouching, Touching<M>> touching;
  std::vector<double> approach;             // JV of rows that may bounce, before they are solved
  std::vector<double> lambda, gamma, rate;  // by row, what a cure changes for its second half
  std::vector<Velocity<M>> velocity;        // as much
  Pushes pushes;
  double h = 0;  // the substep that λ belongs to [s]
};

/// λ is an impulse, a force times h: when the step changes, so does the guess that a warm start makes.
template <class M>
void rescale_impulses(Work<M>& work, double h) {
  if (work.h > 0 && work.h != h)
    for (double& lambda : work.system.lambda) lambda *= h / work.h;
  work.h = h;
}

/// The second solve of contacts that bounce, once positions have moved.
template <class M>
void bounce(const VelocityStepping& method, Bodies<M>& bodies, Work<M>& work) {
  if (!set_bounce(work.approach, method.bounce_threshold, work.system)) return;
  solve_rows(method.solver, bodies, work, Begin::again);
  forget_bounce(work.approach, method.bounce_threshold, work.system);
}

/// The second half of split impulse: poses move with what (22) adds to the velocities, which stay as they are.
template <class M>
void push_poses(const SplitImpulse& cure, const RowSolver& solver, double h, Bodies<M>& bodies, Work<M>& work);

/// The second half of soft constraints: the rows are solved again, hard and without bias, from the λ that stands.
template <class S, class M = typename S::model>
void relax(const SoftConstraints& cure, const RowSolver& solver, double h, S& scene, Work<M>& work) {
  if (!cure.relax) return;
  System<M>& system = work.system;
  if (cure.refresh) {
    work.rate = system.rate;
    scene.write_rows(system, h);
    system.rate = work.rate;  // a spring's, or it would push twice
  } else {
    system.gamma = work.gamma;
  }
  set_bias(NoDriftCure{}, h, system);
  solve_rows(solver, scene.bodies, work, Begin::again);
}

/// The cure's first half, before the rows are solved: b of (21), and γ where rows are to be soft.
template <class M>
void begin_cure(const DriftCure& cure, double h, Work<M>& work) {
  set_bias(cure, h, work.system);
  if (const auto* soft = std::get_if<SoftConstraints>(&cure)) soften(*soft, h, work.system, work.gamma);
}

/// The cure's second half, once the poses have moved.
template <class S, class M = typename S::model>
void end_cure(const VelocityStepping& method, double h, S& scene, Work<M>& work) {
  if (const auto* projection = std::get_if<Projection>(&method.drift))
    work.row_solves += project(*projection, scene);
  if (const auto* split = std::get_if<SplitImpulse>(&method.drift))
    push_poses(*split, method.solver, h, scene.bodies, work);
  if (const auto* soft = std::get_if<SoftConstraints>(&method.drift)) relax(*soft, method.solver, h, scene, work);
}

//! [step]
/// One time step h [s] of the article's method. Throws std::invalid_argument for h <= 0 or a method outside its
/// range or one that refuses the scene, SingularSystem from a direct solve.
template <class S, class M = typename S::model>
void advance(S& scene, const VelocityStepping& method, double step, Work<M>& work) {
  require_steppable(scene, method, step);
  if constexpr (S::touches) work.touching.find(scene);  // the article's n, P1 and P2, from shapes
  lay_out(scene, method.solver, work);
  if constexpr (S::touches) work.touching.template write_impulses<S>(work.system);
  const double h = step / method.substeps;
  for (int i = 0; i < method.substeps; ++i) {
    scene.write_rows(work.system, h);   // J, C, M⁻¹Jᵀ at the current poses
    begin_cure(method.drift, h, work);  // b of (21), (22)
    if (method.euler == Euler::explicit_) advance_poses(scene.bodies, h);
    note_approach(work.system, scene.bodies.velocity, work.approach);
    begin_turn(method.gyroscopic, scene.bodies, h);
    add_gravity(scene.bodies, scene.gravity, h);    // before λ, or the rows cannot answer it
    rescale_impulses(work, h);                      // λ of last step, for the warm start
    solve_rows(method.solver, scene.bodies, work);  // (17) and (20) over all rows
    if (method.euler == Euler::symplectic) advance_poses(scene.bodies, h);
    end_cure(method, h, scene, work);  // its second half, if it has one
    end_turn(method.gyroscopic, scene.bodies, h);
    bounce(method, scene.bodies, work);
  }
  if constexpr (S::touches) work.touching.template read_impulses<S>(work.system);
}
//! [step]

}  // namespace byhand
