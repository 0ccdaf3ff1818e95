#include "lessons/methods/rattle.hpp"

#include "lessons/scenes/chain.hpp"
#include "lessons/scenes/circle.hpp"
#include "tests/solver/equalities.hpp"
#include "tests/solver/swing.hpp"

namespace rattle_test {

using namespace byhand;
constexpr double pi = std::numbers::pi, h = 1.0 / 60;

// The atlas gives one digit of the angle, -8e-4; its energy's 1e-3 is the largest of the ten seconds.
TEST(LawA1, RattleErrsAsTheAtlasSays) {
  const SwingErrors measured = swing<Distance>(Rattle{}, h);
  expect_two_digits(measured.period_error, -3.9e-4, "period");
  expect_two_digits(measured.angle_error, -8.1e-4, "angle after 1 s");
  expect_two_digits(measured.energy_gain, -9.5e-4, "energy");
  EXPECT_LT(measured.stretch, 1e-15);
}

/// The largest |C|, |JV| and change of energy [J] of a run.
struct Worst {
  double C = 0, rate = 0, energy = 0;
};
template <class M>
Worst worst(Simulation<M, Rattle> simulation, double time, double step) {
  Worst worst;
  const double start = energy(simulation.scene);
  run(simulation, time, step, [&] {
    worst.C = std::max(worst.C, position_error(simulation).max);
    worst.rate = std::max(worst.rate, residual(simulation.work.system, simulation.scene.bodies().velocity));
    worst.energy = std::max(worst.energy, std::abs(energy(simulation.scene) - start));
  });
  return worst;
}

TEST(Rattle, KeepsPositionsAndRatesToRoundingAndEnergyBoundedOverManySwings) {
  const Simulation<PlaneParticle, Rattle> start{pendulum<PlaneParticle>(2, 1, 1), {}};
  const Worst some = worst(start, 10, h), many = worst(start, 1000, h);
  EXPECT_LT(many.C, 1e-15);
  EXPECT_LT(many.rate, 1e-14);
  EXPECT_LT(many.energy, 1.1 * some.energy);
}

TEST(Rattle, KeepsAChainAndATop) {
  const Worst chain =
      worst<PlaneParticle>({rod_chain<PlaneParticle>({.links = 50, .end_mass = 100, .angle = pi / 2}), {4}}, 5, h);
  EXPECT_LT(chain.C, 1e-13);
  EXPECT_LT(chain.rate, 1e-10);
  EXPECT_LT(chain.energy, 1e-5 * 9.81 * (49 * 25 + 100 * 50));  // of what it has hung up
  const Simulation<SpaceBody, Rattle> start{leaning_top(), {}};
  const Worst some = worst(start, 5, 1.0 / 240), many = worst(start, 100, 1.0 / 240);
  EXPECT_LT(many.C, 1e-14);
  EXPECT_LT(many.rate, 1e-12);
  EXPECT_LT(many.energy, 1.2 * some.energy);
}

TEST(Rattle, MomentumOfWhatNothingHoldsStays) {
  auto simulation = thrown_pair(Rattle{});
  const Eigen::Vector2d momentum = linear_momentum(simulation.scene.bodies());
  const double spin = angular_momentum(simulation.scene.bodies())[0];
  run(simulation, 100, h);
  EXPECT_LT((linear_momentum(simulation.scene.bodies()) - momentum).norm(), 1e-12);
  EXPECT_NEAR(angular_momentum(simulation.scene.bodies())[0] / spin, 1, 1e-12);
}

TEST(Rattle, RunsBackwardsAsItRanForwards) {
  expect_reversible(rod_chain<PlaneParticle>({.links = 3, .angle = 1.5}), Rattle{});
  expect_reversible(leaning_top(), Rattle{});
}

// λ/h is the mean force of the substep.
TEST(Rattle, TheForceOfAParticleOnACircleIsRightToSecondOrder) {
  const auto error = [](double step) {
    Simulation<PlaneParticle, Rattle> simulation{particle_on_a_circle<PlaneParticle>(2, 5, 3), {}};
    run(simulation, 1, step);
    return force(simulation.work, 0) + 3 * 5.0 * 5.0 / 2;
  };
  EXPECT_LT(std::abs(error(1.0 / 200)), 1e-2);
  EXPECT_NEAR(order(error(1.0 / 200), error(1.0 / 400)), 2, 0.05);
}

TEST(Rattle, PutsASceneOntoItsConstraintsInOneStep) {
  const auto puts = [](auto scene, double off, double step) {
    scene.state().pose[1].position *= 1 + off;
    Simulation<PlaneParticle, Rattle> simulation{scene, {}};
    simulation.step(step);
    EXPECT_LT(position_error(simulation).max, 1e-15) << off;
  };
  puts(pendulum<PlaneParticle>(1, 2, 3), 0.05, h);
  // Also where it is off by just what a speed of 1 m/s makes of a step.
  auto still = pendulum<PlaneParticle, NormalisedDistance>(0, 1, 3);
  still.gravity.setZero();
  for (const double speed : {-1.0, 1.0}) puts(still, speed / 64, 1.0 / 64);
}

TEST(Rattle, GivesNoImpulseToARodBetweenFixedBodies) {
  auto scene = pendulum<PlaneParticle>(1, 2, 3);
  const int post = scene.add_body(Eigen::Vector2d(0, 1), fixed<PlaneParticle>());
  const auto idle = scene.add(Distance<PlaneParticle>{{0, post}, 1});
  Simulation<PlaneParticle, Rattle> simulation{scene, {}};
  run(simulation, 1, h);
  EXPECT_EQ(simulation.reaction(idle).force.norm(), 0);
}

TEST(Rattle, SubstepsAreStepsOfTheirOwnAndShareAFactor) {
  Simulation<SpaceBody, Rattle> whole{leaning_top(), {}}, cut = whole;
  cut.method.substeps = 4;
  run(whole, 1, 1.0 / 256);
  run(cut, 1, 1.0 / 64);
  EXPECT_EQ(whole.scene.bodies().velocity, cut.scene.bodies().velocity);
  EXPECT_EQ(whole.work.system.lambda, cut.work.system.lambda);
  EXPECT_LT(cut.work.row_solves, whole.work.row_solves);
}

TEST(Rattle, DoesTheSameAtAnyLength) { expect_same_at_any_length_of_rods_and_pins(Rattle{}); }

// A body at the origin that is held there has no size to compare an error with.
TEST(Rattle, HoldsAFlywheelByItsCentre) {
  Scene<PlaneBody> scene;
  scene.add_body(Eigen::Vector2d(0, 0), fixed<PlaneBody>());
  scene.add_body(Eigen::Vector2d(0, 0), ball<PlaneBody>(1, 0.3), {0, 0, 7});
  scene.add(Pin<PlaneBody>{{0, 1}});
  Simulation simulation{scene, Rattle{}};
  run(simulation, 1, h);
  EXPECT_LT(simulation.scene.bodies().pose[1].position.norm(), 1e-15);
  EXPECT_EQ(simulation.scene.bodies().velocity[1][2], 7);
}

TEST(Rattle, RefusesWhatItCannotRun) {
  expect_refusals(Rattle{});
  expect_invalid(Rattle{0}, "number of substeps is 0");
  expect_invalid(Rattle{1, -1}, "regularisation is -1");
  expect_singular(Rattle{});
}

// In one step it would leave the circle's tangent by more than any pull along the old rod brings back.
TEST(Rattle, RefusesAStepThatIsTooLongAndLeavesTheSceneAlone) {
  expect_no_convergence(particle_on_a_circle<PlaneParticle, Distance>(2, 5, 3), Rattle{}, 1);
}

}  // namespace rattle_test
