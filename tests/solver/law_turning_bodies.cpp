#include <gtest/gtest.h>

#include <numbers>

#include "lessons/scenes/box_on_an_arm.hpp"
#include "lessons/scenes/pendulum.hpp"
#include "tests/solver/law_motion.hpp"

namespace law_turning_bodies_test {

using namespace byhand;
constexpr double h = 1.0 / 60;

/// The error of a hinge after one step of a weightless rod that turns about it by `turn` [rad].
double anchor_error(double turn, double rod_length, double angle) {
  Simulation<PlaneBody> simulation{hinged_rod(angle, rod_length, 3), {Direct{}, NoDriftCure{}}};
  simulation.scene.gravity.setZero();
  const Eigen::Vector2d arm = simulation.scene.bodies().pose[1].position;
  simulation.scene.state().velocity[1] = turn / h * Eigen::Vector3d(-arm.y(), arm.x(), 1);
  simulation.step(h);
  const auto& bodies = simulation.scene.bodies();
  return simulation.scene.all<Pin>()[0].value<double>(bodies.pose[0], bodies.pose[1]).norm();
}

TEST(LawB13, AStepLeavesTheAnchorOffByTheArcsDistanceFromItsTangent) {
  for (const double length : {0.5, 2.0})
    for (const double angle : {0.0, 0.8, 2.5})
      for (const double turn : {1e-3, 0.01, 0.1, 0.5, 1.0, 1.5, -0.7, 3.0}) {
        const double law = length / 2 * std::hypot(turn - std::sin(turn), 1 - std::cos(turn));
        EXPECT_NEAR(anchor_error(turn, length, angle), law, 3e-15) << "turn " << turn << ", arm " << length / 2;
      }
}

TEST(LawB13, ForSmallTurnsTheAnchorIsOffByHalfTheSquare) {
  for (const double turn : {0.01, 0.03, 0.1})
    EXPECT_NEAR(anchor_error(turn, 2, 0) / (turn * turn / 2), 1, turn * turn);
}

/// How far a small box on a long arm leaves its pin in 5 s from level [m].
double drift(const RowSolver& solver) {
  Simulation<PlaneBody> simulation{box_on_an_arm(0.1, 1, std::numbers::pi / 2), {solver, Baumgarte{0.2}}};
  double worst = 0;
  run(simulation, 5, h, [&] { worst = std::max(worst, position_error(simulation.scene).max); });
  return worst;
}

TEST(LawB15, APinSolvedAsABlockDriftsTwelveMillimetres) {
  for (const int sweeps : {1, 10, 30})
    for (const bool warm : {false, true})
      EXPECT_NEAR(drift(GaussSeidel{.sweeps = sweeps, .warm_start = warm}), 0.012, 5e-4) << sweeps;
  EXPECT_NEAR(drift(Direct{}), drift(GaussSeidel{.sweeps = 1}), 1e-12);
}

TEST(LawB15, RowByRowItDriftsTwentyTimesAsFarAtTheUsualSweeps) {
  const auto row_by_row = [](int sweeps, bool warm) {
    return drift(GaussSeidel{.sweeps = sweeps, .warm_start = warm, .block_solve = BlockSolve::row_by_row});
  };
  double before = 1;
  for (const int sweeps : {10, 20, 30}) {
    const double cold = row_by_row(sweeps, false);
    EXPECT_GT(cold, 0.2) << sweeps;
    EXPECT_LT(cold, 0.6) << sweeps;
    EXPECT_LT(cold, before) << sweeps;
    EXPECT_GT(row_by_row(sweeps, true), 2 * 0.012) << sweeps;  // a warm start helps, and not enough
    before = cold;
  }
  EXPECT_NEAR(row_by_row(3000, false), 0.012, 5e-4);
}

}  // namespace law_turning_bodies_test
