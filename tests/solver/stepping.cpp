#include <gtest/gtest.h>

#include "lessons/scenes/chain.hpp"
#include "lessons/scenes/pendulum.hpp"
#include "tests/solver/compiled.hpp"
#include "tests/solver/solving.hpp"

// Softness, substeps, integrators and what the measures say.
namespace stepping_test {

using namespace byhand;

TEST_IN_ALL_MODELS(Softness, LeavesEachRowAtMinusGammaLambda, 10) {
  const auto scene = random_graph<M>(random, 8, 12);
  for (const RowSolver& solver : {RowSolver(GaussSeidel{.sweeps = 30000, .warm_start = false, .tolerance = 1e-14}),
                                  RowSolver(Direct{}), RowSolver(Direct{Factorisation::dense})}) {
    auto copy = scene;
    Work<M> work;
    advance(copy, {.solver = solver, .gyroscopic = Gyroscopic::none}, time_step, work);
    double worst = 0, largest_term = 0;
    for_each_of<Distance, Pin>(scene, [&](const auto& constraint, int place) {
      const int b1 = constraint.at.body1, b2 = constraint.at.body2, row = work.system.row_of[place];
      const auto J = constraint.jacobian(scene.bodies().pose[b1], scene.bodies().pose[b2]);
      const auto C = constraint.template value<double>(scene.bodies().pose[b1], scene.bodies().pose[b2]);
      if (!moves(scene.bodies().inverse_mass[b1]) && !moves(scene.bodies().inverse_mass[b2])) return;
      const auto JV = dot(J, copy.bodies().velocity[b1], copy.bodies().velocity[b2]);
      for (int k = 0; k < JV.size(); ++k) {
        const double given = constraint.softness * work.system.lambda[row + k];
        worst = std::max(worst, std::abs(JV[k] + 0.2 / time_step * C[k] + given));
        largest_term = std::max(largest_term, std::abs(given));
      }
    });
    EXPECT_LE(worst, 1e-9);
    EXPECT_GT(largest_term, 0.01) << "softness mattered";
  }
}

TEST_IN_ALL_MODELS(Substeps, AreAsManyStepsOfAShareOfTheTime) {
  for (const RowSolver& solver : {RowSolver(GaussSeidel{2}), RowSolver(Direct{})}) {
    auto whole = rod_chain<M>({.links = 4, .angle = 1}), parts = whole;
    Work<M> whole_work, parts_work;
    VelocityStepping method{solver};
    method.substeps = 4;
    for (int i = 0; i < 5; ++i) {
      advance(whole, method, time_step, whole_work);
      for (int j = 0; j < 4; ++j) advance(parts, {solver}, time_step / 4, parts_work);
    }
    EXPECT_EQ(numbers_of<M>(whole.bodies().velocity), numbers_of<M>(parts.bodies().velocity));
    EXPECT_EQ(whole_work.row_solves, parts_work.row_solves);
  }
}

/// Height of a free body after n steps from rest.
template <class M>
double fallen(int steps) {
  Scene<M> scene;
  Random random;
  scene.add_body(Linear<M>(Linear<M>::Zero()), random.mass<M>());
  Work<M> work;
  for (int i = 0; i < steps; ++i) advance(scene, VelocityStepping{}, time_step, work);
  return -scene.bodies().pose[0].position[1];
}

TEST_IN_ALL_MODELS(Euler, FallsHalfAStepAhead) {
  const double gh2 = 9.81 * time_step * time_step;
  for (const int n : {1, 2, 60}) EXPECT_NEAR(fallen<M>(n), gh2 * n * (n + 1) / 2, 1e-12);
}

TEST(Euler, GainsNoEnergyOnAPendulum) {
  auto scene = pendulum<PlaneParticle, NormalisedDistance>(1, 2, 3);
  const double before = energy(scene);
  Work<PlaneParticle> work;
  for (int i = 0; i < 600; ++i) advance(scene, {GaussSeidel{1}}, time_step, work);
  EXPECT_LT(energy(scene), before);
}

TEST(Residual, IsZeroForASolvedSystemAndTheRateOfAnUnsolvedOne) {
  auto scene = rod_chain<PlaneParticle, NormalisedDistance>({.links = 3});
  Work<PlaneParticle> work;
  advance(scene, {Direct{}, NoDriftCure{}}, time_step, work);
  EXPECT_NEAR(residual(work.system, scene.bodies().velocity), 0, 1e-15);
  scene.state().velocity[3].y() -= 0.25;
  EXPECT_NEAR(residual(work.system, scene.bodies().velocity), 0.25, 1e-15);
}

TEST_IN_ALL_MODELS(AlgebraicError, IsTheDistanceFromTheDirectSolve) {
  const auto scene = rod_chain<M, NormalisedDistance>({.links = 2});
  const auto error = [&](const RowSolver& solver) {
    return algebraic_error(Simulation{scene, VelocityStepping{solver, NoDriftCure{}}}, time_step);
  };
  EXPECT_NEAR(error(Direct{}), 0, 1e-14);
  EXPECT_NEAR(error(GaussSeidel{1, false}), 9.81 * time_step / 2, 1e-12) << "half of what the second bob fell";
  EXPECT_GT(error(GaussSeidel{5, false}), error(GaussSeidel{10, false}));
  EXPECT_LE(error(GaussSeidel{200, false}), 1e-12);
}

TEST(RowSolves, CountSweepsTimesRows) {
  auto scene = pinned_chain<PlaneBody>({.links = 7});
  Work<PlaneBody> work;
  VelocityStepping method{GaussSeidel{5}};
  method.substeps = 3;
  advance(scene, method, time_step, work);
  EXPECT_EQ(work.row_solves, 3 * 5 * 14);
  method.solver = Jacobi{4};
  advance(scene, method, time_step, work);
  EXPECT_EQ(work.row_solves, 3 * 5 * 14 + 3 * 4 * 14);
}

TEST(RowSolves, OfADirectSolveGrowWithTheChainAndOfADenseOneWithItsCube) {
  const auto cost = [](Factorisation factorisation, int links) {
    auto scene = pinned_chain<PlaneBody>({.links = links});
    Work<PlaneBody> work;
    advance(scene, {Direct{factorisation}}, time_step, work);
    return static_cast<double>(work.row_solves);
  };
  EXPECT_NEAR(cost(Factorisation::structured, 80) / cost(Factorisation::structured, 40), 2, 0.1);
  EXPECT_NEAR(cost(Factorisation::dense, 160) / cost(Factorisation::dense, 80), 8, 0.5);
}

TEST(PositionError, IsTheLargestAndTheRootMeanSquareOfC) {
  Scene<PlaneParticle> scene;
  for (const double x : {0.0, 1.3, 2.3, 3.9}) scene.add_body({x, 0}, with_mass<PlaneParticle>(1));
  for (int i = 0; i < 3; ++i) scene.add(NormalisedDistance<PlaneParticle>{{i, i + 1}, 1});
  EXPECT_NEAR(position_error(scene).max, 0.6, 1e-14);
  EXPECT_NEAR(position_error(scene).rms, std::sqrt((0.09 + 0.36) / 3), 1e-14);
  scene.add(Contact<PlaneParticle>{{0, 3}, {1, 0}});
  EXPECT_NEAR(position_error(scene).max, 0.6, 1e-14) << "apart is no error of a contact";
  scene.add(Contact<PlaneParticle>{{0, 3}, {-1, 0}});
  EXPECT_NEAR(position_error(scene).max, 3.9, 1e-14) << "overlap is";
}

TEST(Energy, IsTheSumOverTheBodiesThatMove) {
  Scene<SpaceBody> scene;
  scene.add_body(Linear<SpaceBody>(5, 5, 5), fixed<SpaceBody>());
  Velocity<SpaceBody> V;
  V << 1, 2, 3, 0, 0, 4;
  Pose<SpaceBody> pose;
  pose.position = {0, 2, 0};
  pose.rotation =
      space_rotation(Angular<SpaceBody>(std::acos(-1.0) / 2, 0, 0));  // z of the world is -y, or y, of the body
  scene.add_body(pose, with_mass<SpaceBody>(3, {4, 2, 5}), V);
  EXPECT_NEAR(kinetic_energy(scene.bodies()), 0.5 * 3 * 14 + 0.5 * 2 * 16, 1e-12);
  EXPECT_NEAR(potential_energy(scene), 3 * 9.81 * 2, 1e-12);
  EXPECT_NEAR(energy(scene), kinetic_energy(scene.bodies()) + potential_energy(scene), 1e-12);
}

}  // namespace stepping_test
