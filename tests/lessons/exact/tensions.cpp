#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "lessons/exact/circle.hpp"
#include "lessons/exact/conical_pendulum.hpp"
#include "lessons/exact/hanging_chain.hpp"

namespace tensions_test {

using namespace byhand;
using testing::DoubleEq, testing::ElementsAre, testing::HasSubstr, testing::IsEmpty, testing::ThrowsMessage;

constexpr double pi = std::numbers::pi;

TEST(CircleTension, IsTheRateAtWhichMomentumTurns) {
  const double mass = 3, speed = 4, radius = 2, small = 1e-4;
  const double momentum_change = 2 * mass * speed * std::sin(small / 2), time = radius * small / speed;
  EXPECT_NEAR(circle_tension(mass, speed, radius), momentum_change / time, 1e-7);
  EXPECT_EQ(circle_tension(mass, -speed, radius), circle_tension(mass, speed, radius));
  EXPECT_EQ(circle_tension(mass, 0, radius), 0);
}

TEST(CircleTension, RefusesBadNumbers) {
  EXPECT_THAT([] { circle_tension(3, 4, 0); }, ThrowsMessage<std::invalid_argument>(HasSubstr("radius is 0")));
  EXPECT_THROW(circle_tension(-3, 4, 1), std::invalid_argument);
  EXPECT_THROW(circle_tension(3, NAN, 1), std::invalid_argument);
}

TEST(ConicalPendulum, BalancesWeightUpwardsAndTurnsMomentumInwards) {
  const double length = 2, mass = 3, gravity = 9.81;
  for (const double angle : {0.1, 0.7, pi / 3, 1.5}) {
    const ConicalPendulum cone(angle, length, gravity);
    const double omega = cone.angular_velocity();
    EXPECT_NEAR(cone.tension(mass) * std::cos(angle), mass * gravity, 1e-13 * mass * gravity);
    EXPECT_NEAR(cone.tension(mass) * std::sin(angle), circle_tension(mass, omega * cone.radius(), cone.radius()),
                1e-13 * cone.tension(mass));
    EXPECT_NEAR(cone.period() * omega, 2 * pi, 1e-14);
  }
}

TEST(ConicalPendulum, NearlyHangingTurnsAsASmallSwing) {
  EXPECT_EQ(ConicalPendulum(0, 2, 9.81).angular_velocity(), std::sqrt(9.81 / 2));
  EXPECT_EQ(ConicalPendulum(0, 2, 9.81).tension(3), 3 * 9.81);
}

TEST(ConicalPendulum, RefusesToTurnLevel) {
  EXPECT_THAT([] { ConicalPendulum(pi / 2, 2, 9.81); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("is 1.5707963267948966, but it must be at least 0")));
  EXPECT_THROW(ConicalPendulum(-0.1, 2, 9.81), std::invalid_argument);
  EXPECT_THROW(ConicalPendulum(NAN, 2, 9.81), std::invalid_argument);
  EXPECT_THROW(ConicalPendulum(1, 0, 9.81), std::invalid_argument);
  EXPECT_THROW(ConicalPendulum(1, 2, -9.81), std::invalid_argument);
  EXPECT_THROW(ConicalPendulum(1, 2, 9.81).tension(INFINITY), std::invalid_argument);
}

TEST(HangingChain, EachJointCarriesTheWeightBelowIt) {
  const std::vector<double> masses = {1, 2, 4};
  EXPECT_THAT(hanging_chain_tensions(masses, 9.81),
              ElementsAre(DoubleEq(7 * 9.81), DoubleEq(6 * 9.81), DoubleEq(4 * 9.81)));
}

TEST(HangingChain, EveryLinkIsInBalance) {
  const std::vector<double> masses = {0.3, 5, 1e-3, 100, 2};
  const std::vector<double> tensions = hanging_chain_tensions(masses, 3.7);
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const double below = i + 1 < masses.size() ? tensions[i + 1] : 0;
    EXPECT_NEAR(tensions[i] - below, masses[i] * 3.7, 1e-13);
  }
}

TEST(HangingChain, WithoutLinksHasNoTension) { EXPECT_THAT(hanging_chain_tensions({}, 9.81), IsEmpty()); }

TEST(HangingChain, RefusesALinkWithoutMass) {
  const std::vector<double> masses = {1, 0}, endless = {1, INFINITY}, good = {1};
  EXPECT_THAT([&] { hanging_chain_tensions(masses, 9.81); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("is 0, but it must be a positive")));
  EXPECT_THROW(hanging_chain_tensions(endless, 9.81), std::invalid_argument);
  EXPECT_THROW(hanging_chain_tensions(good, 0), std::invalid_argument);
}

}  // namespace tensions_test
