#include <gtest/gtest.h>

#include <numbers>

#include "lessons/scenes/pendulum.hpp"
#include "solver/constraints/limit.hpp"
#include "solver/constraints/motor.hpp"
#include "solver/constraints/pin.hpp"
#include "tests/solver/law_motion.hpp"

// Limits, motors and servos of a hinged rod of 1 m and 2 kg, held level at first: gravity turns it down.
namespace joints_bounds_test {

using namespace byhand;
using M = PlaneBody;
constexpr double pi = std::numbers::pi, h = 1.0 / 240, weight = 2 * 9.81;
using Hinged = Simulation<M>;

/// The rod at an angle [rad] from straight down; its turn is counted from there.
Hinged level_rod(const RowSolver& solver = Direct{}, double start = pi / 2) {
  return {hinged_rod(start, 1, 2), {solver, Baumgarte{0.2}}};
}
Turn<M> turn_of(const Hinged& simulation) { return turn<M>(simulation.scene.bodies(), 0, 1); }
double turned(const Hinged& simulation) { return angle(simulation.scene.bodies().pose[1].rotation) - pi / 2; }

const RowSolver solvers[] = {Direct{}, GaussSeidel{.sweeps = 30}};

TEST(Limit, StopsATurnAndCarriesWhatRestsOnIt) {
  for (const RowSolver& solver : solvers) {
    Hinged simulation = level_rod(solver);
    const int limit = simulation.scene.add(at_least<M>(-0.5, turn_of(simulation)));
    run(simulation, 10, h, [&] {
      const double lambda = simulation.work.system.lambda[simulation.work.system.row_of[limit]];
      ASSERT_GE(lambda, 0);
      ASSERT_GT(turned(simulation), -0.5 - 1e-3);
    });
    EXPECT_NEAR(turned(simulation), -0.5, 1e-6);
    EXPECT_NEAR(force(simulation.work, limit), weight / 2 * std::cos(0.5), 1e-5);
  }
}

TEST(Limit, AnUpperOneIsALowerOneSeenFromTheOtherBody) {
  Hinged lower = level_rod(), upper = level_rod();
  lower.scene.add(at_least<M>(-0.5, turn_of(lower)));
  upper.scene.add(at_most<M>(0.5, turn<M>(upper.scene.bodies(), 1, 0)));
  for (int i = 0; i < 500; ++i) {
    lower.step(h);
    upper.step(h);
    ASSERT_EQ(turned(lower), turned(upper));
  }
}

TEST(Limit, DoesNothingBeforeItIsReached) {
  Hinged with = level_rod(), without = level_rod();
  with.scene.add(at_least<M>(-3, turn_of(with)));
  with.scene.add(at_most<M>(1, turn_of(with)));
  for (int i = 0; i < 100; ++i) {
    with.step(h);
    without.step(h);
    ASSERT_NEAR(turned(with), turned(without), 1e-12);
  }
}

// A pendulum in space under a gravity that is tilted: it comes to rest along gravity, or on the cone.
TEST(Limit, OfASwingHoldsABodyWithinACone) {
  constexpr double length = 0.7, mass = 3, g = 9.81, cone = 0.4;
  for (const double tilt : {0.1, 0.39, 0.41, 1.0, 3.0})
    for (const double azimuth : {0.0, 2.0}) {
      const Eigen::Vector3d sideways(std::cos(azimuth), 0, std::sin(azimuth));
      Scene<SpaceBody> scene;
      scene.gravity = g * (std::sin(tilt) * sideways - std::cos(tilt) * Eigen::Vector3d::UnitY());
      scene.add_body(Eigen::Vector3d(0, 0, 0), fixed<SpaceBody>());
      const int bob = scene.add_body(Eigen::Vector3d(0, -length, 0), ball<SpaceBody>(mass, 0.2));
      scene.set_damping(bob, 3, 3);
      scene.add(pin<SpaceBody>(scene.bodies(), 0, bob, {0, 0, 0}));
      const auto stop = scene.add(at_most<SpaceBody>(cone, swing<SpaceBody>(scene.bodies(), 0, bob, {0, -1, 0})));
      Simulation<SpaceBody> simulation{std::move(scene), {GaussSeidel{.sweeps = 50}, Baumgarte{}}};
      double widest = 0;
      run(simulation, 12, h, [&] {
        const Eigen::Vector3d& x = simulation.scene.bodies().pose[bob].position;
        widest = std::max(widest, std::atan2(std::hypot(x.x(), x.z()), -x.y()));
      });
      const double leans = std::min(tilt, cone);
      const Eigen::Vector3d expected =
          length * (std::sin(leans) * sideways - std::cos(leans) * Eigen::Vector3d::UnitY());
      EXPECT_LE((simulation.scene.bodies().pose[bob].position - expected).norm(), 1e-5) << tilt;
      // It arrives within a step of its speed, which is less than gt.
      EXPECT_LE(widest, cone + h * std::sqrt(2 * g / length)) << tilt;
      EXPECT_NEAR(simulation.reaction(stop).torque2.norm(), mass * g * length * std::sin(tilt - leans), 1e-4)
          << tilt;
    }
}

TEST(Motor, TurnsAtItsSpeedWithinItsStrength) {
  for (const RowSolver& solver : solvers) {
    Hinged simulation = level_rod(solver);
    const int motor_row = simulation.scene.add(motor<M>(turn_of(simulation), 2, 0.6 * weight));
    run(simulation, 3, h, [&] {
      const double lambda = simulation.work.system.lambda[simulation.work.system.row_of[motor_row]];
      ASSERT_LE(std::abs(lambda), 0.6 * weight * h);
    });
    EXPECT_NEAR(simulation.scene.bodies().velocity[1][2], 2, 1e-3);
  }
}

TEST(Motor, AtItsBoundItGivesExactlyItsStrength) {
  for (const RowSolver& solver : solvers) {
    Hinged simulation = level_rod(solver);
    const double strength = weight / 4;
    const int motor_row = simulation.scene.add(motor<M>(turn_of(simulation), 0, strength));
    for (int i = 0; i < 60; ++i) {
      simulation.step(h);
      ASSERT_EQ(simulation.work.system.lambda[simulation.work.system.row_of[motor_row]], strength * h);
    }
  }
}

// It holds wherever gravity's moment is within its strength: W/2 cosφ <= strength.
TEST(Motor, HoldsWhatItCanCarry) {
  for (const double share : {0.99, 1.01}) {
    Hinged simulation = level_rod();
    simulation.scene.add(motor<M>(turn_of(simulation), 0, share * weight / 2));
    run(simulation, 2, h);
    if (share > 1) {
      EXPECT_NEAR(turned(simulation), 0, 1e-10);
    } else {
      EXPECT_LT(turned(simulation), -1e-2);
    }
  }
}

// Sliding at its bound it is a brake of constant moment: the rod falls through x until gravity's work, W/2 sin x,
// is used up, W/4 x, which is past the lowest point; there W/2 |cos x| is less than the brake holds.
TEST(Motor, TooWeakToHoldItBrakesTheFallPastTheLowestPoint) {
  const double exact = 1.8954942670339809;  // sin x = x/2
  for (const double step : {1.0 / 240, 1.0 / 960}) {
    Hinged simulation = level_rod();
    simulation.scene.add(motor<M>(turn_of(simulation), 0, weight / 4));
    run(simulation, 5, step);
    EXPECT_NEAR(turned(simulation), -exact, 0.05 * step);
    EXPECT_NEAR(simulation.scene.bodies().velocity[1][2], 0, 1e-12);
  }
}

TEST(Servo, GoesToItsTargetButForItsSag) {
  Hinged simulation = level_rod();
  const double stiffness = 500;
  simulation.scene.add(servo<M>(turn_of(simulation), 0.7, {stiffness, 60}, 1e3));
  run(simulation, 20, h);
  const double q = turned(simulation);
  EXPECT_NEAR(stiffness * (q - 0.7), -weight / 2 * std::cos(q), 1e-6);
}

TEST(Servo, NeverGivesMoreThanItsStrength) {
  Hinged simulation = level_rod(GaussSeidel{});
  const int row = simulation.scene.add(servo<M>(turn_of(simulation), 0.7, {5000, 10}, weight));
  bool at_bound = false;
  run(simulation, 5, h, [&] {
    const double lambda = simulation.work.system.lambda[simulation.work.system.row_of[row]];
    ASSERT_LE(std::abs(lambda), weight * h);
    at_bound = at_bound || std::abs(lambda) == weight * h;
  });
  EXPECT_TRUE(at_bound);
}

TEST(BadInput, OfLimitsMotorsAndServosIsRefusedInOneSentence) {
  Hinged simulation = level_rod();
  auto& scene = simulation.scene;
  const Turn<M> q = turn_of(simulation);
  const auto refused = [&](const auto& joint, const std::string& start) {
    try {
      scene.add(joint);
      ADD_FAILURE() << "accepted: " << start;
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(std::string(error.what()).rfind(start, 0), 0U) << error.what();
    }
  };
  refused(at_least<M>(3.2, q), "place of the stop is 3.2, but it must be above -3.14 and below 3.14 [rad]");
  refused(motor<M>(q, std::nan(""), 1), "speed of the motor is nan");
  refused(motor<M>(q, 1, -1), "strength of the motor is -1");
  refused(servo<M>(q, 0, {0, 1}, 1), "stiffness is 0");
  refused(servo<M>(q, 0, {1, -1}, 1), "damping is -1");
  refused(servo<M>(q, 4, {1, 1}, 1), "target of the servo is 4");
  refused(servo<M>(q, 0, {1, 1}, -1), "strength of the servo is -1");
  EXPECT_THROW(Swing<SpaceBody>::require_place("place of the stop", 0), std::invalid_argument);
  Turn<M> bad = q;
  bad.body2 = 7;
  refused(motor<M>(bad, 1, 1), "body index is 7");
  bad = q;
  bad.rest = {2, 0};
  refused(motor<M>(bad, 1, 1), "squared length of the rotation is 4");
}

}  // namespace joints_bounds_test
