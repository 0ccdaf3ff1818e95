#pragma once

#include <string>
#include <variant>

#include "solver/integrate/euler.hpp"
#include "solver/integrate/gyroscopic.hpp"
#include "solver/methods/conjugate_sweeps.hpp"
#include "solver/methods/direct.hpp"
#include "solver/methods/drift.hpp"
#include "solver/methods/gauss_seidel.hpp"
#include "solver/methods/jacobi.hpp"
#include "solver/methods/restitution.hpp"
#include "solver/scene.hpp"
#include "solver/touching.hpp"

namespace byhand {

/// The choice left to the scene's graph: what has no loops (chains, trees, columns) is solved directly, the rest
/// by conjugate sweeps that stop when they have nothing more to do.
struct ByGraph {
  Direct loopless = {};
  ConjugateSweeps loops = {};
};

using RowSolver = std::variant<GaussSeidel, Jacobi, Direct, ConjugateSweeps, ByGraph>;

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
std::string refusal(const S&, const VelocityStepping&) {
  return {};
}

/// The orders in which rows can be laid out.
enum class Layout { none, natural, reverse, coloured, elimination };

/// What is kept between steps: λ with its system, the layout it was made for, and scratch.
template <class M>
struct Work {
  System<M> system;
  Prepared<M> gauss_seidel;
  JacobiWork<M> jacobi;
  DirectWork<M> direct;
  ConjugateWork<M> conjugate;
  std::conditional_t<M::angular == 0, NoTouching, Touching<M>> touching;
  std::vector<double> approach;  // JV of rows that may bounce, before they are solved
  Layout layout = Layout::none;
  int version = 0;           // of the scene that is laid out
  bool loopless = false;     // its graph
  double h = 0;              // the substep that λ belongs to [s]
  long long row_solves = 0;  // so far; a direct solve counts as the row-solves that its multiplications would buy
};

/// The layout that a solver wants; `loopless` is whether the scene's graph has no loops.
Layout wanted_layout(const RowSolver& solver, bool loopless);

/// Constraint numbers in that layout; for Layout::elimination this also makes `plan`.
std::vector<int> solve_order(Layout layout, const Graph& graph, int dof, Elimination& plan);

/// Solves the rows of `work.system` by the chosen solver and puts the impulses into the velocities.
template <class M>
void solve_rows(const RowSolver& solver, Bodies<M>& bodies, Work<M>& work, Begin begin = Begin::step);

/// Lays the rows out anew if constraints were added or the solver wants another order.
template <class S, class M = typename S::model>
void lay_out(const S& scene, const RowSolver& solver, Work<M>& work) {
  if (work.version == scene.version() && work.layout == wanted_layout(solver, work.loopless)) return;
  const Graph graph = scene.graph();
  work.loopless = has_no_loops(graph);
  work.layout = wanted_layout(solver, work.loopless);
  work.version = scene.version();
  scene.lay_out(solve_order(work.layout, graph, M::dof, work.direct.plan), work.system);
}

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

//! [step]
/// One time step h [s] of the article's method. Throws std::invalid_argument for h <= 0 or a method outside its
/// range, SingularSystem from a direct solve.
template <class S, class M = typename S::model>
void advance(S& scene, const VelocityStepping& method, double step, Work<M>& work) {
  require_positive("time step", step, "s");
  for (const double g : scene.gravity) require_finite("gravity", g, "m/s²");
  require_valid(method);
  if constexpr (S::touches) work.touching.find(scene);  // the article's n, P1 and P2, from shapes
  lay_out(scene, method.solver, work);
  if constexpr (S::touches) work.touching.template write_impulses<S>(work.system);
  const double h = step / method.substeps;
  for (int i = 0; i < method.substeps; ++i) {
    scene.write_rows(work.system, h);        // J, C, M⁻¹Jᵀ at the current poses
    set_bias(method.drift, h, work.system);  // b of (21), (22)
    if (method.euler == Euler::explicit_) advance_poses(scene.bodies, h);
    note_approach(work.system, scene.bodies.velocity, work.approach);
    begin_turn(method.gyroscopic, scene.bodies, h);
    add_gravity(scene.bodies, scene.gravity, h);    // before λ, or the rows cannot answer it
    rescale_impulses(work, h);                      // λ of last step, for the warm start
    solve_rows(method.solver, scene.bodies, work);  // (17) and (20) over all rows
    if (method.euler == Euler::symplectic) advance_poses(scene.bodies, h);
    work.row_solves += project(method.drift, scene);  // the cure's second half, if it has one on poses
    end_turn(method.gyroscopic, scene.bodies, h);
    bounce(method, scene.bodies, work);
  }
  if constexpr (S::touches) work.touching.template read_impulses<S>(work.system);
}
//! [step]

}  // namespace byhand
