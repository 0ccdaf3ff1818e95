#include "lessons/laws/soft.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "lessons/laws/closed_forms.hpp"
#include "lessons/laws/numbers.hpp"
#include "lessons/laws/record.hpp"
#include "lessons/laws/warm_start.hpp"
#include "lessons/scenes/chain.hpp"
#include "lessons/scenes/circle.hpp"
#include "solver/measure.hpp"

// Law 11. A spring's force from where its step begins, then symplectic Euler: with s = ωh,
//
//   z² - (2 - 2ζs - s²) z + (1 - 2ζs) = 0,  which passes through z = -1 at s² + 4ζs = 4:  s = 2(√(1 + ζ²) - ζ)
//
// The same as a row that is solved, alone, is implicit Euler and stable for every s (head of
// soft_constraints.hpp). In a chain that is swept once a step it is not: a bond that is soft by its own effective
// mass m/2 has k = mω²/2, and the fastest mode of a long chain 2√(k/m) = √2 ω.
//
// Law 12. What is left of a step solved exactly is the step's own error, and more sweeps do not touch it: the
// stretch (ωh)²/2β of law 1 falls with the square of the substeps. One sweep in each is enough only within law 6,
// which has no h.
//
// Law 14. What goes round at v leaves its circle by v²h²/2R in a step, and a soft row brings it back by a speed u
// along n that amounts to the same: uh = v²h²/2R. If the rows are relaxed at the new pose, the tangent there has
// turned by δ = vh/R against V, and V leaves v cosδ + u sinδ = v on it. Relaxed with the rows of the step's start,
// u is thrown away, the next step leaves v cosδ, and so on:
//
//   dv/dt = -½ h v³/R²,  v = v0 (1 + v0² h t/R²)^-½
//
// Derived for this course.
namespace byhand::laws {
namespace {

/// The largest stretch of a chain that swings for a second from 30° [m].
double stretch_of_a_swing(const VelocityStepping& method) {
  Simulation<PlaneParticle> simulation{
      rod_chain<PlaneParticle, NormalisedDistance>({.links = 5, .angle = std::numbers::pi / 6}), method};
  double worst = 0;
  while (simulation.time < 1 - 0.5 * sixtieth) {
    simulation.step(sixtieth);
    worst = std::max(worst, position_error(simulation.scene).max);
  }
  return worst;
}
double stretch_with_substeps(int substeps) {
  VelocityStepping method{Direct{}, Baumgarte{0.2}};
  method.substeps = substeps;
  return stretch_of_a_swing(method);
}

}  // namespace

Outcome explicit_spring(double omega_h, double damping_ratio) {
  Scene<PlaneParticle> scene;
  scene.add_body(Linear<PlaneParticle>(0, 1e-7), with_mass<PlaneParticle>(1));
  Bodies<PlaneParticle>& bodies = scene.state();
  Record record(1e-7, 1);
  for (int i = 0; i < 3000; ++i) {
    const Linear<PlaneParticle> force =
        -omega_h * omega_h * bodies.pose[0].position - 2 * damping_ratio * omega_h * bodies.velocity[0];
    add_gravity<PlaneParticle>(bodies, force, 1);
    advance_poses(bodies, 1);
    if (!record.note(bodies.pose[0].position.y())) break;
  }
  return record.outcome() == Outcome::explodes ? Outcome::explodes : Outcome::settles;
}

Outcome run(const SoftChain& chain) {
  const SoftConstraints soft{.frequency = 2 * std::numbers::pi * chain.frequency / sixtieth,
                             .damping_ratio = chain.damping_ratio,
                             .relax = chain.relax};
  Simulation<PlaneParticle> simulation{rod_chain<PlaneParticle, NormalisedDistance>({.links = chain.links}),
                                       {GaussSeidel{chain.sweeps}, soft}};
  simulation.scene.gravity.setZero();
  const auto& pose = simulation.scene.bodies().pose;
  const double size = 1e-7;
  for (int i = 1; i <= chain.links; ++i)
    simulation.scene.set_position(i, {pose[i].position.x(), pose[i].position.y() + size * uneven(i)});
  Record record(size, 0.5);
  for (int i = 0; i < 4500; ++i) {
    simulation.step(sixtieth);
    if (!record.note(pose[chain.links].position.y() + chain.links)) break;
  }
  return record.outcome();
}

double speed_left(double speed, double step, bool refresh) {
  VelocityStepping method{Direct{}, SoftConstraints{.frequency = 2 / step, .refresh = refresh}};
  Simulation<PlaneParticle> simulation{particle_on_a_circle<PlaneParticle>(1, speed, 1), method};
  while (simulation.time < 1 - 0.5 * step) simulation.step(step);
  return simulation.scene.bodies().velocity[1].norm() / speed;
}

Law springs() {
  Law law{11,
          Family::too_large_a_step,
          "explicit springs",
          "a spring force taken at the start of the step overshoots",
          "ωh < 2(√(1 + ζ²) − ζ); a chain of soft rows with one warm sweep: √2 ωh < 2",
          {}};
  for (const double damping : {0.0, 0.1, 0.5, 1.0, 5.0})
    law.boundaries.push_back(
        bisected({"ωh",
                  "",
                  fmt::format("explicit spring, ζ {}", damping),
                  2 * (std::sqrt(1 + damping * damping) - damping),
                  0.01,
                  {},
                  [=](double omega_h) { return explicit_spring(omega_h, damping) == Outcome::settles; }}));
  for (const double damping : {0.0, 0.3, 1.0}) {
    const SoftChain chain{.links = 20, .damping_ratio = damping};
    law.boundaries.push_back(bisected({"f h",
                                       "",
                                       fmt::format("20 soft links, one warm sweep, ζ {}", damping),
                                       std::numbers::sqrt2 / (2 * std::numbers::pi),
                                       0.02,
                                       {},
                                       settles(chain, &SoftChain::frequency, run)}));
  }
  return law;
}

Law substeps() {
  Law law{12,
          Family::too_few_iterations,
          "substeps or sweeps",
          "n substeps divide the stretch by n²; sweeps only approach the exact solution of the same step",
          "C(n substeps)/C = 1/n²; C(many sweeps)/C(exact) = 1",
          {}};
  for (const int n : {16, 32})
    law.boundaries.push_back({"stretch / stretch with 8 substeps", "",
                              fmt::format("5 links, exact, {} substeps", n), square(8.0 / n), 0.08,
                              [=] { return stretch_with_substeps(n) / stretch_with_substeps(8); }});
  law.boundaries.push_back(
      {"stretch", "of that of the exact solve", "5 links, 300 sweeps", 1, 0.01, [] {
         return stretch_of_a_swing({GaussSeidel{300}, Baumgarte{0.2}}) / stretch_with_substeps(1);
       }});
  for (const auto& [links, substeps] : {std::pair{5, 4}, {10, 8}}) {
    const WarmChain chain{.links = links, .sweeps = 1, .substeps = substeps, .steps = 6000 / substeps};
    law.boundaries.push_back(bisected({"β",
                                       "",
                                       fmt::format("{} links, {} substeps of one sweep", links, substeps),
                                       largest_beta(left_by_a_sweep(links)),
                                       0.02,
                                       {},
                                       settles(chain, &WarmChain::beta, run)}));
  }
  return law;
}

Law stale_rows() {
  Law law{14,
          Family::wrong_rows,
          "stale Jacobian",
          "rows relaxed with the J of the start of the step undo the turning of the velocity",
          "v = v₀ (1 + v₀² h t/R²)^−½; refreshed v = v₀",
          {}};
  for (const auto& [speed, rate] : {std::pair{1, 60}, {3, 60}, {10, 60}, {10, 240}})
    law.boundaries.push_back({"speed after 1 s / initial speed", "",
                              fmt::format("stale, {} m/s on 1 m, {} Hz", speed, rate),
                              1 / std::sqrt(1 + square(speed) / rate), 0.02,
                              [speed = speed, rate = rate] { return speed_left(speed, 1.0 / rate, false); }});
  for (const int speed : {1, 3})
    law.boundaries.push_back({"speed after 1 s / initial speed", "",
                              fmt::format("refreshed, {} m/s on 1 m, 60 Hz", speed), 1, 0.02,
                              [=] { return speed_left(speed, 1.0 / 60, true); }});
  return law;
}

}  // namespace byhand::laws
