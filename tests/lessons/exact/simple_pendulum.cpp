#include "lessons/exact/simple_pendulum.hpp"

#include <gmock/gmock.h>

#include <Eigen/Core>
#include <cmath>
#include <numbers>

#include "lessons/exact/certified_integration.hpp"

namespace simple_pendulum_test {

using namespace byhand;
using Eigen::Vector2d;
using testing::HasSubstr, testing::ThrowsMessage;

constexpr double pi = std::numbers::pi, degree = pi / 180;

TEST(SimplePendulum, HasTheAtlasPeriodsAndAngles) {
  EXPECT_NEAR(SimplePendulum(30 * degree, 1, 9.81).period(), 2.040989889519, 5.1e-13);
  const SimplePendulum level(90 * degree, 1, 9.81);
  EXPECT_NEAR(level.period(), 2.367841947576, 5.1e-13);
  EXPECT_NEAR(level.angle(1), -1.405027311525, 5.1e-13);
  EXPECT_NEAR(level.angle(10), 0.278680673570, 5.1e-13);
}

TEST(SimplePendulum, AgreesWithItsEquationOfMotionIntegrated) {
  const double length = 2.5, gravity = 3.7;
  const Rate rate = [&](const ExtendedState& x, ExtendedState& dxdt) {
    dxdt = {x[1], -static_cast<long double>(gravity) / length * std::sin(x[0])};
  };
  for (const double start : {0.0, 1e-6, -0.4, 90 * degree, -2.5, 3.1, 3.14}) {
    const SimplePendulum pendulum(start, length, gravity);
    const double lost_digits = 1 / (1 + std::cos(start));  // (π − θ0)²/2 near the top
    for (const double time : {0.0, 0.3, 2.0, 11.0}) {
      const Certified truth = certified_integration(rate, {start, 0}, time);
      const double tolerance = 1e-14 * (1 + lost_digits) + truth.uncertainty;
      EXPECT_NEAR(pendulum.angle(time), truth.state[0], tolerance) << start << " at " << time;
      EXPECT_NEAR(pendulum.angular_velocity(time), truth.state[1], tolerance) << start << " at " << time;
    }
  }
}

TEST(SimplePendulum, PeriodGrowsFromTheSmallAngleOneAsItsSeries) {
  const double length = 2, gravity = 9.81;
  for (const double start : {1e-5, 0.01, 0.1, 0.3}) {
    const double square = start * start;
    const double series = 1 + square / 16 + 11 * square * square / 3072;
    EXPECT_NEAR(SimplePendulum(start, length, gravity).period() / (2 * pi * std::sqrt(length / gravity)), series,
                1e-15 + 2 * 173.0 / 737280 * square * square * square);
  }
}

TEST(SimplePendulum, SwingsThereAndBackInItsPeriod) {
  const SimplePendulum pendulum(2.0, 1.7, 9.81);
  const double period = pendulum.period();
  EXPECT_EQ(pendulum.angle(0), 2.0);
  EXPECT_EQ(pendulum.angular_velocity(0), 0.0);
  EXPECT_NEAR(pendulum.angle(period / 4), 0, 1e-14);
  EXPECT_NEAR(pendulum.angle(period / 2), -2.0, 1e-14);
  EXPECT_NEAR(pendulum.angle(1000 * period + 0.3), pendulum.angle(0.3), 1e-11);
  EXPECT_NEAR(pendulum.angle(-0.3), pendulum.angle(0.3), 1e-15);
  EXPECT_NEAR(SimplePendulum(-2.0, 1.7, 9.81).angle(0.3), -pendulum.angle(0.3), 1e-15);
}

TEST(SimplePendulum, KeepsItsEnergy) {
  const double length = 2, mass = 3, gravity = 9.81;
  for (const double start : {0.2, 90 * degree, 3.0}) {
    const SimplePendulum pendulum(start, length, gravity);
    for (double time = 0; time < 10; time += 0.37) {
      const double speed = length * pendulum.angular_velocity(time);
      const double energy = mass * (speed * speed / 2 - gravity * length * std::cos(pendulum.angle(time)));
      EXPECT_NEAR(energy, pendulum.energy(mass), 1e-12 * mass * gravity * length);
    }
  }
}

TEST(SimplePendulum, IsFastestAtTheBottomToAllDigits) {
  for (const double start : {0.3, 1.0, pi / 2, 2.0, 3.1}) {
    const SimplePendulum pendulum(start, 2, 9.81);
    const double fastest = 2 * std::sin(start / 2) * std::sqrt(9.81 / 2);
    for (const double quarter : {0.25, 1.25, 2.25})
      EXPECT_NEAR(pendulum.angular_velocity(quarter * pendulum.period()), -fastest, 1e-14 * fastest) << start;
  }
}

TEST(SimplePendulum, TensionIsWhatTheBobsAccelerationNeeds) {
  const double length = 2, mass = 3, gravity = 9.81, step = 1e-4;
  const SimplePendulum pendulum(2.2, length, gravity);
  const auto position = [&](double time) -> Vector2d {
    return length * Vector2d(std::sin(pendulum.angle(time)), -std::cos(pendulum.angle(time)));
  };
  for (double time = 0; time < 4; time += 0.31) {
    const Vector2d at = position(time);
    const Vector2d acceleration = (position(time + step) - 2 * at + position(time - step)) / (step * step);
    const Vector2d pull = mass * (acceleration + gravity * Vector2d::UnitY());
    EXPECT_NEAR(pull.dot(-at) / length, pendulum.tension(time, mass), 2e-5);
  }
}

TEST(SimplePendulum, FromLevelPullsWithThreeWeightsAtTheBottomAndNoneAtTheStart) {
  const double mass = 3, gravity = 9.81;
  const SimplePendulum pendulum(pi / 2, 2, gravity);
  EXPECT_NEAR(pendulum.tension(0, mass), 0, 1e-13);
  EXPECT_NEAR(pendulum.tension(pendulum.period() / 4, mass), 3 * mass * gravity, 1e-12);
}

TEST(SimplePendulum, ScalesAsItsDimensionsSay) {
  const SimplePendulum small(1.1, 0.5, 9.81), tall(1.1, 2.0, 9.81), heavy(1.1, 0.5, 4 * 9.81);
  EXPECT_NEAR(tall.period(), 2 * small.period(), 1e-14);
  EXPECT_NEAR(tall.angle(1.4), small.angle(0.7), 1e-14);
  EXPECT_NEAR(heavy.period(), small.period() / 2, 1e-14);
  EXPECT_NEAR(heavy.angular_velocity(0.35), 2 * small.angular_velocity(0.7), 1e-13);
  EXPECT_NEAR(small.tension(0.7, 6), 6 * small.tension(0.7, 1), 1e-12);
  EXPECT_NEAR(tall.tension(1.4, 1), small.tension(0.7, 1), 1e-12);
}

TEST(SimplePendulum, RefusesWhatHasNoPeriod) {
  EXPECT_THAT([] { SimplePendulum(pi, 1, 9.81); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("3.141592653589793, but it must be between")));
  EXPECT_THROW(SimplePendulum(-pi, 1, 9.81), std::invalid_argument);
  EXPECT_THROW(SimplePendulum(NAN, 1, 9.81), std::invalid_argument);
  EXPECT_THAT([] { SimplePendulum(1, -1, 9.81); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("length is -1")));
  EXPECT_THROW(SimplePendulum(1, INFINITY, 9.81), std::invalid_argument);
  EXPECT_THAT([] { SimplePendulum(1, 1, 0); }, ThrowsMessage<std::invalid_argument>(HasSubstr("gravity is 0")));
  const SimplePendulum pendulum(1, 1, 9.81);
  EXPECT_THROW(pendulum.angle(NAN), std::invalid_argument);
  EXPECT_THROW(pendulum.angular_velocity(INFINITY), std::invalid_argument);
  EXPECT_THROW(pendulum.tension(1, 0), std::invalid_argument);
  EXPECT_THROW(pendulum.energy(-2), std::invalid_argument);
}

}  // namespace simple_pendulum_test
