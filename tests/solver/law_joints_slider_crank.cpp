#include <gtest/gtest.h>

#include "lessons/exact/slider_crank.hpp"
#include "lessons/scenes/slider_crank.hpp"
#include "tests/solver/law_motion.hpp"

namespace law_joints_slider_crank_test {

using namespace byhand;
using Machine = Simulation<PlaneBody>;

TEST(LawSliderCrank, ClosedFormIsItsOwnDerivative) {
  const SliderCrank exact(0.5, 1.5);
  EXPECT_DOUBLE_EQ(exact.position(0), 2);
  EXPECT_DOUBLE_EQ(exact.position(std::acos(-1)), 1);
  for (double angle = -3; angle < 3; angle += 0.1) {
    const double d = 1e-5;
    EXPECT_NEAR((exact.position(angle + d) - exact.position(angle - d)) / (2 * d), exact.speed(angle), 1e-9);
    EXPECT_NEAR((exact.speed(angle + d) - exact.speed(angle - d)) / (2 * d), exact.acceleration(angle), 1e-9);
  }
  EXPECT_THROW(SliderCrank(1, 0.9), std::invalid_argument);
}

/// The largest distance of the piston from where the closed form has it, over two turns [m].
double piston_error(double h) {
  const SliderCrankOptions options{.angle = 0.3};
  const SliderCrank exact(options.crank, options.rod);
  Machine machine{slider_crank(options), {Direct{}, Baumgarte{1}}};
  double worst = 0;
  run(machine, 2, h, [&] {
    const double angle = options.angle + options.speed * machine.time;
    worst = std::max(worst, std::abs(machine.scene.bodies().pose[3].position.x() - exact.position(angle)));
  });
  return worst;
}

TEST(LawSliderCrank, APistonFollowsItsClosedForm) {
  const double coarse = piston_error(1.0 / 240), fine = piston_error(1.0 / 480);
  EXPECT_LT(fine, 2e-4);
  EXPECT_NEAR(order(coarse, fine), 2, 0.2);
}

TEST(LawSliderCrank, TheMotorTurnsTheCrankAtItsSpeedWhateverHangsOnIt) {
  const SliderCrankOptions options{.piston_mass = 50};
  Machine machine{slider_crank(options), {Direct{}, Baumgarte{1}}};
  run(machine, 2, 1.0 / 240, [&] { ASSERT_NEAR(machine.scene.bodies().velocity[1][2], options.speed, 1e-9); });
}

// With the piston alone heavy, the crank's torque times its speed is the piston's gain of kinetic energy.
TEST(LawSliderCrank, TheMotorsTorqueIsThatOfThePistonsInertia) {
  const SliderCrankOptions options{.crank_mass = 1e-6, .rod_mass = 1e-6, .piston_mass = 2};
  const SliderCrank exact(options.crank, options.rod);
  const auto worst = [&](double h) {
    Machine machine{slider_crank(options), {Direct{}, Baumgarte{1}}};
    double largest = 0;
    machine.step(h);  // the first step also takes up what the start was off by
    run(machine, 2, h, [&] {
      const double angle = options.speed * (machine.time - h);  // where the step solved its rows
      const double torque =
          options.piston_mass * options.speed * options.speed * exact.speed(angle) * exact.acceleration(angle);
      largest = std::max(largest, std::abs(force(machine.work, 4) - torque));
    });
    return largest;
  };
  const double peak = options.piston_mass * options.speed * options.speed * options.crank * options.crank;
  EXPECT_LT(worst(1.0 / 960), 0.02 * peak);
  EXPECT_NEAR(order(worst(1.0 / 480), worst(1.0 / 960)), 1, 0.3);
}

TEST(LawSliderCrank, AMotorThatIsTooWeakGivesAllItHasAndNoMore) {
  const SliderCrankOptions options{.piston_mass = 50, .strength = 20};
  Machine machine{slider_crank(options), {Direct{}, Baumgarte{1}}};
  const double h = 1.0 / 240;
  bool at_bound = false, slower = false;
  run(machine, 3, h, [&] {
    const double lambda = machine.impulse(4)[0];
    ASSERT_LE(std::abs(lambda), options.strength * h);
    at_bound = at_bound || std::abs(lambda) == options.strength * h;
    slower = slower || machine.scene.bodies().velocity[1][2] < 0.9 * options.speed;
  });
  EXPECT_TRUE(at_bound);
  EXPECT_TRUE(slower);
}

}  // namespace law_joints_slider_crank_test
