#include <gtest/gtest.h>

#include <cmath>

#include "lessons/page/claim_words.hpp"
#include "lessons/terminal/terminal_text.hpp"

namespace byhand::tests {
namespace {

using namespace byhand::course;

Claim claim(double expected, double measured, Tolerance tolerance) {
  return {.quantity = "q",
          .unit = "m",
          .expected = expected,
          .source = "s",
          .measured = measured,
          .tolerance = tolerance};
}

TEST(Claim, CallsRoundingByItsName) {
  EXPECT_EQ(expectation(claim(0.5, 0.5, absolute(9e-12))), "0.5 ± 9·10⁻¹² m (rounding)");
  EXPECT_EQ(expectation(claim(0.5, 0.5, absolute(2e-11))), "0.5 ± 2·10⁻¹¹ m");
  EXPECT_EQ(expectation(claim(0.5, 0.5, absolute(0))), "0.5 ± 0 m");
  EXPECT_EQ(expectation(claim(0.5, 0.5, relative(1e-5))), "0.5 m ± 0.001 %");
  EXPECT_EQ(expectation(claim(0.5, 0.5, relative(1e-6))), "0.5 m to 6 digits");
  EXPECT_EQ(expectation(claim(0.5, 0.5, relative(3e-14))), "0.5 m to 13 digits");
  EXPECT_EQ(expectation(claim(5e-15, 0, at_most())), "≤ 5·10⁻¹⁵ m (rounding)");
  EXPECT_EQ(expectation(claim(0.5, 0.5, at_least())), "≥ 0.5 m");
  EXPECT_EQ(measurement(claim(0, -2e-16, absolute(0.001))), "−2·10⁻¹⁶ m (rounding)");
  EXPECT_EQ(measurement(claim(0, -4.8e-140, absolute(0.001))), "below 10⁻³⁰ m (rounding)");
  EXPECT_EQ(expectation(claim(8e-14, 9e-14, absolute(1e-9))), "0 ± 10⁻⁹ m");
  EXPECT_EQ(measurement(claim(8e-14, 9e-14, absolute(1e-9))), "9·10⁻¹⁴ m (rounding)");
  EXPECT_EQ(expectation(claim(8e-14, 9e-14, absolute(1e-15))), "8·10⁻¹⁴ ± 10⁻¹⁵ m (rounding)");
  EXPECT_EQ(measurement(claim(0, 2e-11, absolute(0.001))), "2·10⁻¹¹ m");
  EXPECT_EQ(measurement(claim(5e-15, 2e-16, at_most())), "2·10⁻¹⁶ m (rounding)");
  EXPECT_EQ(measurement(claim(8e-20, 8e-20, relative(0.001))), "8·10⁻²⁰ m") << "what is expected is no rounding";
}

TEST(Claim, SaysInPlainWordsWhatIsRounding) {
  EXPECT_EQ(in_plain_words("2·10⁻¹⁶ m (rounding)"), "0, but for rounding");
  EXPECT_EQ(in_plain_words("≤ 5·10⁻¹⁵ m (rounding)"), "0, but for rounding");
  EXPECT_EQ(in_plain_words("0 ± 10⁻¹⁵ N·s (rounding)"), "0, but for rounding");
  EXPECT_EQ(in_plain_words("0.5 ± 9·10⁻¹² m (rounding)"), "0.5 m, but for rounding");
  EXPECT_EQ(in_plain_words("slip = 4·10⁻¹⁷ (rounding), way = 2 m"), "slip = 0, but for rounding, way = 2 m");
  EXPECT_EQ(in_plain_words("2.006 s ± 0.1 %"), "2.006 s ± 0.1 %");
}

TEST(Claim, SaysNoMeaninglessNumberWhereNothingIsClaimed) {
  for (const double wild : {2e9, -2e140, 9e-12, std::nan(""), HUGE_VAL}) {
    Claim outside = claim(wild, wild, absolute(1));
    EXPECT_NE(measurement(outside), "–") << "a claim shows what it measures";
    EXPECT_NE(expectation(outside), "–");
    outside.range.met = false;
    EXPECT_EQ(measurement(outside), "–") << wild;
    EXPECT_EQ(expectation(outside), "–") << wild;
  }
  Claim outside = claim(1, 0, absolute(0.1));
  outside.range.met = false;
  EXPECT_EQ(measurement(outside), "0 m");
  EXPECT_EQ(expectation(outside), "1 m") << "a tolerance is that of a claim";
}

}  // namespace
}  // namespace byhand::tests
