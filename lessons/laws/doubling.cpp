#include "lessons/laws/doubling.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lessons/laws/closed_forms.hpp"
#include "lessons/scenes/circle.hpp"
#include "solver/step.hpp"

// Law 21. Step doubling estimates the error of a step by making it once with h and again as two of h/2. Of an
// error C, β per step leaves (1 - β) C after the one step and (1 - β)² C after the two:
//
//   difference = (1 - β) C - (1 - β)² C = β (1 - β) C,  without any h
//
// So the estimate has a floor: no step is short enough for a tolerance below it, and over h, as errors are
// controlled per unit of time, it even grows as 1/h. What is wrong is not the estimate. β per step is no rule for
// a differential equation: it takes C away in a time of h/β, and as h goes to 0 that is a jump. Read as it is
// printed, (22) has a limit, Ċ = -βC with β in 1/s; then β h takes the place of β, the steps leave 1 - βh and (1 -
// βh/2)², and
//
//   difference = (βh/2)² C,  which falls as h²
//
// Accuracy can thus be the input of a method whose steps have a limit: RATTLE, generalised coordinates, soft rows
// of a given stiffness, or (22) per second. Derived for this course.
namespace byhand::laws {

double doubling_difference(double beta, double step, double error, bool literally) {
  const auto after = [&](int steps) {
    const Baumgarte cure{beta, literally ? BetaReading::literal : BetaReading::per_step};
    Simulation<PlaneParticle> simulation{particle_on_a_circle<PlaneParticle>(1, 0, 1), {GaussSeidel{}, cure}};
    simulation.scene.set_position(1, {1 + error, 0});
    for (int i = 0; i < steps; ++i) simulation.step(step / steps);
    return simulation.scene.bodies().pose[1].position.x() - 1;
  };
  return std::abs(after(1) - after(2));
}

Law step_doubling() {
  Law law{21,
          Family::overshooting_correction,
          "step doubling",
          "a step and its two halves differ by β(1 − β)C however short they are: that is no measure of accuracy",
          "difference = β(1 − β)C; read literally (βh/2)²C",
          {}};
  for (const double beta : {0.1, 0.2, 0.5, 0.9})
    for (const double step : {1e-2, 1e-5})
      law.boundaries.push_back({"difference", "m", fmt::format("β {}, h {} s, C 0.1 m", beta, step),
                                difference_of_a_doubled_step(beta, 0.1), 1e-6,
                                [=] { return doubling_difference(beta, step, 0.1); }});
  for (const double step : {1e-2, 1e-3})
    law.boundaries.push_back({"difference", "m", fmt::format("literally, β 20 1/s, h {} s, C 0.1 m", step),
                              std::pow(20 * step / 2, 2) * 0.1, 1e-6,
                              [=] { return doubling_difference(20, step, 0.1, true); }});
  return law;
}

}  // namespace byhand::laws
