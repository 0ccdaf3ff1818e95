#include "lessons/exact/certified_integration.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace certified_integration_test {

using namespace byhand;

const Rate growth = [](const ExtendedState& x, ExtendedState& rate) { rate = {x[0]}; };
const Rate oscillator = [](const ExtendedState& x, ExtendedState& rate) { rate = {x[1], -9 * x[0]}; };

TEST(CertifiedIntegration, ErrsLessThanItsUncertainty) {
  for (const double time : {0.0, 0.1, 1.0, 7.0, 20.0}) {
    const Certified grown = certified_integration(growth, {2}, time);
    EXPECT_LE(std::abs(grown.state[0] - 2 * std::exp(time)), grown.uncertainty) << time;
    const Certified swung = certified_integration(oscillator, {0.5, 0}, time);
    EXPECT_LE(std::abs(swung.state[0] - 0.5 * std::cos(3 * time)), swung.uncertainty) << time;
    EXPECT_LE(std::abs(swung.state[1] + 1.5 * std::sin(3 * time)), swung.uncertainty) << time;
  }
}

TEST(CertifiedIntegration, IsGoodToNearlyAllDigitsOfADouble) {
  EXPECT_LE(certified_integration(oscillator, {0.5, 0}, 20).uncertainty, 1e-14);
  const Certified grown = certified_integration(growth, {2}, 20);
  EXPECT_LE(grown.uncertainty, 1e-14 * grown.state[0]);
}

TEST(CertifiedIntegration, IsLessSureOfAnUnstableProblem) {
  const Rate inverted = [](const ExtendedState& x, ExtendedState& rate) { rate = {x[1], 9 * std::sin(x[0])}; };
  const double soon = certified_integration(inverted, {1e-9, 0}, 1).uncertainty;
  const double late = certified_integration(inverted, {1e-9, 0}, 20).uncertainty;
  EXPECT_GT(late, 100 * soon);
}

TEST(CertifiedIntegration, RefusesTimesThatRunBackwardsAndStartsThatAreNoNumbers) {
  using testing::HasSubstr, testing::ThrowsMessage;
  EXPECT_THAT([] { certified_integration(growth, {2}, -1); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("time is -1")));
  EXPECT_THROW(certified_integration(growth, {2}, std::nan("")), std::invalid_argument);
  EXPECT_THROW(certified_integration(growth, {INFINITY}, 1), std::invalid_argument);
}

}  // namespace certified_integration_test
