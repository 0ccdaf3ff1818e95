#pragma once

#include <variant>

#include "solver/integrate/euler.hpp"
#include "solver/integrate/gyroscopic.hpp"
#include "solver/methods/direct.hpp"
#include "solver/methods/drift.hpp"
#include "solver/methods/gauss_seidel.hpp"
#include "solver/methods/jacobi.hpp"
#include "solver/scene.hpp"

namespace byhand {

using RowSolver = std::variant<GaussSeidel, Jacobi, Direct>;

/// The article's method, as choices: how rows are solved, how drift is cured, when positions move, and into
/// how many equal substeps a step is cut. Cost of a step: substeps × (rows written once + sweeps over them).
struct VelocityStepping {
  RowSolver solver = GaussSeidel{};
  DriftCure drift = Baumgarte{};
  Euler euler = Euler::symplectic;
  int substeps = 1;  // >= 1
  Gyroscopic gyroscopic = Gyroscopic::none;  // of bodies in space
};

/// Throws std::invalid_argument for a choice outside its range.
void require_valid(const VelocityStepping& method);

/// The orders in which rows can be laid out.
enum class Layout { none, natural, reverse, coloured, elimination };

/// What is kept between steps: λ with its system, the layout it was made for, and scratch.
template <class M>
struct Work {
  System<M> system;
  Prepared<M> gauss_seidel;
  JacobiWork<M> jacobi;
  DirectWork<M> direct;
  Layout layout = Layout::none;
  int constraints = 0;       // in the layout
  double h = 0;              // the substep that λ belongs to [s]
  long long row_solves = 0;  // so far; a direct solve counts as the row-solves that its multiplications would buy
};

/// Why the method cannot run a system, in one sentence; empty if it can.
std::string refusal(const VelocityStepping& method, bool bounded);

/// The layout that a solver wants.
Layout wanted_layout(const RowSolver& solver);

/// Constraint numbers in that layout; for Layout::elimination this also makes `plan`.
std::vector<int> solve_order(Layout layout, const Graph& graph, int dof, Elimination& plan);

/// Solves the rows of `work.system` by the chosen solver and puts the impulses into the velocities.
template <class M>
void solve_rows(const RowSolver& solver, Bodies<M>& bodies, Work<M>& work);

/// Lays the rows out anew if constraints were added or the solver wants another order.
template <class S, class M = typename S::model>
void lay_out(const S& scene, const RowSolver& solver, Work<M>& work) {
  const Layout layout = wanted_layout(solver);
  if (work.layout == layout && work.constraints == scene.count()) return;
  scene.lay_out(solve_order(layout, scene.graph(), M::dof, work.direct.plan), work.system);
  work.layout = layout;
  work.constraints = scene.count();
}

/// λ is an impulse, a force times h: when the step changes, so does the guess that a warm start makes.
template <class M>
void rescale_impulses(Work<M>& work, double h) {
  if (work.h > 0 && work.h != h)
    for (double& lambda : work.system.lambda) lambda *= h / work.h;
  work.h = h;
}

//! [step]
/// One time step h [s] of the article's method. Throws std::invalid_argument for h <= 0 or a method that
/// cannot run the scene, SingularSystem from a direct solve.
template <class S, class M = typename S::model>
void advance(S& scene, const VelocityStepping& method, double step, Work<M>& work) {
  require_positive("time step", step, "s");
  for (const double g : scene.gravity) require_finite("gravity", g, "m/s²");
  require_valid(method);
  lay_out(scene, method.solver, work);
  if (const std::string reason = refusal(method, work.system.bounded); !reason.empty())
    throw std::invalid_argument(reason);
  const double h = step / method.substeps;
  for (int i = 0; i < method.substeps; ++i) {
    scene.write_rows(work.system, h);        // J, C, M⁻¹Jᵀ at the current poses
    set_bias(method.drift, h, work.system);  // b of (21), (22)
    if (method.euler == Euler::explicit_) advance_poses(scene.bodies, h);
    begin_turn(method.gyroscopic, scene.bodies, h);
    add_gravity(scene.bodies, scene.gravity, h);    // before λ, or the rows cannot answer it
    rescale_impulses(work, h);                      // λ of last step, for the warm start
    solve_rows(method.solver, scene.bodies, work);  // (17) and (20) over all rows
    if (method.euler == Euler::symplectic) advance_poses(scene.bodies, h);
    end_turn(method.gyroscopic, scene.bodies, h);
  }
}
//! [step]

}  // namespace byhand
