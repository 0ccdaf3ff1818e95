#include "solver/laws/baumgarte.hpp"

#include <fmt/format.h>

#include <cmath>

#include "solver/laws/record.hpp"
#include "solver/scenes/circle.hpp"
#include "solver/simulation.hpp"

// Law 1. Of an error C a step leaves C + h JV = C - βC:
//
//   C(k+1) = (1 - β) C(k), which dies out while |1 - β| < 1: straight down to β = 1, to and fro up to β = 2.
//
// Read as it is printed, (22) has no 1/h: β counts per second, a step takes βh, and the limit is 2/h. And what
// goes round at ω leaves its circle by (ωh)²/2 of its radius in each step, of which β takes its share back, so
// that it stays too long by C/L = (ωh)²/2β.
//
// J. Baumgarte, "Stabilization of constraints and integrals of motion in dynamical systems", Computer Methods in
// Applied Mechanics and Engineering 1, 1972, for the idea; the limit per step is the geometric series'.
namespace byhand::laws {
namespace {

using M = PlaneParticle;
using Rod = Scene<M, NormalisedDistance>;
constexpr double h = 1.0 / 60;

/// C/L of a particle that has gone round for long, by `turn` [rad] a step at first.
double stretch_of_a_spinning_rod(double beta, double turn) {
  Simulation<Rod> simulation{particle_on_a_circle<M>(1, turn / h, 1), {GaussSeidel{}, Baumgarte{beta}}};
  for (int i = 0; i < 300; ++i) simulation.step(h);
  return simulation.scene.bodies.pose[1].position.norm() - 1;
}

}  // namespace

Outcome stretched_rod(double beta, double step, bool literally) {
  const Baumgarte cure{beta, literally ? BetaReading::literal : BetaReading::per_step};
  Simulation<Rod> simulation{particle_on_a_circle<M>(1, 0, 1), {GaussSeidel{}, cure}};
  simulation.scene.bodies.pose[1].position *= 1.001;
  Record record(1e-3, 1);
  for (int i = 0; i < 300; ++i) {
    simulation.step(step);
    if (!record.note(simulation.scene.bodies.pose[1].position.norm() - 1)) break;
  }
  return record.outcome();
}

Law one_row() {
  Law law{1,
          Family::overshooting_correction,
          "a correction by more than the whole error overshoots, by more than twice the error it grows",
          "β < 2; read literally β < 2/h; spinning C/L = (ωh)²/2β",
          {}};
  law.boundaries.push_back(bisected(
      {"β", "", "per step", 2, 0.01, {}, [](double beta) { return stretched_rod(beta, h) == Outcome::settles; }}));
  for (const int rate : {30, 60, 240})
    law.boundaries.push_back(
        bisected({"β", "1/s", fmt::format("literally, {} Hz", rate), 2.0 * rate, 0.01, {}, [=](double beta) {
                    return stretched_rod(beta, 1.0 / rate, true) == Outcome::settles;
                  }}));
  for (const double beta : {0.1, 0.2, 0.5, 1.0}) {
    const double turn = 0.02;
    law.boundaries.push_back({"C/L", "", fmt::format("β {}, {} rad a step", beta, turn), turn * turn / (2 * beta),
                              0.01, [=] { return stretch_of_a_spinning_rod(beta, turn); }});
  }
  return law;
}

}  // namespace byhand::laws
