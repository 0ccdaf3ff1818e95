#include "lessons/02_single_constraint/steps.hpp"
#include "lessons/02_single_constraint/swing.hpp"
#include "renderer/chart.hpp"

namespace byhand::single_constraint {
namespace {

using namespace tutor;
using namespace renderer;

enum class Gravity { before_the_solve, after_the_solve };

/// Depth [m] below the rod's length of a bob that hangs at rest, after each step.
Curve sinking(const Setting& setting, Gravity order, double seconds) {
  Pendulum scene = pendulum<PlaneParticle>(0, setting.length(), setting.mass());
  const double h = setting.h();
  Curve depth{
      .label = order == Gravity::before_the_solve ? "gravity, then λ" : "λ, then gravity", .x = {0}, .y = {0}};
  const auto steps = static_cast<int>(std::lround(seconds / h));
  for (int i = 1; i <= steps; ++i) {
    if (order == Gravity::before_the_solve) add_gravity(scene.state(), scene.gravity, h);
    std::tie(scene.state().velocity[0], scene.state().velocity[1]) = OneRow(scene).velocities_after();
    if (order == Gravity::after_the_solve) add_gravity(scene.state(), scene.gravity, h);
    advance_poses(scene.state(), h);
    depth.x.push_back(i * h);
    depth.y.push_back(-scene.bodies().pose[1].position.y() - setting.length());
  }
  return depth;
}

}  // namespace

void gravity_after(const Setting& setting, Page& page) {
  const double second = 1, h = setting.h();
  const Curve right = sinking(setting, Gravity::before_the_solve, second),
              wrong = sinking(setting, Gravity::after_the_solve, second);
  page.text(
      R"(The article does not say when gravity enters. Let a bob hang at rest, straight down, and exchange the two
      lines: solve first, then add gravity, then move. In the first step JV = 0, so λ = 0; gravity then makes the
      bob fall at gh, and it moves. The next solve stops it, and gravity is added again after the solve. So in each
      step the bob moves down at gh.)");
  page.figure(
      "gravity_after",
      say(R"(A hanging bob. With gravity before λ it hangs; with gravity after λ it sinks at gh = @ m/s: @ m in @
          s.)",
          gravity() * h, wrong.y.back(), wrong.x.back()),
      Chart{.x = {.label = "time (s)"}, .y = {.label = "depth (m)"}, .curves = {right, wrong}});
  page.text("(17) is right each time; the V that it is given lacks the gravity of that step.");
  // Each step may round the bob's place by one unit in its last digit.
  const double rounding = 2.3e-16 / h * (setting.length() + wrong.y.back());
  page.claim({.quantity = "speed of sinking, gravity after λ",
              .unit = "m/s",
              .expected = gravity() * h,
              .source = "g·h",
              .measured = wrong.y.back() / wrong.x.back(),
              .tolerance = absolute(rounding)});
  page.claim({.quantity = "depth after a second, gravity before λ",
              .unit = "m",
              .expected = 0,
              .source = "it hangs",
              .measured = right.y.back(),
              .tolerance = absolute(1e-12 * setting.length())});
}

}  // namespace byhand::single_constraint
