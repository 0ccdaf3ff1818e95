#pragma once

#include <any>
#include <string>
#include <variant>

#include "solver/constraints/reaction.hpp"
#include "solver/contact/touches.hpp"
#include "solver/cures/baumgarte.hpp"
#include "solver/cures/projection.hpp"
#include "solver/cures/soft_constraints.hpp"
#include "solver/cures/split_impulse.hpp"
#include "solver/direct/by_graph.hpp"
#include "solver/direct/direct.hpp"
#include "solver/direct/semismooth_newton.hpp"
#include "solver/integrate/gyroscopic.hpp"
#include "solver/rows/conjugate_sweeps.hpp"
#include "solver/rows/gauss_seidel.hpp"
#include "solver/rows/jacobi.hpp"
#include "solver/work.hpp"

namespace byhand {

using RowSolver = std::variant<GaussSeidel, Jacobi, Direct, ConjugateSweeps, SemismoothNewton, ByGraph>;
using DriftCure = std::variant<NoDriftCure, Baumgarte, Projection, SplitImpulse, SoftConstraints>;

/// What velocity stepping keeps between steps.
template <class M>
struct Work : StepWork<M> {
  Solution solution;      // of the last step
  std::any solver, cure;  // what the row solver and the cure keep
};

/// The article's method, as choices, with row solvers and cures of any type: one, or a std::variant of several.
/// Those of the library solve, if nothing else is chosen, chains, trees and columns directly and the rest by
/// sweeps until they converge, and leave a slop so that resting bodies keep touching. Cost of a step: substeps ×
/// (rows written once + sweeps over them).
template <class Solver, class Cure>
struct VelocitySteppingWith {
  template <class M>
  using Work = byhand::Work<M>;

  Solver solver = ByGraph{};
  Cure drift = Baumgarte{.slop = 0.001};
  int substeps = 1;                              // equal parts of a step >= 1
  Gyroscopic gyroscopic = Gyroscopic::implicit;  // of bodies in space
  double bounce_threshold = 0.5;  // slower contacts do not bounce, or resting bodies would rattle [m/s] >= 0
};

/// With those of the library. Others include advance.hpp, which has the step itself.
using VelocityStepping = VelocitySteppingWith<RowSolver, DriftCure>;

template <class Solver, class Cure>
void require_valid(const VelocitySteppingWith<Solver, Cure>& method);
template <class M, class Solver, class Cure>
std::string refusal(const Scene<M>& scene, const VelocitySteppingWith<Solver, Cure>& method);
/// One time step h [s]. Throws std::invalid_argument as require_steppable, SingularSystem from a direct solve, and
/// NotFinite instead of leaving NaN or infinity; then the bodies are as they were.
template <class M, class Solver, class Cure>
void advance(Scene<M>& scene, const VelocitySteppingWith<Solver, Cure>& method, double step, Work<M>& work);

template <class M>
void advance(Scene<M>& scene, const VelocityStepping& method, double step, Work<M>& work);

/// Lays the rows out again if the scene has changed or the solver needs another layout.
template <class M>
void lay_out(const Scene<M>& scene, const RowSolver& solver, Work<M>& work);
/// Solves the rows of `work.system`, once they are written, and applies the impulses to the velocities.
template <class M>
void solve_rows(const RowSolver& solver, Bodies<M>& bodies, Work<M>& work, Begin begin = Begin::step);

/// A scene, its method and what that keeps between steps. It is a value: a copy saves the state. The method is a
/// type (see lessons/methods/method.hpp), so that a simulation keeps only what its own method needs.
template <class M, class Method = VelocityStepping>
struct Simulation {
  Scene<M> scene;
  Method method = {};
  typename Method::template Work<M> work = {};
  double time = 0;  // [s]

  /// One time step h [s]. Throws as `advance`.
  void step(double h) {
    advance(scene, method, h, work);
    time += h;
  }

  /// The force and torque that a constraint exerted in the last substep. Throws as byhand::reaction.
  Reaction<M> reaction(int constraint) const { return byhand::reaction(scene, work, constraint); }
  /// λ of a constraint's rows in the last substep. Throws the same.
  std::span<const double> impulse(int constraint) const { return byhand::impulse(scene, work, constraint); }
  /// Who pressed on whom in the last step, where and how hard, and who does so no longer.
  std::vector<Touch<M>> touches() const requires(M::angular > 0) { return byhand::touches(scene, work.contacts); }
  std::vector<BodyPair> parted() const requires(M::angular > 0) { return byhand::parted(work.contacts); }
};

template <class M>
Simulation(Scene<M>) -> Simulation<M>;
template <class M>
Simulation(Scene<M>, VelocityStepping) -> Simulation<M>;
template <class M, class Method>
Simulation(Scene<M>, Method) -> Simulation<M, Method>;

}  // namespace byhand
