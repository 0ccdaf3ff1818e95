#include "lessons/exact/compound_pendulum.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "lessons/exact/certified_integration.hpp"

namespace compound_pendulum_test {

using namespace byhand;
using Eigen::Vector2d;
using testing::HasSubstr, testing::ThrowsMessage;

constexpr double pi = std::numbers::pi;
constexpr double length = 2, mass = 3, gravity = 9.81, weight = mass * gravity;

TEST(CompoundPendulum, ObeysEulersEquationAboutItsHinge) {
  const long double inertia = mass * length * length / 3.0L;
  const Rate rate = [&](const ExtendedState& x, ExtendedState& dxdt) {
    dxdt = {x[1], -mass * static_cast<long double>(gravity) * length / 2 * std::sin(x[0]) / inertia};
  };
  const CompoundPendulum rod(1.9, length, mass, gravity);
  for (const double time : {0.0, 0.4, 1.3, 5.0}) {
    const Certified truth = certified_integration(rate, {1.9, 0}, time);
    EXPECT_NEAR(rod.angle(time), truth.state[0], 2e-14 + truth.uncertainty);
    EXPECT_NEAR(rod.angular_velocity(time), truth.state[1], 2e-14 + truth.uncertainty);
  }
}

TEST(CompoundPendulum, SwingsAsAPointAtTwoThirds) {
  EXPECT_EQ(CompoundPendulum(0.8, 3, mass, gravity).period(), SimplePendulum(0.8, 2, gravity).period());
}

TEST(CompoundPendulum, ReleasedLevelItsHingeCarriesAQuarterOfTheWeight) {
  const Vector2d force = CompoundPendulum(pi / 2, length, mass, gravity).pivot_force(0);
  EXPECT_NEAR(force.x(), 0, 1e-14);
  EXPECT_NEAR(force.y(), weight / 4, 1e-14);
}

TEST(CompoundPendulum, FromLevelItsHingeCarriesTwoAndAHalfWeightsAtTheBottom) {
  const CompoundPendulum rod(pi / 2, length, mass, gravity);
  const Vector2d force = rod.pivot_force(rod.period() / 4);
  EXPECT_NEAR(force.x(), 0, 1e-12);
  EXPECT_NEAR(force.y(), 2.5 * weight, 1e-12);
}

TEST(CompoundPendulum, HangingStillItsHingeCarriesTheWeight) {
  const Vector2d force = CompoundPendulum(0, length, mass, gravity).pivot_force(1.7);
  EXPECT_EQ(force.x(), 0);
  EXPECT_EQ(force.y(), weight);
}

TEST(CompoundPendulum, HingeForceIsWhatTheCentresAccelerationNeeds) {
  const CompoundPendulum rod(2.2, length, mass, gravity);
  const double step = 1e-4;
  const auto centre = [&](double time) -> Vector2d {
    return length / 2 * Vector2d(std::sin(rod.angle(time)), -std::cos(rod.angle(time)));
  };
  for (double time = 0; time < 4; time += 0.31) {
    const Vector2d acceleration = (centre(time + step) - 2 * centre(time) + centre(time - step)) / (step * step);
    EXPECT_LE((mass * (acceleration + gravity * Vector2d::UnitY()) - rod.pivot_force(time)).norm(), 2e-5);
  }
}

TEST(CompoundPendulum, KeepsItsEnergy) {
  const CompoundPendulum rod(2.2, length, mass, gravity);
  for (double time = 0; time < 4; time += 0.31) {
    const double omega = rod.angular_velocity(time);
    const double energy =
        mass * length * length / 6 * omega * omega - weight * length / 2 * std::cos(rod.angle(time));
    EXPECT_NEAR(energy, rod.energy(), 1e-12);
  }
}

TEST(CompoundPendulum, HingeForceScalesWithMassAndNotWithLength) {
  const CompoundPendulum rod(1.2, length, mass, gravity), longer(1.2, 4 * length, 5 * mass, gravity);
  EXPECT_LE((longer.pivot_force(1.4) - 5 * rod.pivot_force(0.7)).norm(), 1e-12);
}

TEST(CompoundPendulum, RefusesARodThatIsNone) {
  EXPECT_THAT([] { CompoundPendulum(1, -1, 3, 9.81); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("length is -1")));
  EXPECT_THAT([] { CompoundPendulum(1, 2, 0, 9.81); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("mass is 0")));
  EXPECT_THROW(CompoundPendulum(pi, 2, 3, 9.81), std::invalid_argument);
  EXPECT_THROW(CompoundPendulum(1, 2, 3, NAN), std::invalid_argument);
  EXPECT_THROW(CompoundPendulum(1, 2, 3, 9.81).pivot_force(INFINITY), std::invalid_argument);
}

}  // namespace compound_pendulum_test
