#include <gtest/gtest.h>

#include "lessons/scenes/balls.hpp"
#include "tests/solver/law_motion.hpp"

// Atlas A10: what a cradle of touching balls does depends on who is asked first.
namespace law_cradle_test {

using namespace byhand;
using M = PlaneBody;
using Cradle = Scene<M>;

std::vector<double> speeds(const Cradle& cradle) {
  std::vector<double> result;
  for (const auto& V : cradle.bodies().velocity) result.push_back(V.x());
  return result;
}
Cradle after_a_step(Cradle cradle, const RowSolver& solver) {
  Simulation<M> simulation{std::move(cradle), {solver}};
  simulation.step(1.0 / 60);
  return simulation.scene;
}
void expect_near(const std::vector<double>& measured, const std::vector<double>& expected, double error) {
  ASSERT_EQ(measured.size(), expected.size());
  for (std::size_t i = 0; i < measured.size(); ++i) EXPECT_NEAR(measured[i], expected[i], error) << i;
}

TEST(LawA10, SolvedAllAtOnceTheFirstBallReturnsAndTheOthersGoTogether) {
  for (const int balls : {2, 3, 5, 10}) {
    std::vector<double> law(balls, 2.0 / balls);
    law[0] = (2.0 - balls) / balls;
    for (const auto order : {SweepOrder::natural, SweepOrder::reverse, SweepOrder::coloured})
      expect_near(speeds(after_a_step(newtons_cradle<M>(balls), GaussSeidel{2000, true, order})), law, 1e-9);
    for (const RowSolver& solver : {RowSolver(Direct{}), RowSolver(ByGraph{})}) {
      const Cradle struck = after_a_step(newtons_cradle<M>(balls), solver);
      expect_near(speeds(struck), law, 1e-12);
      EXPECT_NEAR(linear_momentum(struck.bodies()).x(), 1, 1e-12);
      EXPECT_NEAR(kinetic_energy(struck.bodies()), 0.5, 1e-12);
    }
  }
}

TEST(LawA10, WithinRestitutionsReachEverySolverKeepsMomentum) {
  for (const double e : {0.0, 0.5, 1.0})
    for (const int sweeps : {1, 2, 10})
      for (const auto order : {SweepOrder::natural, SweepOrder::reverse}) {
        const Cradle struck = after_a_step(newtons_cradle<M>(5, e), GaussSeidel{sweeps, true, order});
        EXPECT_NEAR(linear_momentum(struck.bodies()).x(), 1, 1e-14);
        EXPECT_LE(kinetic_energy(struck.bodies()), 0.5 + 1e-14);
      }
}

/// What one sweep over contacts without mass ratios does to speeds: each takes from two balls the mean of their
/// approach, within the λ >= 0 that it has accumulated.
void sweep_by_hand(std::vector<double>& v, std::vector<double>& lambda, const std::vector<double>& bias,
                   bool reverse) {
  const int contacts = static_cast<int>(lambda.size());
  for (int k = 0; k < contacts; ++k) {
    const int i = reverse ? contacts - 1 - k : k;
    const double before = lambda[i];
    lambda[i] = std::max(0.0, before - (v[i + 1] - v[i] + bias[i]) / 2);
    v[i] -= lambda[i] - before;
    v[i + 1] += lambda[i] - before;
  }
}

TEST(LawA10, OneSweepPassesThePushOnInItsOwnDirectionOnly) {
  for (const bool reverse : {false, true}) {
    std::vector<double> v{1, 0, 0, 0, 0}, lambda(4), bias(4);
    sweep_by_hand(v, lambda, bias, reverse);
    bias[0] = -1;  // e times the approach of the first two
    sweep_by_hand(v, lambda, bias, reverse);
    const auto order = reverse ? SweepOrder::reverse : SweepOrder::natural;
    const auto measured = speeds(after_a_step(newtons_cradle<M>(5), GaussSeidel{1, true, order}));
    expect_near(measured, v, 1e-15);
    if (reverse)
      EXPECT_EQ(measured[3], 0) << "two sweeps against the push reach two balls further";
    else
      EXPECT_GT(measured[4], 0.1) << "a sweep along the push reaches the last ball";
  }
}

TEST(LawA10, BallsThatAreApartHandTheSpeedOnAsNatureDoes) {
  for (const RowSolver& solver : {RowSolver(Direct{}), RowSolver(GaussSeidel{1})}) {
    Cradle cradle = newtons_cradle<M>(5);
    for (int i = 0; i < 5; ++i) cradle.state().pose[i].position.x() *= 1.1;
    Simulation<M> simulation{cradle, {solver}};
    run(simulation, 2, 1.0 / 60);
    expect_near(speeds(simulation.scene), {0, 0, 0, 0, 1}, 1e-14);
  }
}

}  // namespace law_cradle_test
