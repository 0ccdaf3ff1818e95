#include <gtest/gtest.h>

#include <numbers>

#include "lessons/exact/simple_pendulum.hpp"
#include "lessons/scenes/four_bar.hpp"
#include "tests/solver/law_motion.hpp"

namespace law_joints_four_bar_test {

using namespace byhand;
constexpr double pi = std::numbers::pi, g = 9.81;
using FourBar = Simulation<PlaneBody>;

double arm_angle(const FourBar& simulation) {
  const auto& bodies = simulation.scene.bodies();
  return angle_from_down(rotate(bodies.pose[1].rotation, Eigen::Vector2d(1, 0)));
}

/// How long a swing takes, over the swings of ten seconds [s].
double period(const FourBarOptions& bars, double h) {
  FourBar simulation{four_bar(bars), {Direct{}, Baumgarte{1}}};
  ZeroCrossings crossings(bars.angle);
  run(simulation, 10, h, [&] { crossings.add(arm_angle(simulation), simulation.time, h); });
  return 2 * (crossings.times.back() - crossings.times.front()) / (crossings.times.size() - 1.0);
}

TEST(LawA11, AFourBarParallelogramSwingsAsASimplePendulum) {
  const FourBarOptions cases[] = {{.angle = 0.5},
                                  {.arm = 0.7, .coupler = 0.4, .arm_mass = 3, .coupler_mass = 0.5, .angle = 1.2},
                                  {.arm = 2, .arm_mass = 0.01, .coupler_mass = 5, .angle = 0.9}};
  for (const FourBarOptions& bars : cases) {
    const double a = bars.arm, m_a = bars.arm_mass, m_c = bars.coupler_mass;
    EXPECT_NEAR(pendulum_length(bars), a * (2 * m_a / 3 + m_c) / (m_a + m_c), 1e-14);
    const double exact = SimplePendulum(bars.angle, pendulum_length(bars), g).period();
    const double coarse = period(bars, 1.0 / 240) / exact - 1, fine = period(bars, 1.0 / 480) / exact - 1;
    EXPECT_NEAR(fine, 0, 3e-5);
    EXPECT_NEAR(order(coarse, fine), 2, 0.2);
  }
}

TEST(LawA11, TheCouplerKeepsLevel) {
  FourBar simulation{four_bar({.angle = 1}), {Direct{}, Baumgarte{1}}};
  run(simulation, 5, 1.0 / 240, [&] {
    ASSERT_NEAR(angle(simulation.scene.bodies().pose[3].rotation), 0, 1e-3);
    ASSERT_LT(position_error(simulation).max, 1e-3);
  });
}

// Two rows of the arms' pins then say the same: all bars lie along one line.
TEST(LawA11, FlatItIsSingularAndARegularisationDecides) {
  for (const auto factorisation : {Factorisation::structured, Factorisation::dense}) {
    FourBar flat{four_bar({.angle = pi / 2}), {Direct{factorisation}}};
    EXPECT_THROW(flat.step(1.0 / 240), SingularSystem);
    FourBar cured{four_bar({.angle = pi / 2}), {Direct{factorisation, 1e-9}, Baumgarte{1}}};
    EXPECT_NO_THROW(run(cured, 1, 1.0 / 240));
    EXPECT_LT(position_error(cured).max, 1e-2);
    FourBar nearly{four_bar({.angle = pi / 2 - 1e-3}), {Direct{factorisation}, Baumgarte{1}}};
    EXPECT_NO_THROW(nearly.step(1.0 / 240));
  }
}

TEST(LawA11, AThirdParallelArmRepeatsARowAndMovesAllTheSame) {
  const FourBarOptions bars{.angle = 0.8, .arms = 3};
  FourBar refused{four_bar(bars), {Direct{}}};
  EXPECT_THROW(refused.step(1.0 / 240), SingularSystem);
  FourBar simulation{four_bar(bars), {Direct{.regularisation = 1e-9}, Baumgarte{1}}};
  const double exact = SimplePendulum(bars.angle, pendulum_length(bars), g).period();
  ZeroCrossings crossings(bars.angle);
  run(simulation, 10, 1.0 / 480, [&] { crossings.add(arm_angle(simulation), simulation.time, 1.0 / 480); });
  EXPECT_NEAR(2 * (crossings.times.back() - crossings.times.front()) / (crossings.times.size() - 1.0) / exact, 1,
              3e-5);
}

}  // namespace law_joints_four_bar_test
