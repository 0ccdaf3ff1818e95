#include "solver/integrate/rotation.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>
#include <unsupported/Eigen/AutoDiff>

namespace rotation_test {

using namespace byhand;
using Eigen::Vector2d, Eigen::Vector3d, Eigen::Quaterniond;
using Dual = Eigen::AutoDiffScalar<Vector3d>;
using SecondDual = Eigen::AutoDiffScalar<Eigen::Matrix<Dual, 1, 1>>;

constexpr double pi = std::numbers::pi;

double in_ulps(double got, long double expected) {
  const double size = std::abs(static_cast<double>(expected));
  return static_cast<double>(std::abs(got - expected)) /
         (std::nextafter(size, std::numeric_limits<double>::infinity()) - size);
}

double worst_error_in_ulps(double angle) {
  const auto [s, c] = sin_cos(angle);
  return std::max(in_ulps(s, std::sin(static_cast<long double>(angle))),
                  in_ulps(c, std::cos(static_cast<long double>(angle))));
}

/// x with dx/dt = 1 at both levels, so that .derivatives()(0).derivatives()(0) of f(x) is f''.
SecondDual twice_differentiable(double x) {
  SecondDual result(Dual(x, 3, 0));
  result.derivatives()(0) = Dual(1.0);
  return result;
}
double second_derivative(const SecondDual& f) { return f.derivatives()(0).derivatives()(0); }

Dual constant(double value) { return {value, Vector3d::Zero()}; }

TEST(SinCos, IsWithinOneUlpOfTheTruth) {
  std::mt19937_64 random(20261121);
  for (const double range : {1e-300, 1e-8, 1e-3, 0.1, pi / 4, 2.0, 100.0, 1e4, 1e5}) {
    std::uniform_real_distribution<double> angle(-range, range);
    double worst = 0;
    for (int i = 0; i < 200'000; ++i) worst = std::max(worst, worst_error_in_ulps(angle(random)));
    EXPECT_LE(worst, 1.0) << "for |angle| <= " << range;
  }
}

TEST(SinCos, KeepsItsDigitsNextToEveryMultipleOfAQuarterTurn) {
  double worst = 0;
  for (int k = -63'000; k <= 63'000; ++k) {
    const double near = k * pi / 2;
    for (const double angle : {std::nextafter(near, -1e9), near, std::nextafter(near, 1e9)})
      worst = std::max(worst, worst_error_in_ulps(angle));
  }
  EXPECT_LE(worst, 1.0);
}

TEST(SinCos, IsOddAndEvenToTheLastBit) {
  for (double angle = 0; angle < 40; angle += 0.0137) {
    EXPECT_EQ(sin_cos(-angle).sin, -sin_cos(angle).sin);
    EXPECT_EQ(sin_cos(-angle).cos, sin_cos(angle).cos);
  }
  EXPECT_EQ(sin_cos(0.0).sin, 0.0);
  EXPECT_EQ(sin_cos(0.0).cos, 1.0);
}

TEST(SinCos, OfWhatIsNotFiniteIsNotANumber) {
  for (const double angle : {std::numeric_limits<double>::infinity(), std::nan("")}) {
    EXPECT_TRUE(std::isnan(sin_cos(angle).sin));
    EXPECT_TRUE(std::isnan(sin_cos(angle).cos));
  }
}

TEST(SinCos, PassesFirstAndSecondDerivativesThroughEveryQuadrant) {
  for (const double x : {0.0, 1e-9, 0.3, pi / 4, 0.8, 2.0, 3.0, 4.5, 6.0, -1.0, 1234.5}) {
    const auto [s, c] = sin_cos(Dual(x, 3, 1));
    EXPECT_NEAR(s.derivatives()(1), std::cos(x), 1e-14) << x;
    EXPECT_NEAR(c.derivatives()(1), -std::sin(x), 1e-14) << x;
    EXPECT_EQ(s.derivatives()(0), 0.0);
    const auto [s2, c2] = sin_cos(twice_differentiable(x));
    EXPECT_NEAR(second_derivative(s2), -std::sin(x), 1e-12) << x;
    EXPECT_NEAR(second_derivative(c2), -std::cos(x), 1e-12) << x;
  }
}

TEST(PlaneRotation, TakesTheSpaceOfTwoNumbers) { EXPECT_EQ(sizeof(PlaneRotation<>), 2 * sizeof(double)); }

TEST(PlaneRotation, TurnsXIntoYByAQuarterTurn) {
  const Vector2d v = rotate(plane_rotation(pi / 2), Vector2d(2, 1));
  EXPECT_NEAR(v.x(), -1, 1e-15);
  EXPECT_NEAR(v.y(), 2, 1e-15);
}

TEST(PlaneRotation, OfASumOfAnglesIsTheProduct) {
  const PlaneRotation<> product = plane_rotation(0.7) * plane_rotation(1.9), sum = plane_rotation(2.6);
  EXPECT_NEAR(product.cos, sum.cos, 1e-15);
  EXPECT_NEAR(product.sin, sum.sin, 1e-15);
  EXPECT_NEAR(angle(sum), 2.6, 1e-15);
}

TEST(PlaneRotation, IsUndoneByItsInverse) {
  const PlaneRotation<> r = plane_rotation(2.3);
  EXPECT_LE((rotate(inverse(r), rotate(r, Vector2d(1, 2))) - Vector2d(1, 2)).norm(), 1e-15);
}

TEST(PlaneRotation, StaysAUnitNumberAndKeepsItsAngleOverAMillionSteps) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> step(-0.5, 0.7);
  PlaneRotation<> r;
  long double total = 0;
  double worst = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    const double by = step(random);
    r = rotated_by(r, by);
    total += by;
    const long double squared = static_cast<long double>(r.cos) * r.cos + static_cast<long double>(r.sin) * r.sin;
    worst = std::max(worst, static_cast<double>(std::abs(std::sqrt(squared) - 1)));
  }
  EXPECT_LE(worst, std::numeric_limits<double>::epsilon());
  // Rounding is a random walk: a million steps of about 1e-16 end about 1e-13 away.
  EXPECT_NEAR(std::remainder(static_cast<double>(angle(r) - std::fmod(total, 2 * std::numbers::pi_v<long double>)),
                             2 * pi),
              0, 1e-12);
}

TEST(PlaneRotation, PullsALengthThatIsOffBackToOne) {
  PlaneRotation<> r{1.01 * std::cos(0.4), 1.01 * std::sin(0.4)};
  for (int i = 0; i < 4; ++i) r = rotated_by(r, 0.0);
  EXPECT_NEAR(std::hypot(r.cos, r.sin), 1, 1e-15);
  EXPECT_NEAR(angle(r), 0.4, 1e-15);
}

TEST(PlaneRotation, DerivativeOfARotatedArmIsOmegaCrossIt) {
  PlaneRotation<Dual> r{constant(std::cos(0.6)), constant(std::sin(0.6))};
  const auto arm = rotate(rotated_by(r, Dual(0.0, 3, 0)), Vector2d(1, 2));
  EXPECT_NEAR(arm.x().derivatives()(0), -arm.y().value(), 1e-15);
  EXPECT_NEAR(arm.y().derivatives()(0), arm.x().value(), 1e-15);
  const auto twice = rotate(rotated_by(PlaneRotation<SecondDual>{}, twice_differentiable(0.0)), Vector2d(1, 2));
  EXPECT_NEAR(second_derivative(twice.x()), -1, 1e-15);
  EXPECT_NEAR(second_derivative(twice.y()), -2, 1e-15);
}

TEST(SpaceRotation, TakesTheSpaceOfFourNumbers) { EXPECT_EQ(sizeof(Quaterniond), 4 * sizeof(double)); }

TEST(SpaceRotation, IsTheRotationAboutTheAxisByTheLength) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  for (const double size : {0.0, 1e-200, 1e-12, 1e-4, 0.3, 1.5707, 1.5709, 3.0, 6.0, 50.0}) {
    const Vector3d axis = Vector3d(normal(random), normal(random), normal(random)).normalized(), v(1, -2, 0.5);
    const Vector3d turned = rotate(space_rotation<double>(size * axis), v);
    const Vector3d expected = Eigen::AngleAxisd(size, axis) * v;
    // `size * axis` is itself rounded: one epsilon of the whole turn.
    EXPECT_LE((turned - expected).norm(), (size + 8) * std::numeric_limits<double>::epsilon() * v.norm()) << size;
  }
}

TEST(SpaceRotation, TurnsAboutTheAxesOfTheWorld) {
  Quaterniond q = Quaterniond::Identity();
  q = rotated_by<double>(q, {0, 0, pi / 2});  // the body's x now points along y
  q = rotated_by<double>(q, {pi / 2, 0, 0});  // and, about the world's x, along z
  EXPECT_LE((rotate(q, Vector3d(1, 0, 0)) - Vector3d(0, 0, 1)).norm(), 1e-15);
}

TEST(SpaceRotation, IsUndoneByItsInverse) {
  const Quaterniond q = space_rotation<double>({0.3, 1.1, -0.4});
  EXPECT_LE((rotate(inverse(q), rotate(q, Vector3d(1, 2, 3))) - Vector3d(1, 2, 3)).norm(), 2e-15);
}

TEST(SpaceRotation, InThePlaneIsThePlaneRotation) {
  Quaterniond q = Quaterniond::Identity();
  PlaneRotation<> r;
  for (const double by : {0.1, -0.7, 2.9, 0.02}) {
    q = rotated_by<double>(q, {0, 0, by});
    r = rotated_by(r, by);
  }
  const Vector3d v = rotate(q, Vector3d(1, 2, 3));
  EXPECT_LE((v.head<2>() - rotate(r, Vector2d(1, 2))).norm(), 2e-15);
  EXPECT_NEAR(v.z(), 3, 2e-15);
}

TEST(TurnOf, IsTheTurnOfAtMostHalfARoundThatEitherQuaternionOfARotationStandsFor) {
  std::mt19937_64 random(12);
  std::normal_distribution<double> normal;
  for (const double size : {0.0, 1e-200, 1e-12, 0.3, 1.5, 3.0, 3.1415}) {
    const Vector3d turn = size * Vector3d(normal(random), normal(random), normal(random)).normalized();
    const Quaterniond q = space_rotation<double>(turn), same(-q.coeffs());
    const double rounding = 8 * std::numeric_limits<double>::epsilon() * size;
    EXPECT_LE((turn_of(q) - turn).norm(), rounding) << size;
    EXPECT_LE((turn_of(same) - turn).norm(), rounding) << size;
  }
}

TEST(SpaceRotation, StaysAUnitQuaternionAndKeepsItsAngleOverAMillionSteps) {
  const Vector3d turn(0.01, -0.02, 0.015);
  Quaterniond q = Quaterniond::Identity();
  double worst = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    q = rotated_by<double>(q, turn);
    worst = std::max(worst,
                     static_cast<double>(std::abs(std::sqrt(q.coeffs().cast<long double>().squaredNorm()) - 1)));
  }
  EXPECT_LE(worst, 2 * std::numeric_limits<double>::epsilon());
  // A turn that is rounded the same way each time drifts linearly: 1e6 steps of at most 1e-16 each.
  EXPECT_LE(q.angularDistance(space_rotation<double>(1e6 * turn)), 1e-10);
}

TEST(SpaceRotation, DerivativeOfARotatedArmIsOmegaCrossIt) {
  const Quaterniond pose = space_rotation<double>({0.3, 1.1, -0.4});
  const Eigen::Matrix<Dual, 3, 1> turn(Dual(0.0, 3, 0), Dual(0.0, 3, 1), Dual(0.0, 3, 2));
  const auto arm = rotate(rotated_by<Dual>(pose.cast<Dual>(), turn), Vector3d(1, 2, 3));
  const Vector3d v = rotate(pose, Vector3d(1, 2, 3));
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d expected = Vector3d::Unit(axis).cross(v);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(arm(i).derivatives()(axis), expected(i), 1e-15);
  }
}

TEST(SpaceRotation, SecondDerivativeAtZeroIsOmegaCrossOmegaCross) {
  const SecondDual zero(constant(0));
  const Eigen::Matrix<SecondDual, 3, 1> turn(zero, zero, twice_differentiable(0.0));
  const Eigen::Quaternion<SecondDual> unit(SecondDual(constant(1)), zero, zero, zero);
  const auto arm = rotate(rotated_by<SecondDual>(unit, turn), Vector3d(1, 2, 3));
  EXPECT_NEAR(second_derivative(arm(0)), -1, 1e-15);
  EXPECT_NEAR(second_derivative(arm(1)), -2, 1e-15);
  EXPECT_NEAR(second_derivative(arm(2)), 0, 1e-15);
}

TEST(SpaceRotation, HasTheSameDerivativesOnBothSidesOfItsSeries) {
  for (const double size : {1.57079, 1.57081}) {  // the series ends at a turn of pi/2
    const Eigen::Matrix<Dual, 3, 1> turn(Dual(size, 3, 0), Dual(0.0, 3, 1), Dual(0.0, 3, 2));
    const Eigen::Quaternion<Dual> q = space_rotation<Dual>(turn);
    EXPECT_NEAR(q.w().derivatives()(0), -0.5 * std::sin(size / 2), 1e-14);
    EXPECT_NEAR(q.x().derivatives()(0), 0.5 * std::cos(size / 2), 1e-14);
    EXPECT_NEAR(q.y().derivatives()(1), std::sin(size / 2) / size, 1e-14);
  }
}

// The same bits whatever the compiler, its optimisation and the processor; the number was written down from
// g++ -O3.
TEST(Rotation, GivesTheSameBitsEverywhere) {
  PlaneRotation<> r;
  Quaterniond q = Quaterniond::Identity();
  for (int i = 1; i <= 10'000; ++i) {
    r = rotated_by(r, 1.0 / i + 0.001 * i);
    q = rotated_by<double>(q, {1.0 / i, 0.001 * i, r.sin});
  }
  std::uint64_t hash = 14695981039346656037u;  // FNV-1a
  for (const double x : {r.cos, r.sin, q.w(), q.x(), q.y(), q.z()})
    hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 1099511628211u;
  EXPECT_EQ(hash, 12402617023114809402u);
}

}  // namespace rotation_test
