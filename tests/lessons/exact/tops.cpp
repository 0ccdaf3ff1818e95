#include <gtest/gtest.h>

#include <numbers>

#include "lessons/exact/free_top.hpp"
#include "lessons/exact/heavy_top.hpp"

namespace tops_test {

using namespace byhand;

TEST(FreeTop, ComesBackAfterAPeriodAndTurnsOverAfterHalfOfOne) {
  const Eigen::Vector3d cases[][2] = {{{1, 2, 3}, {0.1, 10, 0.1}},
                                      {{1, 2, 3}, {3, 1, 0.2}},
                                      {{2.5, 1, 2}, {-0.4, 1, 3}},
                                      {{1, 1.9, 1.1}, {0.3, 0.1, -2}}};
  for (const auto& [moments, spin] : cases) {
    const FreeTop top(moments, spin);
    EXPECT_LT((top.at(top.period()).value - spin).norm(), 1e-10);
    const double middle_moment = moments.sum() - moments.maxCoeff() - moments.minCoeff();
    Eigen::Index middle = 0;
    (moments.array() - middle_moment).abs().minCoeff(&middle);
    EXPECT_NEAR(top.at(top.period() / 2).value[middle], -spin[middle], 1e-10);
  }
}

TEST(FreeTop, KeepsEnergyAndMomentum) {
  const Eigen::Vector3d moments(1, 2, 3), spin(3, -2, 4);
  const FreeTop top(moments, spin);
  for (const double time : {0.1, 1.0, 7.0}) {
    const auto [now, uncertainty] = top.at(time);
    EXPECT_LT(uncertainty, 1e-12);
    EXPECT_NEAR(now.dot(moments.cwiseProduct(now)), spin.dot(moments.cwiseProduct(spin)), 1e-11);
    EXPECT_NEAR(moments.cwiseProduct(now).squaredNorm(), moments.cwiseProduct(spin).squaredNorm(), 1e-11);
  }
}

TEST(FreeTop, ItsPathHasTheSpinAtEachTime) {
  const FreeTop top({1, 2, 3}, {0.5, 10, 0.5});
  const auto path = top.path(5, 100);
  ASSERT_EQ(path.size(), 101U);
  for (const int i : {0, 1, 37, 100}) EXPECT_LT((path[i] - top.at(5 * i / 100.0).value).norm(), 1e-11) << i;
}

// Near its middle axis for ever longer: the period grows as the logarithm of what is off.
TEST(FreeTop, TheNearerTheMiddleAxisTheLongerItWaits) {
  const auto period = [](double off) { return FreeTop({1, 2, 3}, {off, 10, off}).period(); };
  EXPECT_NEAR((period(1e-6) - period(1e-5)) / (period(1e-5) - period(1e-4)), 1, 1e-6);
  EXPECT_TRUE(std::isinf(FreeTop({1, 2, 3}, {0, 10, 0}).period()));
}

TEST(FreeTop, RefusesWhatNoBodyHas) {
  EXPECT_THROW(FreeTop({1, 2, 4}, {1, 1, 1}), std::invalid_argument);
  EXPECT_THROW(FreeTop({1, 1, 1.5}, {1, 1, 1}), std::invalid_argument);
  EXPECT_THROW(FreeTop({1, 2, -3}, {1, 1, 1}), std::invalid_argument);
  EXPECT_THROW(FreeTop({1, 2, 3}, {0, 0, 0}), std::invalid_argument);
}

TEST(HeavyTop, PrecessesAtBothRootsOfItsEquation) {
  const HeavyTop top{.mass = 2, .arm = 0.3, .moment_along = 0.08, .moment_across = 0.25, .spin = 60};
  for (const double lean : {0.0, 0.4, 1.2, 2.0, 3.0})
    for (const double rate : top.precession(lean))
      EXPECT_NEAR(top.moment_across * rate * rate * std::cos(lean) - top.moment_along * top.spin * rate +
                      top.mass * top.gravity * top.arm,
                  0, 1e-10 * (1 + rate * rate));
  EXPECT_NEAR(top.precession(std::numbers::pi / 2)[0], 2 * 9.81 * 0.3 / (0.08 * 60), 1e-12);
}

TEST(HeavyTop, FallsBelowItsLeastSpin) {
  HeavyTop top{.mass = 2, .arm = 0.3, .moment_along = 0.08, .moment_across = 0.25, .spin = 60};
  const double least = top.least_spin(0.4);
  top.spin = least * (1 + 1e-9);
  EXPECT_NEAR(top.precession(0.4)[0], top.precession(0.4)[1], 1e-3);
  top.spin = least * (1 - 1e-9);
  EXPECT_THROW(top.precession(0.4), std::invalid_argument);
  EXPECT_EQ(top.least_spin(2), 0);
}

}  // namespace tops_test
