#include "lessons/exact/double_pendulum.hpp"

#include <gmock/gmock.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "lessons/exact/certified_integration.hpp"
#include "lessons/exact/simple_pendulum.hpp"

namespace double_pendulum_test {

using namespace byhand;
using Eigen::Vector2d;
using State = DoublePendulum::State;
using testing::HasSubstr, testing::ThrowsMessage;

constexpr double pi = std::numbers::pi, gravity = 9.81;
const Vector2d ones(1, 1), still(0, 0), lengths(2, 0.7), masses(3, 0.5);

TEST(DoublePendulum, HasTheAtlasAngles) {
  const DoublePendulum pendulum({{pi / 2, pi / 2}, still}, ones, ones, gravity);
  const Vector2d after_one = pendulum.at(1).angles, after_two = pendulum.at(2).angles;
  EXPECT_NEAR(after_one[0], -0.6250876998, 5.1e-11);
  EXPECT_NEAR(after_one[1], -1.0345850857, 5.1e-11);
  EXPECT_NEAR(after_two[0], -0.4829715343, 5.1e-11);
  EXPECT_NEAR(after_two[1], -1.3240487123, 5.1e-11);
}

// The same motion without an angle: two points in the plane, the pulls of the rods found from d²(½|d|²)/dt² =
// 0.
TEST(DoublePendulum, AgreesWithTwoPointsOnRodsInCartesianCoordinates) {
  const State start{{1.3, -0.8}, {0.5, 2.0}};
  const double g = 3.7;
  using Vector = Eigen::Matrix<long double, 2, 1>;
  const Rate rate = [&](const ExtendedState& x, ExtendedState& dxdt) {
    const Vector d1(x[0], x[1]), d2(x[2] - x[0], x[3] - x[1]), v1(x[4], x[5]), v2(x[6], x[7]);
    const long double w1 = 1.0L / masses[0], w2 = 1.0L / masses[1];
    // m1·a1 = p·d1 − q·d2 + m1·g, m2·a2 = q·d2 + m2·g
    Eigen::Matrix<long double, 2, 2> A;
    A << w1 * d1.dot(d1), -w1 * d1.dot(d2), -w1 * d1.dot(d2), (w1 + w2) * d2.dot(d2);
    const Vector rest(-v1.squaredNorm() + g * d1.y(), -(v2 - v1).squaredNorm());
    const Vector pull = A.inverse() * rest;
    const Vector down(0, -g);
    const Vector a1 = w1 * (pull[0] * d1 - pull[1] * d2) + down, a2 = w2 * pull[1] * d2 + down;
    dxdt = {v1.x(), v1.y(), v2.x(), v2.y(), a1.x(), a1.y(), a2.x(), a2.y()};
  };
  const auto outward = [](double angle) { return Vector2d(std::sin(angle), -std::cos(angle)); };
  const auto onward = [](double angle) { return Vector2d(std::cos(angle), std::sin(angle)); };
  const auto cartesian = [&](const State& state) {
    const Vector2d x1 = lengths[0] * outward(state.angles[0]), x2 = x1 + lengths[1] * outward(state.angles[1]);
    const Vector2d v1 = lengths[0] * state.angular_velocities[0] * onward(state.angles[0]);
    const Vector2d v2 = v1 + lengths[1] * state.angular_velocities[1] * onward(state.angles[1]);
    return std::vector{x1.x(), x1.y(), x2.x(), x2.y(), v1.x(), v1.y(), v2.x(), v2.y()};
  };
  const DoublePendulum pendulum(start, lengths, masses, g);
  for (const double time : {0.5, 1.0, 2.0}) {
    const State end = pendulum.at(time);
    const Certified truth = certified_integration(rate, cartesian(start), time);
    const std::vector<double> got = cartesian(end);
    for (std::size_t i = 0; i < got.size(); ++i) EXPECT_NEAR(got[i], truth.state[i], 1e-13) << i << " at " << time;
  }
}

TEST(DoublePendulum, SwingsInItsTwoNormalModesWhenTheAnglesAreSmall) {
  const double length = 2, size = 1e-5, time = 1.3;
  for (const double sign : {-1.0, 1.0}) {
    const double omega = std::sqrt((2 + sign * std::numbers::sqrt2) * gravity / length);
    const Vector2d mode = size * Vector2d(1, -sign * std::numbers::sqrt2);
    const State end = DoublePendulum({mode, still}, length * ones, 3 * ones, gravity).at(time);
    EXPECT_LE((end.angles - std::cos(omega * time) * mode).norm(), 100 * size * size * size);
  }
}

TEST(DoublePendulum, WithALightSecondBobIsASimplePendulum) {
  const State end = DoublePendulum({{1.2, -0.3}, still}, lengths, {3, 3e-13}, gravity).at(1);
  EXPECT_NEAR(end.angles[0], SimplePendulum(1.2, lengths[0], gravity).angle(1), 1e-12);
}

TEST(DoublePendulum, WithALightFirstBobOnTheStraightRodIsASimplePendulumOfBothLengths) {
  const State end = DoublePendulum({{1e-4, 1e-4}, still}, {1, 1}, {1e-9, 1}, gravity).at(0.7);
  EXPECT_NEAR(end.angles[1], SimplePendulum(1e-4, 2, gravity).angle(0.7), 1e-9);
}

TEST(DoublePendulum, KeepsItsEnergy) {
  const State start{{pi / 2, 2.5}, {1, -3}};
  const DoublePendulum pendulum(start, lengths, masses, gravity);
  for (const double time : {0.5, 2.0, 10.0})
    EXPECT_NEAR(pendulum.energy(pendulum.at(time)), pendulum.energy(start), 1e-11) << time;
}

TEST(DoublePendulum, ScalesAsItsDimensionsSay) {
  const State start{{pi / 2, 1}, {1, -3}}, slow{{pi / 2, 1}, {0.5, -1.5}};
  const State end = DoublePendulum(start, lengths, masses, gravity).at(1);
  const State longer = DoublePendulum(slow, 4 * lengths, 7 * masses, gravity).at(2);
  EXPECT_LE((longer.angles - end.angles).norm(), 1e-13);
  EXPECT_LE((2 * longer.angular_velocities - end.angular_velocities).norm(), 1e-13);
}

TEST(DoublePendulum, IsItsOwnMirrorImage) {
  const State end = DoublePendulum({{pi / 2, 1}, {1, -3}}, lengths, masses, gravity).at(2);
  const State mirrored = DoublePendulum({{-pi / 2, -1}, {-1, 3}}, lengths, masses, gravity).at(2);
  EXPECT_LE((mirrored.angles + end.angles).norm(), 1e-13);
}

TEST(DoublePendulum, IsSureOfTwoSecondsAndLessSureOfTwenty) {
  const DoublePendulum pendulum({{pi / 2, pi / 2}, still}, ones, ones, gravity);
  EXPECT_LE(pendulum.at(2).uncertainty, 1e-13);
  EXPECT_GT(pendulum.at(20).uncertainty, 100 * pendulum.at(2).uncertainty);
}

TEST(DoublePendulum, ForgetsItsStartWithinTenSecondsAsTheAtlasSays) {
  const double nudge = 1e-8;
  const auto apart = [&](double time) {
    const State one = DoublePendulum({{pi / 2, pi / 2}, still}, ones, ones, gravity).at(time);
    const State two = DoublePendulum({{pi / 2 + nudge, pi / 2}, still}, ones, ones, gravity).at(time);
    return std::max((two.angles - one.angles).lpNorm<Eigen::Infinity>(),
                    (two.angular_velocities - one.angular_velocities).lpNorm<Eigen::Infinity>());
  };
  EXPECT_LE(apart(2), 10 * nudge);
  EXPECT_NEAR(apart(10), 1.4e-6, 5e-8);
}

TEST(DoublePendulum, RefusesBadNumbers) {
  EXPECT_THAT(
      [] {
        DoublePendulum({{1, 1}, still}, {1, -2}, ones, gravity);
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("is -2, but it must be a positive")));
  EXPECT_THROW(DoublePendulum({{1, NAN}, still}, ones, ones, gravity), std::invalid_argument);
  EXPECT_THROW(DoublePendulum({{1, 1}, {INFINITY, 0}}, ones, ones, gravity), std::invalid_argument);
  EXPECT_THROW(DoublePendulum({{1, 1}, still}, ones, {0, 1}, gravity), std::invalid_argument);
  EXPECT_THROW(DoublePendulum({{1, 1}, still}, ones, ones, 0), std::invalid_argument);
  EXPECT_THROW(DoublePendulum({{1, 1}, still}, ones, ones, gravity).at(-1), std::invalid_argument);
}

}  // namespace double_pendulum_test
