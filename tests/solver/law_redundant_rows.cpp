#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "lessons/scenes/pendulum.hpp"
#include "tests/solver/law_motion.hpp"

namespace law_redundant_rows_test {

using namespace byhand;
using Pendulum = Scene<PlaneParticle>;
constexpr double pi = std::numbers::pi, g = 9.81, h = 1.0 / 60, length = 2, mass = 3;

/// A pendulum with a second rod between the same two points.
Pendulum doubled(double angle, double other_length) {
  Pendulum scene = pendulum<PlaneParticle, NormalisedDistance>(angle, length, mass);
  scene.add(NormalisedDistance<PlaneParticle>{{0, 1}, other_length});
  return scene;
}

struct Pulls {
  double sum, difference;  // of the two rods [N]
};
Pulls pulls(const Work<PlaneParticle>& work) {
  return {-force(work, 0) - force(work, 1), force(work, 0) - force(work, 1)};
}

const Factorisation factorisations[] = {Factorisation::structured, Factorisation::dense};

TEST(LawA13, ADuplicatedRodHasOneAnswerForTheSumOfItsPulls) {
  const RowSolver solvers[] = {GaussSeidel{.sweeps = 1},
                               GaussSeidel{.sweeps = 30, .warm_start = false},
                               GaussSeidel{.sweeps = 30, .order = SweepOrder::reverse},
                               Jacobi{.sweeps = 60, .relaxation = 0.6},
                               Direct{Factorisation::structured, 1e-9},
                               Direct{Factorisation::dense, 1e-9}};
  for (const RowSolver& solver : solvers) {
    Simulation<PlaneParticle> one{pendulum<PlaneParticle, NormalisedDistance>(pi / 2, length, mass), {Direct{}}};
    Simulation<PlaneParticle> two{doubled(pi / 2, length), {solver}};
    for (int i = 0; i < 120; ++i) {
      one.step(h);
      two.step(h);
      const double expected = -force(one.work, 0);
      ASSERT_NEAR(pulls(two.work).sum, expected, 1e-5 * mass * g) << "solver " << solver.index() << ", step " << i;
    }
    EXPECT_LT((one.scene.bodies().pose[1].position - two.scene.bodies().pose[1].position).norm(), 1e-6);
  }
}

TEST(LawA13, HowADuplicatedRodSharesItsPullIsTheSolversChoice) {
  const auto share = [](const RowSolver& solver) {
    Simulation<PlaneParticle> two{doubled(0, length), {solver}};
    two.step(h);
    return -force(two.work, 0) / (mass * g);
  };
  EXPECT_NEAR(share(GaussSeidel{}), 1, 1e-12);  // the first row that is asked takes all
  EXPECT_NEAR(share(GaussSeidel{.order = SweepOrder::reverse}), 0, 1e-12);
  EXPECT_NEAR(share(Direct{.regularisation = 1e-9}), 0.5, 1e-6);  // the smallest λ
}

TEST(LawA13, WithoutSoftnessADirectSolveRefusesDuplicatesAndConflicts) {
  for (const Factorisation factorisation : factorisations)
    for (const double other : {length, 1.1 * length}) {
      Simulation<PlaneParticle> simulation{doubled(0.3, other), {Direct{factorisation}}};
      const Velocity<PlaneParticle> before = simulation.scene.bodies().velocity[1];
      EXPECT_THAT([&] { simulation.step(h); },
                  testing::Throws<SingularSystem>(testing::Property(
                      &SingularSystem::what, testing::HasSubstr("repeats or contradicts other rows"))));
      EXPECT_EQ(simulation.scene.bodies().velocity[1], before);
    }
}

TEST(LawA13, ConflictingRodsSettleBetweenTheirLengths) {
  Simulation<PlaneParticle> simulation{doubled(0, 1.1 * length), {Direct{.regularisation = 1e-6}, Baumgarte{0.2}}};
  run(simulation, 10, h);
  EXPECT_NEAR(simulation.scene.bodies().pose[1].position.norm(), 1.05 * length, 1e-4);
}

// Each step, each rod undoes the other's correction: β/h · C more impulse, of opposite signs, for ever.
TEST(LawB8, WarmStartedPullsOfConflictingRodsGrowWithoutBoundWhileThePictureIsCalm) {
  Simulation<PlaneParticle> simulation{doubled(0, 1.1 * length), {GaussSeidel{}, Baumgarte{0.2}}};
  const auto step_for = [&](double time) {
    run(simulation, time, h);
    return std::abs(pulls(simulation.work).difference);
  };
  step_for(1);
  const double at_1 = step_for(0), at_6 = step_for(5), at_11 = step_for(5);
  EXPECT_NEAR((at_11 - at_6) / (at_6 - at_1), 1, 1e-3);  // linear
  EXPECT_GT(at_11 - at_6, 1000 * mass * g);
  EXPECT_LT(kinetic_energy(simulation.scene.bodies()), 1e-3 * mass * g * length);
  EXPECT_NEAR(simulation.scene.bodies().pose[1].position.norm(), 1.05 * length, 0.06 * length);
}

TEST(LawB8, SoftnessRegularisationOrAColdStartBoundsThePulls) {
  const auto growth = [](const RowSolver& solver, double softness) {
    Simulation<PlaneParticle> simulation{doubled(0, 1.1 * length), {solver, Baumgarte{0.2}}};
    simulation.scene.change_all<NormalisedDistance>([&](auto& rod) { rod.softness = softness; });
    run(simulation, 10, h);
    const double after_10 = std::abs(pulls(simulation.work).difference);
    run(simulation, 10, h);
    return std::abs(pulls(simulation.work).difference) / after_10;
  };
  EXPECT_NEAR(growth(GaussSeidel{}, 0), 2, 0.02);
  EXPECT_NEAR(growth(GaussSeidel{}, 0.01 / mass), 1, 1e-3);
  EXPECT_NEAR(growth(GaussSeidel{.warm_start = false}, 0), 1, 1e-3);
  for (const Factorisation factorisation : factorisations)
    EXPECT_NEAR(growth(Direct{factorisation, 1e-6}, 0), 1, 1e-3);
}

}  // namespace law_redundant_rows_test
