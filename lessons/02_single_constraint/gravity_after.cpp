#include "lessons/02_single_constraint/steps.hpp"
#include "lessons/02_single_constraint/swing.hpp"

namespace byhand::single_constraint {
namespace {

enum class Gravity { before_the_solve, after_the_solve };

/// How far below the rod's length a bob is that hung at rest [m], after the steps of that time [s].
struct Sunk {
  double depth, time;
};
Sunk sinking(const Setting& setting, Gravity order, double seconds) {
  Pendulum scene = pendulum<PlaneParticle>(0, setting.length(), setting.mass());
  const double h = setting.h();
  const auto steps = static_cast<int>(std::lround(seconds / h));
  for (int i = 0; i < steps; ++i) {
    if (order == Gravity::before_the_solve) add_gravity(scene.state(), scene.gravity, h);
    std::tie(scene.state().velocity[0], scene.state().velocity[1]) = OneRow(scene).velocities_after();
    if (order == Gravity::after_the_solve) add_gravity(scene.state(), scene.gravity, h);
    advance_poses(scene.state(), h);
  }
  return {-scene.bodies().pose[1].position.y() - setting.length(), steps * h};
}

}  // namespace

void gravity_after(const Setting& setting, Page& page) {
  const double second = 1, h = setting.h();
  const Sunk right = sinking(setting, Gravity::before_the_solve, second),
             wrong = sinking(setting, Gravity::after_the_solve, second);
  page.text(
      R"(The article does not say when gravity enters. Let a bob hang at rest and change the order of the step: solve first, then
      add gravity, then move. In the first step JV = 0, so λ = 0; then gravity makes the bob fall at gh, and it moves.
      The next solve stops it, but gravity comes after the solve again.)");
  page.text(
      R"(With gravity before λ it hangs; with gravity after λ it sinks at gh = @ m/s: @ m in @ s. (17) is right both
      times, but in the second case its V does not yet contain this step's gravity.)",
      gravity() * h, wrong.depth, wrong.time);
  // Each step may round the bob's place by one unit in its last digit.
  const double rounding = 2.3e-16 / h * (setting.length() + wrong.depth);
  page.claim("speed of sinking, gravity after λ", wrong.depth / wrong.time, "m/s",
             is(gravity() * h, "g·h", absolute(rounding)));
  page.claim("depth after a second, gravity before λ", right.depth, "m",
             is(0, "it hangs", absolute(1e-12 * setting.length())));
}

}  // namespace byhand::single_constraint
