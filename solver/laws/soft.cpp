#include "solver/laws/soft.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "solver/exact/simple_pendulum.hpp"
#include "solver/laws/disturbance.hpp"
#include "solver/laws/record.hpp"
#include "solver/laws/warm_start.hpp"
#include "solver/measure.hpp"
#include "solver/scenes/chain.hpp"

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
namespace byhand::laws {
namespace {

using M = PlaneParticle;
using Chain = Scene<M, NormalisedDistance>;
constexpr double h = 1.0 / 60;

/// The largest stretch of a chain that swings for a second from 30° [m].
double stretch_of_a_swing(const VelocityStepping& method) {
  Simulation<Chain> simulation{rod_chain<M, NormalisedDistance>({.links = 5, .angle = std::numbers::pi / 6}),
                               method};
  double worst = 0;
  while (simulation.time < 1 - 0.5 * h) {
    simulation.step(h);
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
  Bodies<M> bodies;
  bodies.add({{0, 1e-7}}, with_mass<M>(1), {0, 0});
  Record record(1e-7, 1);
  for (int i = 0; i < 3000; ++i) {
    const Linear<M> force =
        -omega_h * omega_h * bodies.pose[0].position - 2 * damping_ratio * omega_h * bodies.velocity[0];
    add_gravity<M>(bodies, force, 1);
    advance_poses(bodies, 1);
    if (!record.note(bodies.pose[0].position.y())) break;
  }
  return record.outcome() == Outcome::explodes ? Outcome::explodes : Outcome::settles;
}

Outcome run(const SoftChain& chain) {
  const SoftConstraints soft{.frequency = 2 * std::numbers::pi * chain.frequency / h,
                             .damping_ratio = chain.damping_ratio,
                             .relax = chain.relax};
  Simulation<Chain> simulation{rod_chain<M, NormalisedDistance>({.links = chain.links}),
                               {GaussSeidel{chain.sweeps}, soft}};
  simulation.scene.gravity.setZero();
  auto& pose = simulation.scene.bodies.pose;
  const double size = 1e-7;
  for (int i = 1; i <= chain.links; ++i) pose[i].position.y() += size * uneven(i);
  Record record(size, 0.5);
  for (int i = 0; i < 4500; ++i) {
    simulation.step(h);
    if (!record.note(pose[chain.links].position.y() + chain.links)) break;
  }
  return record.outcome();
}

Law springs() {
  Law law{
      11, Family::too_large_a_step, "a spring that acts by where it was overshoots", "ωh < 2(√(1 + ζ²) - ζ)", {}};
  for (const double damping : {0.0, 0.1, 0.5, 1.0, 5.0})
    law.boundaries.push_back(
        bisected({"ωh",
                  "",
                  fmt::format("explicit spring, ζ {}", damping),
                  2 * (std::sqrt(1 + damping * damping) - damping),
                  0.01,
                  {},
                  [=](double omega_h) { return explicit_spring(omega_h, damping) == Outcome::settles; }}));
  return law;
}

Law substeps() {
  Law law{12,
          Family::too_few_iterations,
          "substeps gain their square; sweeps end at the error of the step itself",
          "C(n substeps)/C = 1/n²; C(sweeps)/C(exact) = 1",
          {}};
  for (const int n : {2, 4, 8})
    law.boundaries.push_back({"stretch", "of that with one step", fmt::format("5 links, exact, {} substeps", n),
                              1.0 / (n * n), 0.1,
                              [=] { return stretch_with_substeps(n) / stretch_with_substeps(1); }});
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
                                       [chain](double beta) {
                                         WarmChain corrected = chain;
                                         corrected.beta = beta;
                                         return run(corrected) == Outcome::settles;
                                       }}));
  }
  return law;
}

}  // namespace byhand::laws
