#include "lessons/methods/avbd.hpp"

#include <gmock/gmock.h>

#include "lessons/scenes/top.hpp"
#include "tests/solver/position_laws.hpp"

namespace avbd_test {

using namespace byhand;
constexpr double h = 1.0 / 60;

Avbd with_iterations(int iterations) {
  Avbd method;
  method.iterations = iterations;
  return method;
}

/// Stiffens ten times as fast as by default: what few bodies carry is right to a tenth of the error.
Avbd eager() {
  Avbd method;
  method.beta = 1000;
  return method;
}

// Both minimise the same function of the poses: converged, a step is implicit Euler's, and so is XPBD's with one
// substep.
TEST(Avbd, ErrsOnAPendulumAsPositionBasedDynamicsDoes) {
  const SwingErrors row = swing<NormalisedDistance>(with_iterations(30), h);
  expect_two_digits(row.period_error, -7.2e-2, "period");
  expect_two_digits(row.angle_error, 0.23, "angle after 1 s");
  expect_two_digits(row.energy_gain, -0.90, "energy");
  EXPECT_LT(row.stretch, 1e-10);
}

TEST(Avbd, ConvergesWithOrderOneInItsStep) {
  const SwingErrors coarse = swing<NormalisedDistance>(Avbd{}, h / 16),
                    fine = swing<NormalisedDistance>(Avbd{}, h / 32);
  EXPECT_NEAR(order(coarse.period_error, fine.period_error), 1, 0.05);
  EXPECT_NEAR(order(coarse.angle_error, fine.angle_error), 1, 0.05);
}

TEST(Avbd, SagsByItsCompliance) {
  for (const double stiffness : {30.0, 1e5}) expect_static_sag<PlaneParticle>(Avbd{}, h, stiffness);
  expect_static_sag<PlaneParticle>(with_iterations(1), h / 4, 1e3);
  in_models<PlaneBody, SpaceParticle, SpaceBody>([]<class M>(Random&) { expect_static_sag<M>(Avbd{}, h, 1e3); });
}

TEST(Avbd, CarriesAHangingChainAsFarAsItsRoundsConverge) {
  expect_tensions(Avbd{}, 0.02);
  expect_tensions(with_iterations(80), 1e-4);
}

// Without the second derivatives of C the light links in between come apart by metres: see the method.
TEST(Avbd, HoldsALongChainWithAHeavyEnd) {
  Simulation simulation{
      pinned_chain<PlaneBody>({.links = 50, .length = 0.2, .end_mass = 1000, .angle = std::numbers::pi / 2}),
      Avbd{}};
  double furthest = 0;
  run(simulation, 5, h, [&] { furthest = std::max(furthest, position_error(simulation).max); });
  EXPECT_LT(furthest, 0.1);
}

/// A box on a rod from one of its corners, and a bob that hangs from another.
template <class M>
Scene<M> box_and_bob_on_rods(double length) {
  Scene<M> scene;
  const auto add = [&](const Linear<M>& position, const InverseMass<M>& mass) {
    return scene.add_body(Linear<M>(length * position), mass);
  };
  const auto rod = [&](int body1, const Linear<M>& point1, int body2, const Linear<M>& point2) {
    scene.add(NormalisedDistance<M>{
        between<M>(scene.bodies(), body1, Linear<M>(length * point1), body2, Linear<M>(length * point2)),
        length * (point2 - point1).norm()});
  };
  const Linear<M> x = Linear<M>::Unit(0), y = Linear<M>::Unit(1), origin = Linear<M>::Zero();
  add(origin, fixed<M>());
  add(2 * x, box<M>(2, Linear<M>::Constant(length)));
  add(3 * x, ball<M>(1, length / 4));
  rod(0, origin, 1, Linear<M>(1.5 * x + 0.5 * y));
  rod(1, Linear<M>(2.5 * x - 0.5 * y), 2, Linear<M>(3 * x));
  return scene;
}
TEST(Avbd, DoesTheSameAtAnyLength) {
  const auto method_of = [](double length) {
    return Avbd{.beta = Avbd{}.beta / length, .bounce_threshold = 0.5 * length};  // what has a unit of length
  };
  expect_same_at_any_length(
      [](double a) { return rod_chain<PlaneParticle, NormalisedDistance>({.links = 3, .length = a, .angle = 1}); },
      method_of);
  expect_same_at_any_length(box_and_bob_on_rods<PlaneBody>, method_of);
  expect_same_at_any_length(box_and_bob_on_rods<SpaceBody>, method_of);
}

TEST(Avbd, KeepsMomentumAsFarAsItsRoundsConverge) {
  using M = PlaneParticle;
  const auto lost = [](int iterations) {
    Scene<M> scene;
    scene.gravity.setZero();
    for (const double x : {-1.0, 1.0}) {
      Velocity<M> V(0.3, x);
      scene.add_body(Linear<M>(x, 0), with_mass<M>(2 + x), V);
    }
    scene.add(NormalisedDistance<M>{{0, 1}, 2});
    const Linear<M> before = linear_momentum(scene.bodies());
    Simulation simulation{scene, with_iterations(iterations)};
    run(simulation, 1, h);
    return (linear_momentum(simulation.scene.bodies()) - before).norm();
  };
  EXPECT_GT(lost(2), 1e-6);
  EXPECT_LT(lost(200), 1e-9);
}

TEST(Avbd, LeavesAFreeBodyItsSpin) {
  const Eigen::Vector3d spin(7, -4, 11);
  Simulation plain{free_top({1, 2, 3}, spin), Avbd{.gyroscopic = Gyroscopic::none}};
  run(plain, 5, h);
  EXPECT_LT((plain.scene.bodies().velocity[0].tail<3>() - spin).norm(), 1e-10);
}

TEST(Avbd, ObeysTheAngleOfFriction) {
  expect_friction_angle<PlaneBody>(eager(), 1e-5);
  expect_friction_angle<SpaceBody>(eager(), 1e-4);
}
TEST(Avbd, LetsAStackStand) {
  expect_standing_stack<PlaneBody>(Avbd{}, 5, 2e-3, 0.02);
  expect_standing_stack<PlaneBody>(eager(), 5, 1e-3, 0.02);
  expect_standing_stack<SpaceBody>(Avbd{}, 3, 1e-3, 0.02);
}
TEST(Avbd, GainsNoEnergyFromThreeHundredBoxesBetweenWalls) {
  using M = PlaneBody;
  const Surface rough{.friction = 0.6};
  Random random;
  Scene<M> scene;
  scene.set_shape(scene.add_body({0, 0}, fixed<M>()), HalfSpace<M>{}, rough);
  for (const double side : {-1.0, 1.0})
    scene.set_shape(scene.add_body({4.25 * side, 20}, fixed<M>()), Box<M>{{1, 60}}, rough);
  for (int i = 0; i < 300; ++i) {
    const Linear<M> sides = Linear<M>::Constant(0.4) + random.vector<2>(0.15);
    const Pose<M> pose{{0.75 * (i % 10 - 4.5), 0.5 + 0.75 * (i / 10)}, plane_rotation(random.uniform(-1, 1))};
    scene.set_shape(scene.add_body(pose, box<M>(1, sides)), Box<M>{sides}, rough);
  }
  Simulation simulation{scene, Avbd{}};
  const double first = energy(scene);
  run(simulation, 3, h, [&] { ASSERT_LE(energy(simulation.scene), first) << simulation.time << " s"; });
}

TEST(Avbd, BouncesABallByItsRestitution) { expect_bounces(Avbd{}, h / 16); }
TEST(Avbd, BouncesBallsOffEachOther) { expect_balls_bounce_off_each_other(Avbd{}, h, 5e-3); }

TEST(Avbd, AllocatesInNoStepOnceAScenesRowsAreLaidOut) {
  expect_no_allocation(rod_chain<PlaneParticle, NormalisedDistance>({.links = 3, .angle = 1}), Avbd{});
  expect_no_allocation(stack(3), Avbd{});
}

TEST(Avbd, CountsEachRowAtEachOfItsMovingBodiesAndOnceForItsMultiplier) {
  Simulation simulation{rod_chain<PlaneParticle, NormalisedDistance>({.links = 7}), with_iterations(4)};
  simulation.step(h);
  EXPECT_EQ(simulation.work.row_solves, 4 * (13 + 7));
}

TEST(Avbd, LetsEachBodyFallWhateverItsIndex) {
  Scene<PlaneParticle> scene;
  for (const double x : {0.0, 1.0, 2.0}) scene.add_body({x, 0}, with_mass<PlaneParticle>(2));
  Simulation simulation{scene, Avbd{}};
  run(simulation, 0.5, h);
  for (const Pose<PlaneParticle>& pose : simulation.scene.bodies().pose)
    EXPECT_NEAR(pose.position.y(), -9.81 * h * h * 30 * 31 / 2, 1e-12);
}

TEST(Avbd, RefusesChoicesOutsideTheirRange) {
  const auto refuses = [](const Avbd& method, const char* sentence) {
    auto scene = pendulum<PlaneParticle, NormalisedDistance>(1, 1, 1);
    Avbd::Work<PlaneParticle> work;
    EXPECT_THAT([&] { advance(scene, method, h, work); },
                testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr(sentence)));
  };
  refuses({.iterations = 0}, "number of iterations is 0, but it must be at least 1");
  refuses({.alpha = 1.5}, "alpha is 1.5, but it must be between 0 and 1");
  refuses({.beta = -1}, "beta is -1, but it must be between 0 and");
  refuses({.memory = 2}, "memory is 2, but it must be between 0 and 1");
  refuses({.softest = 0}, "softest is 0, but it must be a positive finite number");
  refuses({.stiffest = -1}, "stiffest is -1, but it must be a positive finite number");
}

}  // namespace avbd_test
