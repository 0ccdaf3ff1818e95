#include "lessons/exact/spherical_pendulum.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "lessons/exact/certified_integration.hpp"
#include "lessons/exact/conical_pendulum.hpp"
#include "lessons/exact/simple_pendulum.hpp"

namespace spherical_pendulum_test {

using namespace byhand;
using Eigen::Vector3d;
using State = SphericalPendulum::State;
using testing::HasSubstr, testing::ThrowsMessage;

constexpr double pi = std::numbers::pi, length = 2, mass = 3, gravity = 9.81;

TEST(SphericalPendulum, TouchesItsOtherConeAfterHalfANutation) {
  for (const auto& [angle, rate] : {std::pair{1.0, 2.0}, {0.5, -4.0}, {2.5, 0.3}, {1.6, 10.0}}) {
    const SphericalPendulum pendulum(angle, rate, length, gravity);
    const double period = pendulum.nutation_period();
    const State half = pendulum.at(period / 2), whole = pendulum.at(period), fifth = pendulum.at(5 * period);
    EXPECT_NEAR(half.angle, pendulum.other_angle(), 1e-13);
    EXPECT_NEAR(half.angle_rate, 0, 1e-12);
    EXPECT_NEAR(whole.angle, angle, 1e-13);
    EXPECT_NEAR(whole.azimuth, 2 * half.azimuth, 1e-12);
    EXPECT_NEAR(fifth.azimuth, 5 * whole.azimuth, 1e-11);
  }
}

// The same motion without an angle: a point in space, the rod's pull found from d²(½|x|²)/dt² = 0.
TEST(SphericalPendulum, AgreesWithAPointOnARodInCartesianCoordinates) {
  using Vector = Eigen::Matrix<long double, 3, 1>;
  const Rate rate = [](const ExtendedState& s, ExtendedState& dsdt) {
    const Vector x(s[0], s[1], s[2]), v(s[3], s[4], s[5]), down(0, 0, -static_cast<long double>(gravity));
    const Vector a = down - x * ((v.squaredNorm() + x.dot(down)) / x.squaredNorm());
    dsdt = {v.x(), v.y(), v.z(), a.x(), a.y(), a.z()};
  };
  const double angle = 1.0, azimuth_rate = 2.0;
  const SphericalPendulum pendulum(angle, azimuth_rate, length, gravity);
  for (const double time : {0.4, 1.7, 6.0}) {
    const State end = pendulum.at(time);
    const Certified truth = certified_integration(
        rate,
        {length * std::sin(angle), 0, -length * std::cos(angle), 0, length * std::sin(angle) * azimuth_rate, 0},
        time);
    const Vector3d x = length * Vector3d(std::sin(end.angle) * std::cos(end.azimuth),
                                         std::sin(end.angle) * std::sin(end.azimuth), -std::cos(end.angle));
    EXPECT_LE((x - Vector3d(truth.state[0], truth.state[1], truth.state[2])).norm(), 1e-13) << time;
  }
}

TEST(SphericalPendulum, KeepsEnergyAndAngularMomentum) {
  const SphericalPendulum pendulum(1.9, 1.3, length, gravity);
  for (double time = 0; time < 5; time += 0.41) {
    const State at = pendulum.at(time);
    const double radius = length * std::sin(at.angle);
    const double speed_squared = std::pow(length * at.angle_rate, 2) + std::pow(radius * at.azimuth_rate, 2);
    EXPECT_NEAR(mass * (speed_squared / 2 - gravity * length * std::cos(at.angle)), pendulum.energy(mass), 1e-12);
    EXPECT_NEAR(mass * radius * radius * at.azimuth_rate, pendulum.angular_momentum(mass), 1e-12);
  }
}

// With E and L_z for L = 1 as in the atlas: u̇² = 2(E + g·u)(1 − u²) − L_z².
TEST(SphericalPendulum, ItsPathHasTheAngleAtEachTime) {
  const SphericalPendulum pendulum(1.9, 1.3, length, gravity);
  const auto angles = pendulum.angles(4, 60);
  ASSERT_EQ(angles.size(), 61U);
  for (const int i : {0, 1, 23, 60}) EXPECT_NEAR(angles[i], pendulum.at(4.0 * i / 60).angle, 1e-12) << i;
}

TEST(SphericalPendulum, ObeysTheEquationOfItsHeight) {
  const SphericalPendulum pendulum(1.9, 1.3, 1, gravity);
  const double energy = pendulum.energy(1), momentum = pendulum.angular_momentum(1);
  for (double time = 0; time < 5; time += 0.41) {
    const State at = pendulum.at(time);
    const double u = std::cos(at.angle), u_rate = -std::sin(at.angle) * at.angle_rate;
    EXPECT_NEAR(u_rate * u_rate, 2 * (energy + gravity * u) * (1 - u * u) - momentum * momentum, 1e-12);
  }
}

TEST(SphericalPendulum, StartedAtTheConicalRateStaysOnItsConeAndNutatesAboutIt) {
  const double angle = 0.8;
  const double omega = ConicalPendulum(angle, length, gravity).angular_velocity();
  const SphericalPendulum cone(angle, omega, length, gravity);
  EXPECT_NEAR(cone.other_angle(), angle, 1e-14);
  EXPECT_NEAR(cone.at(3).angle, angle, 1e-13);
  EXPECT_NEAR(cone.at(3).azimuth, 3 * omega, 1e-13);
  // Small nutations about a cone have the rate ω·√(1 + 3cos²θ).
  EXPECT_NEAR(cone.nutation_period(), 2 * pi / (omega * std::sqrt(1 + 3 * std::pow(std::cos(angle), 2))), 1e-14);
}

TEST(SphericalPendulum, HardlyTurningNutatesTwiceInASimplePendulumsPeriod) {
  EXPECT_NEAR(SphericalPendulum(1.2, 1e-6, length, gravity).nutation_period(),
              SimplePendulum(1.2, length, gravity).period() / 2, 1e-9);
}

TEST(SphericalPendulum, ScalesAsItsDimensionsSay) {
  const SphericalPendulum shorter(1.2, 2, 0.5, gravity), longer(1.2, 1, 2, gravity);
  EXPECT_NEAR(longer.nutation_period(), 2 * shorter.nutation_period(), 1e-14);
  EXPECT_NEAR(longer.at(1.4).azimuth, shorter.at(0.7).azimuth, 1e-13);
}

TEST(SphericalPendulum, RefusesBadNumbers) {
  EXPECT_THAT([] { SphericalPendulum(0, 1, length, gravity); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("is 0, but it must be above 0")));
  EXPECT_THAT(
      [] { SphericalPendulum(1, 0, length, gravity); },
      ThrowsMessage<std::invalid_argument>(HasSubstr("is 0, but it must be a finite number other than 0")));
  EXPECT_THROW(SphericalPendulum(pi, 1, length, gravity), std::invalid_argument);
  EXPECT_THROW(SphericalPendulum(1, NAN, length, gravity), std::invalid_argument);
  EXPECT_THROW(SphericalPendulum(1, 1, 0, gravity), std::invalid_argument);
  EXPECT_THROW(SphericalPendulum(1, 1, length, INFINITY), std::invalid_argument);
  EXPECT_THROW(SphericalPendulum(1, 1, length, gravity).at(-1), std::invalid_argument);
  EXPECT_THROW(SphericalPendulum(1, 1, length, gravity).energy(0), std::invalid_argument);
}

}  // namespace spherical_pendulum_test
