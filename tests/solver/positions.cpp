#include "lessons/methods/positions.hpp"

#include "lessons/methods/xpbd.hpp"
#include "solver/constraints/motor.hpp"
#include "solver/constraints/pin.hpp"
#include "solver/constraints/rope.hpp"
#include "tests/solver/law_motion.hpp"
#include "tests/solver/random.hpp"

// Rows without a C, and one-sided ones, solved on positions.
namespace positions_test {

using namespace byhand;
constexpr double h = 1.0 / 60;
using Wheel = Scene<PlaneBody>;

/// A disc with a moment of inertia of 0.5 kg m², on an axle.
Wheel wheel() {
  Wheel scene;
  scene.add_body(Linear<PlaneBody>(0, 0), fixed<PlaneBody>());
  scene.add_body(Linear<PlaneBody>(0, 0), ball<PlaneBody>(1, 1));
  scene.add(pin<PlaneBody>(scene.bodies(), 0, 1, Linear<PlaneBody>(0, 0)));
  return scene;
}

TEST(PositionRows, AMotorGainsSpeedByItsStrengthUntilItHasItsSpeedOverAnyNumberOfTurns) {
  constexpr double speed = 40, strength = 8, moment = 0.5;
  for (const double sign : {1.0, -1.0}) {
    auto scene = wheel();
    scene.add(motor<PlaneBody>(turn<PlaneBody>(scene.bodies(), 0, 1), sign * speed, strength));
    Simulation simulation{scene, Xpbd{2, 1}};
    run(simulation, 5, h, [&] {
      const double expected = std::min(speed, strength / moment * simulation.time);
      ASSERT_NEAR(sign * simulation.scene.bodies().velocity[1][2], expected, 1e-9) << simulation.time;
    });
  }
}

// Implicit Euler: ω₁ = ω₀ - h/I (k φ₁ + c ω₁), φ₁ = φ₀ + h ω₁, but for what its strength cannot give.
TEST(PositionRows, AServoObeysHookesLawAtTheEndOfTheStepWithinItsStrength) {
  constexpr double stiffness = 30, damping = 2, target = 1, strength = 20, moment = 0.5;
  auto scene = wheel();
  scene.add(servo<PlaneBody>(turn<PlaneBody>(scene.bodies(), 0, 1), target, {stiffness, damping}, strength));
  Simulation simulation{scene, Xpbd{1, 1}};
  double angle = 0, rate = 0;
  run(simulation, 3, h, [&] {
    const double soft =
        (rate - h / moment * stiffness * (angle - target)) / (1 + h / moment * (damping + h * stiffness));
    rate = std::clamp(soft, rate - h * strength / moment, rate + h * strength / moment);
    angle += h * rate;
    ASSERT_NEAR(simulation.scene.bodies().velocity[1][2], rate, 1e-11);
    const double torque = simulation.work.system.lambda[2] / h;
    ASSERT_LE(std::abs(torque), strength * (1 + 1e-12));
  });
  EXPECT_NEAR(angle, target, 1e-3);
}

TEST_IN_ALL_MODELS(PositionRows, ARopePullsOnlyWhereItIsTaut) {
  Scene<M> scene;
  scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>());
  scene.add_body(Linear<M>(-0.5 * Linear<M>::Unit(1)), random.mass<M>());
  scene.add(Rope<M>{{0, 1}, 1});
  Simulation simulation{scene, Xpbd{1, 1}};
  for (int n = 1; n <= 60; ++n) {
    simulation.step(h);
    const double fallen = 0.5 + 9.81 * h * h * n * (n + 1) / 2;
    ASSERT_NEAR(-simulation.scene.bodies().pose[1].position.y(), std::min(fallen, 1.0), 1e-12);
    if (fallen < 1) {
      ASSERT_EQ(simulation.work.system.lambda[0], 0);
    }
  }
  const double weight = 9.81 / simulation.scene.bodies().inverse_mass[1].linear;
  EXPECT_NEAR(simulation.work.system.lambda[0] / h, weight, 1e-9);
}

TEST_IN_ALL_MODELS(PositionRows, VelocityBetweenPosesIsWhatMovesOneToTheOther, 20) {
  const Pose<M> before = random.pose<M>();
  const Velocity<M> V = random.velocity<M>();
  EXPECT_LT((velocity_between<M>(before, moved<M, double>(before, V, h), h) - V).norm(), 1e-12);
  EXPECT_LT(velocity_between<M>(before, before, h).norm(), 1e-13);
}

// |Λ| <= radius, and the slip that is left opposes it: A Λ - b = -s Λ with s >= 0, s = 0 inside.
TEST(PositionRows, FrictionWithinItsDiscOpposesTheSlipHoweverTheMassesAreSpread) {
  Random random;
  for (int draw = 0; draw < 200; ++draw) {
    const Eigen::Matrix2d root = Eigen::Map<const Eigen::Matrix2d>(random.vector<4>(2).data());
    const Eigen::Matrix2d A = root * root.transpose() + 0.01 * Eigen::Matrix2d::Identity();
    const Eigen::Vector2d b = random.vector<2>(3);
    const double radius = random.uniform(0.01, 2);
    const Eigen::Vector2d x = within_disc<2>(A, b, radius), slip = A * x - b;
    ASSERT_LE(x.norm(), radius * (1 + 1e-12));
    if (x.norm() < radius * (1 - 1e-9)) {
      ASSERT_LT(slip.norm(), 1e-10);
    } else {
      ASSERT_LT((slip + slip.norm() / x.norm() * x).norm(), 1e-7 * slip.norm() + 1e-10);
    }
  }
  EXPECT_TRUE((within_disc<2>(Eigen::Matrix2d::Identity(), {1, 1}, 0).isZero(0)));
}

}  // namespace positions_test
