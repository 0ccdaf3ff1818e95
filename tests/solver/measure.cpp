#include "solver/measure.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lessons/scenes/chain.hpp"
#include "solver/constraints/contact.hpp"
#include "solver/constraints/friction.hpp"
#include "solver/constraints/normalised_distance.hpp"

// What a solve reports of itself, on scenes small enough to know the answer.
namespace measure_test {

using namespace byhand;

constexpr double h = 1.0 / 60;

/// A bob that moves and the point that it hangs from, in this order.
Scene<PlaneParticle> bob_and_pivot() {
  Scene<PlaneParticle> scene;
  scene.add_body({0, -1.5}, with_mass<PlaneParticle>(2));
  scene.add_body({0, 0}, fixed<PlaneParticle>());
  return scene;
}

TEST(PositionError, OfNoRowIsZeroAndOfOneRowIsItsOwn) {
  Scene<PlaneParticle> scene = bob_and_pivot();
  EXPECT_EQ(position_error(scene).max, 0);
  EXPECT_EQ(position_error(scene).rms, 0);
  scene.add(NormalisedDistance<PlaneParticle>{{0, 1}, 1});
  EXPECT_DOUBLE_EQ(position_error(scene).max, 0.5);
  EXPECT_DOUBLE_EQ(position_error(scene).rms, 0.5);
}

TEST(PotentialEnergy, OfASpringIsHalfItsStiffnessTimesTheSquareOfItsStretch) {
  Scene<PlaneParticle> scene = bob_and_pivot();
  const double weight = potential_energy(scene);
  EXPECT_DOUBLE_EQ(weight, -2 * 9.81 * 1.5);
  scene.add(Spring<PlaneParticle>{{0, 1}, 1.2, {.stiffness = 40, .damping = 3}});
  EXPECT_NEAR(potential_energy(scene), weight + 0.5 * 40 * 0.3 * 0.3, 1e-12);
}

TEST(Residual, OfARowThatItsBoundStopsIsWhatAnotherSolveWouldChange) {
  Scene<PlaneParticle> scene = bob_and_pivot();
  Contact<PlaneParticle> contact{{1, 0}, {1, 0}};
  contact.softness = 0.25;
  scene.add(contact);
  System<PlaneParticle> system;
  scene.lay_out({0}, system);
  scene.write_rows(system, h);
  system.lambda[0] = 2;
  system.bias[0] = 10;
  // (17) asks for Δλ = -(b + γλ)/D = -14 with D = 1/m + γ = 0.75; the bound λ >= 0 allows -2.
  EXPECT_DOUBLE_EQ(residual(system, scene.bodies().velocity), 2 * std::sqrt(0.75 * 0.5));
  system.bias[0] = 0.25;
  EXPECT_DOUBLE_EQ(residual(system, scene.bodies().velocity), (0.25 + 0.25 * 2) * std::sqrt(0.5 / 0.75));
}

TEST(AlgebraicError, IsThatOfTheSweepsAndNoneOfTheDirectSolve) {
  Simulation chain{pinned_chain<PlaneBody>({.links = 5, .angle = 1}), {Direct{}}};
  for (int i = 0; i < 10; ++i) chain.step(h);
  EXPECT_LE(algebraic_error(chain, h), 1e-12);
  chain.method.solver = GaussSeidel{1};
  EXPECT_GE(algebraic_error(chain, h), 1e-3);
}

TEST(Measures, OfWhatIsNotANumberAreNone) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto chain = pinned_chain<PlaneBody>({.links = 5, .angle = 1});
  for (int body = 1; body <= 5; ++body) {
    Simulation simulation{chain, {Direct{}}};
    simulation.step(h);
    auto& bodies = simulation.scene.state();
    bodies.pose[body].position[0] = nan;
    EXPECT_TRUE(std::isnan(position_error(simulation.scene).max)) << body;
    EXPECT_TRUE(std::isnan(position_error(simulation.scene).rms)) << body;
    EXPECT_TRUE(std::isnan(algebraic_error(simulation, h))) << body;
    bodies.velocity[body][1] = nan;
    EXPECT_TRUE(std::isnan(residual(simulation.work.system, bodies.velocity))) << body;
    EXPECT_TRUE(std::isnan(energy(simulation.scene))) << body;
    EXPECT_TRUE(std::isnan(linear_momentum(bodies)[1])) << body;
    EXPECT_TRUE(std::isnan(angular_momentum(bodies)[0])) << body;
  }
  Scene<PlaneParticle> scene = bob_and_pivot();
  scene.add(Contact<PlaneParticle>{{1, 0}, {1, 0}});
  scene.state().pose[0].position[0] = nan;
  EXPECT_TRUE(std::isnan(position_error(scene).max)) << "one-sided";
}

TEST(GaussSeidel, StopsAfterTheFirstSweepThatChangesNoBody) {
  Scene<PlaneParticle> scene = bob_and_pivot();
  scene.add(NormalisedDistance<PlaneParticle>{{0, 1}, 1.5});
  GaussSeidel solver{.tolerance = 1e-12};
  for (const auto& [order, passes] : {std::pair(SweepOrder::natural, 2), {SweepOrder::symmetric, 4}}) {
    solver.order = order;
    Simulation pendulum{scene, {solver}};
    pendulum.step(h);  // the first sweep solves the row, the second has nothing to do
    EXPECT_EQ(pendulum.work.row_solves, passes);
  }
}

TEST(Rows, BetweenFixedBodiesGetNoImpulse) {
  Scene<SpaceBody> scene;
  const int ground = scene.add_body({0, 0, 0}, fixed<SpaceBody>());
  const int wall = scene.add_body({1, 0, 0}, fixed<SpaceBody>());
  const Anchors<SpaceBody> at = between<SpaceBody>(scene.bodies(), ground, {0.5, 0, 0}, wall, {0.5, 0, 0});
  const auto contact = scene.add(Contact<SpaceBody>{at, {1, 0, 0}});
  scene.add(Friction<SpaceBody>{at, tangents_of<SpaceBody>({1, 0, 0}), 0.5, contact});
  Simulation simulation{scene, {GaussSeidel{}}};
  simulation.step(h);
  EXPECT_THAT(simulation.work.system.lambda, testing::Each(0));
}

}  // namespace measure_test
