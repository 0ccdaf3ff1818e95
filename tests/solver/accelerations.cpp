#include "lessons/methods/accelerations.hpp"

#include "lessons/exact/double_pendulum.hpp"
#include "lessons/methods/rattle.hpp"
#include "lessons/scenes/chain.hpp"
#include "lessons/scenes/circle.hpp"
#include "lessons/scenes/top.hpp"
#include "solver/constraints/contact.hpp"
#include "solver/constraints/spring.hpp"
#include "tests/solver/equalities.hpp"
#include "tests/solver/swing.hpp"

namespace accelerations_test {

using namespace byhand;
constexpr double pi = std::numbers::pi, g = 9.81, h = 1.0 / 60;
const Accelerations explicit_euler{Scheme::explicit_euler}, rk4{Scheme::rk4}, midpoint{Scheme::implicit_midpoint};

// Its stretch in metres: of C = ½(d² - L²) it is 1.2 m².
TEST(LawA1, ExplicitEulerOnAccelerationsErrsAsTheAtlasSays) {
  expect_row(swing<Distance>(explicit_euler, h), {0.13, 0.07, 0.84, 1.33});
}
// Over the first whole swing the period is -2.0e-6 off; the atlas has -2.3e-6, and in later swings it is more.
TEST(LawA1, RungeAndKuttasRuleErrsAsTheAtlasSays) {
  expect_row(swing<Distance>(rk4, h), {-2.0e-6, -3.4e-6, 2.8e-4, 3.7e-4});
}
TEST(LawA1, OfTheNormalisedRodRungeAndKuttasRuleErrsLess) {
  expect_two_digits(swing<NormalisedDistance>(rk4, h).angle_error, -2.5e-6, "angle after 1 s");
}
// The atlas gives the energy's one digit, 9e-4.
TEST(LawA1, TheImplicitMidpointRuleErrsAsTheAtlasSays) {
  expect_row(swing<Distance>(midpoint, h), {-7.8e-5, -1.6e-4, 6.8e-4, 9.5e-4});
}

TEST(LawA4, ADoublePendulumComesToTheCertifiedAnswer) {
  const DoublePendulum exact({{pi / 2, pi / 2}, {0, 0}}, {1, 1}, {1, 1}, g);
  Simulation<PlaneParticle, Accelerations> simulation{rod_chain<PlaneParticle>({.links = 2, .angle = pi / 2}),
                                                      rk4};
  for (const double time : {1.0, 2.0}) {
    run(simulation, 1, 1.0 / 2000);
    const DoublePendulum::State state = exact.at(time);
    for (const int i : {0, 1})
      EXPECT_NEAR(rod_angle(simulation.scene, i, i + 1), state.angles[i], 1e-9) << "angle " << i << " at " << time;
  }
}

/// The power of time with which the rod's error grows from the tenth second to the fortieth.
template <class M>
double growth(const Scene<M>& scene) {
  Simulation<M, Accelerations> simulation{scene, rk4};
  double largest = 0;
  const auto look = [&] { largest = std::max(largest, position_error(simulation).max); };
  run(simulation, 10, h, look);
  const double early = largest;
  run(simulation, 30, h, look);
  return std::log(largest / early) / std::log(4.0);
}

TEST(LawB3, TheDriftOfRungeAndKuttasRuleGrowsAsTheSquareOfTime) {
  EXPECT_NEAR(growth(pendulum<PlaneParticle>(2, 2, 3)), 2, 0.02);
}
// There what it errs by along the way turns x and v alike, and leaves JV alone.
TEST(LawB3, ExceptOnACircleWhereItGrowsAsTime) {
  EXPECT_NEAR(growth(particle_on_a_circle<PlaneParticle, Distance>(2, 3, 3)), 1, 0.01);
}

template <class M>
double midpoint_drift(const Scene<M>& scene, double time) {
  Simulation<M, Accelerations> simulation{scene, midpoint};
  double largest = 0;
  run(simulation, time, h, [&] { largest = std::max(largest, position_error(simulation).max); });
  return largest;
}
TEST(LawB3, TheDriftOfTheImplicitMidpointRuleStaysBoundedForAParticle) {
  const auto scene = pendulum<PlaneParticle>(2, 2, 3);
  EXPECT_NEAR(midpoint_drift(scene, 400) / midpoint_drift(scene, 10), 1, 0.02);
}
TEST(LawB3, ForABodyThatTurnsItGrowsAsTheSquareOfTime) {
  const auto scene = hinged_rod<PlaneBody>(1.5, 1, 1);
  EXPECT_NEAR(std::log(midpoint_drift(scene, 1200) / midpoint_drift(scene, 300)) / std::log(4), 2, 0.1);
}

TEST(Accelerations, OfAParticleOnACircleTheForceIsExactFromTheFirstStep) {
  for (const Accelerations& method : {explicit_euler, rk4}) {
    Simulation<PlaneParticle, Accelerations> simulation{particle_on_a_circle<PlaneParticle>(2, 5, 3), method};
    simulation.step(1e-3);
    EXPECT_NEAR(force(simulation.work, 0), -3 * 5.0 * 5.0 / 2, 1e-4);
  }
}

TEST(LawA2, ReleasedLevelTheHingeCarriesAQuarterOfTheWeightAtOnceByAccelerations) {
  Simulation<PlaneBody, Accelerations> simulation{hinged_rod<PlaneBody>(pi / 2, 2, 3), explicit_euler};
  simulation.step(h);
  EXPECT_NEAR(force(simulation.work, 0, 1) / (3 * g), 0.25, 1e-13);
}

TEST(Accelerations, MomentumOfWhatNothingHoldsStays) {
  for (const Accelerations& method : {explicit_euler, rk4, midpoint}) {
    auto simulation = thrown_pair(method);
    const Eigen::Vector2d momentum = linear_momentum(simulation.scene.bodies());
    run(simulation, 5, h);
    EXPECT_LT((linear_momentum(simulation.scene.bodies()) - momentum).norm(), 1e-13);
  }
}

// Angular momentum is of second degree in positions and velocities together: midpoint keeps it, RK4 only to its
// order.
TEST(Accelerations, AngularMomentumStaysByTheMidpointRuleAlone) {
  const auto change = [](const Accelerations& method) {
    auto simulation = thrown_pair(method);
    const double before = angular_momentum(simulation.scene.bodies())[0];
    run(simulation, 5, h);
    return std::abs(angular_momentum(simulation.scene.bodies())[0] / before - 1);
  };
  EXPECT_LT(change(midpoint), 1e-12);
  EXPECT_GT(change(rk4), 1e-10);
  EXPECT_GT(change(explicit_euler), 1e-3);
}

TEST(Accelerations, TheMidpointRuleRunsBackwardsAsItRanForwards) {
  expect_reversible(rod_chain<PlaneParticle>({.links = 3, .angle = 1.5}), midpoint);
  expect_reversible(leaning_top(), midpoint);
}

TEST(Accelerations, ExplicitRulesDoNotRunBackwards) {
  EXPECT_GT(way_back(rod_chain<PlaneParticle>({.links = 3, .angle = 1.5}), explicit_euler), 1e-2);
}

TEST(Accelerations, DoTheSameAtAnyLength) {
  for (const Accelerations& method : {explicit_euler, rk4, midpoint})
    expect_same_at_any_length_of_rods_and_pins(method);
}

TEST(Accelerations, SubstepsAreStepsOfTheirOwn) {
  for (Accelerations method : {explicit_euler, rk4, midpoint}) {
    Simulation<SpaceBody, Accelerations> whole{leaning_top(), method}, cut = whole;
    cut.method.substeps = 4;
    run(whole, 1, 1.0 / 256);
    run(cut, 1, 1.0 / 64);
    EXPECT_EQ(whole.scene.bodies().velocity, cut.scene.bodies().velocity);
    EXPECT_EQ(whole.work.system.lambda, cut.work.system.lambda);
    EXPECT_EQ(whole.work.row_solves, cut.work.row_solves);
  }
}

TEST(Accelerations, RungeAndKuttasRuleCostsFourDirectSolves) {
  const auto cost = [](const Accelerations& method) {
    Simulation<PlaneParticle, Accelerations> simulation{rod_chain<PlaneParticle>({.links = 20, .angle = 1}),
                                                        method};
    simulation.step(h);
    return simulation.work.row_solves;
  };
  EXPECT_EQ(cost(rk4), 4 * cost(explicit_euler));
  EXPECT_GT(cost(midpoint), 4 * cost(explicit_euler));
}

TEST(Accelerations, RefusesWhatItCannotRun) {
  for (const auto& method : {explicit_euler, midpoint}) expect_refusals(method);
  expect_invalid(Accelerations{Scheme::rk4, 0}, "number of substeps is 0");
  expect_invalid(Accelerations{Scheme::rk4, 1, -1}, "regularisation is -1");
}

TEST(Accelerations, RefusesRowsThatRepeatAndLeavesTheSceneAlone) {
  for (const Accelerations& method : {explicit_euler, rk4, midpoint}) expect_singular(method);
}

TEST(Accelerations, RefusesAnImplicitStepThatIsTooLongAndLeavesTheSceneAlone) {
  expect_no_convergence(pendulum<PlaneParticle>(2, 2, 3), midpoint, 10);
}

TEST(Equalities, AreSolvedOnceForEachSlopeAndAllRowsEachTime) {
  const auto expect_solves = [](const auto& method, int solves) {
    Simulation simulation{rod_chain<PlaneParticle>({.links = 7, .angle = 1}), method};
    run(simulation, 5 * h, h);
    EXPECT_EQ(simulation.work.executed.solves, 5 * solves);
    EXPECT_EQ(simulation.work.executed.prepared_rows, 7 * 5 * solves);
  };
  expect_solves(explicit_euler, 1);
  expect_solves(rk4, 4);
  expect_solves(Accelerations{.scheme = Scheme::rk4, .substeps = 3}, 12);
  expect_solves(Rattle{.substeps = 3}, 4);  // one at the start
}

}  // namespace accelerations_test
