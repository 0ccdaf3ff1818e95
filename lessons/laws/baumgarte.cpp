#include "lessons/laws/baumgarte.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lessons/laws/closed_forms.hpp"
#include "lessons/laws/numbers.hpp"
#include "lessons/laws/record.hpp"
#include "lessons/scenes/circle.hpp"
#include "solver/step.hpp"

// Law 1. Of an error C a step leaves C + h JV = C - βC:
//
//   C(k+1) = (1 - β) C(k), which dies out while |1 - β| < 1: straight down to β = 1, to and fro up to β = 2.
//
// Read as it is printed, (22) has no 1/h: β counts per second, a step takes βh, and the limit is 2/h. And what
// goes round at ω leaves its circle by (ωh)²/2 of its radius in each step, of which β takes its share back, so
// that it stays too long by C/L = (ωh)²/2β.
//
// Law 3. Without a cure nothing takes (vh)²/2R back, and the distance R grows by that in every step; vR, the
// angular momentum, stays: dR/dt = h v²/2R = h (v0 R0)²/2R³, so that
//
//   R = R0 (1 + 2 v0² h t/R0²)^¼,  first linear in t, then its fourth root
//
// J. Baumgarte, "Stabilization of constraints and integrals of motion in dynamical systems", Computer Methods in
// Applied Mechanics and Engineering 1, 1972, for the idea; the limit per step is the geometric series'.
namespace byhand::laws {
namespace {

/// C/L of a particle that has gone round for long, by `turn` [rad] a step at first.
double measured_stretch(double beta, double turn) {
  Simulation<PlaneParticle> simulation{particle_on_a_circle<PlaneParticle>(1, turn / sixtieth, 1),
                                       {GaussSeidel{}, Baumgarte{beta}}};
  for (int i = 0; i < 300; ++i) simulation.step(sixtieth);
  return simulation.scene.bodies().pose[1].position.norm() - 1;
}

/// R/R0 of a particle that nothing draws back, after 1 s.
double spread(double speed, double step) {
  Simulation<PlaneParticle> simulation{particle_on_a_circle<PlaneParticle>(1, speed, 1),
                                       {GaussSeidel{}, NoDriftCure{}}};
  while (simulation.time < 1 - 0.5 * step) simulation.step(step);
  return simulation.scene.bodies().pose[1].position.norm();
}

}  // namespace

Outcome stretched_rod(double beta, double step, bool literally) {
  const Baumgarte cure{beta, literally ? BetaReading::literal : BetaReading::per_step};
  Simulation<PlaneParticle> simulation{particle_on_a_circle<PlaneParticle>(1, 0, 1), {GaussSeidel{}, cure}};
  simulation.scene.set_position(1, 1.001 * simulation.scene.bodies().pose[1].position);
  Record record(1e-3, 1);
  for (int i = 0; i < 300; ++i) {
    simulation.step(step);
    if (!record.note(simulation.scene.bodies().pose[1].position.norm() - 1)) break;
  }
  return record.outcome();
}

Law one_row() {
  Law law{1,
          Family::overshooting_correction,
          "drift correction of one row",
          "correcting more than the error overshoots; correcting more than twice the error makes it grow",
          "β < 2; read literally β < 2/h; spinning C/L = (ωh)²/2β",
          {}};
  law.boundaries.push_back(bisected({"β", "", "per step", 2, 0.01, {}, [](double beta) {
                                       return stretched_rod(beta, sixtieth) == Outcome::settles;
                                     }}));
  for (const int rate : {30, 60, 240})
    law.boundaries.push_back(
        bisected({"β", "1/s", fmt::format("literally, {} Hz", rate), 2.0 * rate, 0.01, {}, [=](double beta) {
                    return stretched_rod(beta, 1.0 / rate, true) == Outcome::settles;
                  }}));
  for (const double beta : {0.1, 0.2, 0.5, 1.0}) {
    const double turn = 0.02;
    law.boundaries.push_back({"C/L", "", fmt::format("β {}, {} rad a step", beta, turn),
                              stretch_of_a_spinning_rod(turn, beta), 0.01,
                              [=] { return measured_stretch(beta, turn); }});
  }
  return law;
}

Law uncorrected_drift() {
  Law law{3,
          Family::too_large_a_step,
          "drift without correction",
          "without a correction, whatever goes round drifts outwards",
          "R = R₀ (1 + 2 v₀² h t/R₀²)^¼",
          {}};
  for (const auto& [speed, rate] : {std::pair{1, 60}, {3, 60}, {10, 60}, {30, 60}, {30, 240}})
    law.boundaries.push_back({"R/R₀ after 1 s", "", fmt::format("{} m/s on 1 m, {} Hz", speed, rate),
                              drifted_radius(1, speed, 1.0 / rate, 1), 0.01,
                              [speed = speed, rate = rate] { return spread(speed, 1.0 / rate); }});
  return law;
}

}  // namespace byhand::laws
