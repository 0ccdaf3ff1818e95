#include "renderer/ticks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace byhand::renderer {
namespace {

using testing::ElementsAre;

std::vector<std::string> labels(const Ticks& ticks) {
  std::vector<std::string> texts;
  for (const Tick& tick : ticks.major) texts.push_back(tick.label);
  return texts;
}

// A label back to the number it stands for.
double parsed(std::string text) {
  const auto replace = [&](const std::string& from, const std::string& to) {
    for (std::size_t i; (i = text.find(from)) != std::string::npos;) text.replace(i, from.size(), to);
  };
  replace("−", "-"), replace("⁻", "-"), replace("·10", "e");
  const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  const bool power = text.starts_with("10") && text.size() > 2 && (text[2] == '-' || (text[2] & 0x80));
  for (int d = 0; d < 10; ++d) replace(digits[d], std::to_string(d));
  if (power) text.replace(0, 2, "1e");
  return std::stod(text);
}

TEST(Ticks, OnALinearAxisAreRoundAndFew) {
  std::mt19937 random(20131207);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int trial = 0; trial < 20000; ++trial) {
    const double size = std::pow(10, -12 + 24 * unit(random));
    const double low = size * (2 * unit(random) - 1), high = low + size * std::pow(10, -3 * unit(random));
    const int most = 2 + int(10 * unit(random));
    const Ticks result = ticks(Scale::linear, low, high, most);
    SCOPED_TRACE(testing::Message() << low << " … " << high << ", at most " << most);
    ASSERT_GE(result.major.size(), 2u);
    ASSERT_LE(int(result.major.size()), std::max(most, 3) + (most == 2 ? 3 : 2));
    const double step = result.major[1].value - result.major[0].value;
    const double mantissa = step / std::pow(10, std::floor(std::log10(step * (1 + 1e-6))));
    ASSERT_TRUE(std::abs(mantissa - 1) < 1e-4 || std::abs(mantissa - 2) < 1e-4 || std::abs(mantissa - 5) < 1e-4)
        << step;
    for (std::size_t i = 0; i < result.major.size(); ++i) {
      const Tick& tick = result.major[i];
      ASSERT_GE(tick.value, low - 1e-6 * step);
      ASSERT_LE(tick.value, high + 1e-6 * step);
      ASSERT_NEAR(tick.value / step, std::round(tick.value / step),
                  1e-6 * std::max(1.0, std::abs(tick.value / step)));
      ASSERT_NEAR(parsed(tick.label) * std::pow(10, result.exponent), tick.value, 1e-6 * step) << tick.label;
    }
    const std::vector<std::string> texts = labels(result);
    ASSERT_EQ(std::adjacent_find(texts.begin(), texts.end()), texts.end());
  }
}

TEST(Ticks, OnALogarithmicAxisAreDecadesOrOneTwoFive) {
  std::mt19937 random(20131207);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int trial = 0; trial < 20000; ++trial) {
    const double low = std::pow(10, -15 + 25 * unit(random)),
                 high = low * std::pow(10, 0.02 + 18 * unit(random) * unit(random));
    const int most = 3 + int(9 * unit(random));
    const Ticks result = ticks(Scale::logarithmic, low, high, most);
    SCOPED_TRACE(testing::Message() << low << " … " << high << ", at most " << most);
    ASSERT_GE(result.major.size(), 2u);
    ASSERT_LE(int(result.major.size()), most + 2);
    ASSERT_EQ(result.exponent, 0);
    for (const Tick& tick : result.major) {
      ASSERT_GE(tick.value, low * (1 - 1e-6));
      ASSERT_LE(tick.value, high * (1 + 1e-6));
      ASSERT_NEAR(parsed(tick.label) / tick.value, 1, 1e-2) << tick.label;
    }
    for (const double v : result.minor) {
      ASSERT_GE(v, low * (1 - 1e-6));
      ASSERT_LE(v, high * (1 + 1e-6));
    }
  }
}

TEST(Ticks, AreWhatAReaderWouldWrite) {
  EXPECT_THAT(labels(ticks(Scale::linear, 0, 1, 6)), ElementsAre("0.0", "0.2", "0.4", "0.6", "0.8", "1.0"));
  EXPECT_THAT(labels(ticks(Scale::linear, -10, 10, 5)), ElementsAre("−10", "−5", "0", "5", "10"));
  EXPECT_THAT(labels(ticks(Scale::logarithmic, 0.01, 100, 6)), ElementsAre("0.01", "0.1", "1", "10", "100"));
  EXPECT_THAT(labels(ticks(Scale::logarithmic, 1e-6, 1, 4)), ElementsAre("10⁻⁶", "10⁻⁴", "10⁻²", "10⁰"));
  EXPECT_THAT(labels(ticks(Scale::logarithmic, 1, 64, 8)), ElementsAre("1", "2", "5", "10", "20", "50"));
  const Ticks tiny = ticks(Scale::linear, 0, 3e-7, 4);
  EXPECT_EQ(tiny.exponent, -7);
  EXPECT_THAT(labels(tiny), ElementsAre("0", "1", "2", "3"));
}

TEST(Ticks, RefuseAnEmptyOrInfiniteRange) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(ticks(Scale::linear, 1, 1, 5), std::invalid_argument);
  EXPECT_THROW(ticks(Scale::linear, 2, 1, 5), std::invalid_argument);
  EXPECT_THROW(ticks(Scale::linear, 0, infinity, 5), std::invalid_argument);
  EXPECT_THROW(ticks(Scale::logarithmic, 0, 1, 5), std::invalid_argument);
  EXPECT_THROW(ticks(Scale::linear, std::nan(""), 1, 5), std::invalid_argument);
}

TEST(Number, IsWrittenAsAReaderWould) {
  EXPECT_EQ(number(0.25), "0.25");
  EXPECT_EQ(number(-1200), "−1200");
  EXPECT_EQ(number(3.5e-7), "3.5·10⁻⁷");
  EXPECT_EQ(number(1e-9), "10⁻⁹");
  EXPECT_EQ(number(-1e12), "−10¹²");
  EXPECT_EQ(number(2.0), "2");
  EXPECT_EQ(number(9.996), "10");
  EXPECT_EQ(number(0.0), "0");
  EXPECT_EQ(number(-0.0), "0");
  EXPECT_EQ(number(29.43, 4), "29.43");
  EXPECT_EQ(number(1 / 3.0, 2), "0.33");
  EXPECT_EQ(number(std::nan("")), "–");
  EXPECT_EQ(number(-std::numeric_limits<double>::infinity()), "−∞");
}

}  // namespace
}  // namespace byhand::renderer
