#pragma once

#include <string>
#include <variant>

#include "solver/contact/restitution.hpp"
#include "solver/integrate/euler.hpp"
#include "solver/integrate/gyroscopic.hpp"
#include "solver/methods/projection.hpp"
#include "solver/methods/row_solvers.hpp"
#include "solver/methods/soft_constraints.hpp"
#include "solver/methods/split_impulse.hpp"

namespace byhand {

using DriftCure = std::variant<NoDriftCure, Baumgarte, Projection, SplitImpulse, SoftConstraints>;

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

/// What is kept between steps.
template <class M>
struct Work : RowWork<M> {
  SplitImpulseWork<M> split_impulse;
  SoftWork soft;
};

/// Throws std::invalid_argument for a choice outside its range.
void require_valid(const VelocityStepping& method);

/// Why this scene cannot be run so, in one sentence; empty where it can.
template <class M>
std::string refusal(const Scene<M>& scene, const VelocityStepping& method);

/// One time step h [s] of the article's method. Throws std::invalid_argument for h <= 0 or a method outside its
/// range or one that refuses the scene, SingularSystem from a direct solve.
template <class M>
void advance(Scene<M>& scene, const VelocityStepping& method, double step, Work<M>& work);

/// What moves a simulation that is given no method. Velocity stepping solves chains, trees and columns directly
/// and the rest until it has converged, and leaves bodies at rest in touch.
template <class Method>
Method default_method() {
  if constexpr (std::is_same_v<Method, VelocityStepping>)
    return {ByGraph{}, Baumgarte{.slop = 0.001}};
  else
    return {};
}

/// A scene, the method that moves it and what is kept between steps: a value, so that a copy is a way back.
/// Families of methods are types (see methods/method.hpp), so that a simulation keeps only what its own needs.
template <class M, class Method = VelocityStepping>
struct Simulation {
  Scene<M> scene;
  Method method = default_method<Method>();
  typename Method::template Work<M> work = {};
  double time = 0;  // [s]

  /// One time step h [s]. Errors as `advance`.
  void step(double h) {
    advance(scene, method, h, work);
    time += h;
  }

  /// The force and torque that a constraint exerted in the last substep. Throws std::invalid_argument for one that
  /// the scene does not have or that took no part in it.
  Reaction<M> reaction(int constraint) const { return byhand::reaction(scene, work, constraint); }
};

template <class M>
Simulation(Scene<M>) -> Simulation<M>;
template <class M>
Simulation(Scene<M>, VelocityStepping) -> Simulation<M>;
template <class M, class Method>
Simulation(Scene<M>, Method) -> Simulation<M, Method>;

}  // namespace byhand
