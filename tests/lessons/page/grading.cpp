// What a person may type as an answer, and what the lesson replies.

#include "lessons/page/grading.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "lessons/page/typed_quantity.hpp"

namespace byhand::tests {
namespace {

using namespace byhand::course;
using testing::HasSubstr;

Prediction asked(double answer, const std::string& unit, double tolerance) {
  return {.ask = "How much?", .answer = answer, .unit = unit, .tolerance = tolerance, .right = "Because."};
}

struct Typed {
  const char* words;
  double answer;
  const char* unit;
};

class ARightAnswer : public testing::TestWithParam<Typed> {};

TEST_P(ARightAnswer, IsAcceptedAsPeopleTypeIt) {
  const auto& [words, answer, unit] = GetParam();
  const Prediction question = asked(answer, unit, 1e-9 * std::abs(answer));
  const Grade given = grade(question, words);
  EXPECT_TRUE(given.right) << words << ": " << given.reply;
  EXPECT_EQ(given.reply, "Because.");
  // A wrong one is not.
  EXPECT_FALSE(grade(asked(1.01 * answer, unit, 1e-9 * std::abs(answer)), words).right) << words;
}

INSTANTIATE_TEST_SUITE_P(
    Grading, ARightAnswer,
    testing::Values(Typed{"0.205", 0.205, "m²"}, Typed{"0,205", 0.205, "m²"}, Typed{"1/5", 0.2, "m²"},
                    Typed{"2.05e-1", 0.205, "m²"}, Typed{"0.205 m2", 0.205, "m²"}, Typed{"0.205 m^2", 0.205, "m²"},
                    Typed{"0.205m²", 0.205, "m²"}, Typed{"2050 cm²", 0.205, "m²"},
                    Typed{"20.5 cm²", 0.00205, "m²"}, Typed{"  .205  ", 0.205, "m²"},
                    Typed{"pi/4", std::numbers::pi / 4, "rad"}, Typed{"π/4", std::numbers::pi / 4, "rad"},
                    Typed{"45°", std::numbers::pi / 4, "rad"}, Typed{"30°", 30, "°"}, Typed{"30", 30, "°"},
                    Typed{"30 deg", 30, "°"}, Typed{"pi/6", 30, "°"}, Typed{"pi/6 rad", 30, "°"},
                    Typed{"30", 30, "deg"}, Typed{"-0.5 N s", -0.5, "N·s"}, Typed{"-0.5 N·s", -0.5, "N s"},
                    Typed{"−0.5 Ns", -0.5, "N·s"}, Typed{"-0.5 kg m/s", -0.5, "N·s"},
                    Typed{"-0.5 kg·m·s⁻¹", -0.5, "N·s"}, Typed{"-500 g m/s", -0.5, "N·s"}, Typed{"2 J", 2, "N m"},
                    Typed{"1.2·10⁻⁵ m", 1.2e-5, "m"}, Typed{"12 µm", 1.2e-5, "m"}, Typed{"10⁻¹²", 1e-12, "1"},
                    Typed{"1/60 s", 1.0 / 60, "s"}, Typed{"16.6666666667 ms", 1.0 / 60, "s"},
                    Typed{"0.1", 0.1, "1"}, Typed{"11", 11, "1"}, Typed{"10 %", 0.1, "1"}, Typed{"0.1", 0.1, ""},
                    Typed{"5", 5, "%"}, Typed{"5%", 5, "%"}, Typed{"√2", std::numbers::sqrt2, "1"},
                    Typed{"sqrt(2)/2", std::numbers::sqrt2 / 2, "1"}, Typed{"(1 - 0.2)^5", 0.32768, "1"},
                    Typed{"2 pi rad/s", 2 * std::numbers::pi, "rad/s"}, Typed{"3 m⁴/s", 3, "m⁴/s"},
                    Typed{"½", 0.5, "1"}, Typed{"0.5 gh", 0.5, "gh"}, Typed{"0.5", 0.5, "gh"},
                    Typed{"14 boxes", 14, "boxes"}, Typed{"0.25 ½mv²", 0.25, "½mv²"},
                    Typed{"-9.81 m/s²", -9.81, "m/s^2"}, Typed{"3.6 km/s", 3600, "m/s"}, Typed{"2 1/s", 2, "1/s"},
                    Typed{"3 N·s/m", 3, "N·s/m"}, Typed{"3 kg/s", 3, "N·s/m"}),
    [](const auto& typed) { return std::to_string(typed.index); });

TEST(Grading, TextThatIsNoNumberIsNoAnswer) {
  for (const char* words :
       {"many", "",      "m",  "1x", "0x10",    "nan", "inf",      "1//2", "1 2", "1 1/2",    "2..3",    "1e999",
        "m 3",  "3 foo", "(1", "1)", "3 m + 2", "--",  "sqrt(-1)", "1/0",  "2^",  "\xff\xfe", "3 \033[A"}) {
    const Grade given = grade(asked(1, "m", 0.1), words);
    EXPECT_FALSE(given.understood) << words;
    EXPECT_THAT(given.reply, testing::AnyOf(HasSubstr("is not a number"), HasSubstr("divides by zero")));
    EXPECT_THAT(given.reply, HasSubstr("in m, a length")) << "it says the unit";
  }
}

/// The reply to a wrong answer.
std::string reply(const Prediction& question, const char* words) {
  const Grade given = grade(question, words, {{"½", 0.5}, {"2", 2}, {"g", 9.81}, {"h", 1.0 / 60}, {"L", 3.7}});
  EXPECT_FALSE(given.right) << words;
  EXPECT_TRUE(given.understood) << words;
  return given.reply;
}

TEST(Grading, ARightValueInAWrongUnitIsToldSo) {
  const Prediction area = asked(0.205, "m²", 0.001), angle = asked(30, "°", 0.1),
                   impulse = asked(-0.5, "N·s", 0.01);
  EXPECT_THAT(reply(area, "0.205 m"),
              HasSubstr("The number is right, the unit is not. That is a length; the answer is in m², an area"));
  EXPECT_THAT(reply(area, "7 m"), testing::Not(HasSubstr("The number is right")));
  EXPECT_THAT(reply(impulse, "-0.5 N"), HasSubstr("That is a force; the answer is in N·s, an impulse"));
  EXPECT_THAT(reply(area, "2050"), HasSubstr("The number is right in cm²"));
  EXPECT_THAT(reply(angle, "0.5236"), HasSubstr("The number is right in rad"));
  EXPECT_THAT(reply(asked(0.05, "1", 0.001), "5"), HasSubstr("The number is right in %"));
  EXPECT_THAT(reply(asked(0.025, "1", 0.004), "1.4"), testing::Not(HasSubstr("°"))) << "a share is no angle";
  EXPECT_THAT(reply(asked(14, "boxes", 0.5), "14 m"), HasSubstr("the answer is in boxes"));
}

TEST(Grading, AWrongSignAndAMissingFactorAreToldSo) {
  const Prediction question = asked(-0.6, "m", 0.01);
  EXPECT_THAT(reply(question, "0.6"), HasSubstr("think about the sign"));
  EXPECT_THAT(reply(question, "-1.2"), HasSubstr("A factor ½ is missing"));
  EXPECT_THAT(reply(question, "-0.3"), HasSubstr("A factor 2 is missing"));
  EXPECT_THAT(reply(question, "-36"), HasSubstr("A factor h is missing"));
  EXPECT_THAT(reply(question, "-0.01"), HasSubstr("There is a factor h too many"));
  EXPECT_THAT(reply(question, "-0.0612"), HasSubstr("A factor g is missing"));
  EXPECT_THAT(reply(question, "-2.22"), HasSubstr("There is a factor L too many"));
  EXPECT_THAT(reply(question, "1.2"), HasSubstr("A factor ½ is missing. The sign is wrong too."));
  EXPECT_THAT(reply(question, "-0.8"), HasSubstr("It is more than that."));
  EXPECT_THAT(reply(question, "-0.5"), HasSubstr("It is less than that."));
  EXPECT_THAT(reply(question, "-0.63"), HasSubstr("Close: it is a little more than that."));
  Prediction hinted = asked(24.1, "mm", 0.5);
  hinted.hinted = 25;
  EXPECT_TRUE(grade(hinted, "25").right);
  EXPECT_FALSE(grade(hinted, "26").right);
}

TEST(Grading, NothingIsMissingInAnAnswerThatIsNearlyZeroOrLooselyKnown) {
  EXPECT_THAT(reply(asked(0.001, "m", 0.01), "0.5"), HasSubstr("It is less"));
  EXPECT_THAT(reply(asked(1, "m", 0.5), "2"), HasSubstr("It is less"));
}

TEST(Grading, WhateverIsPrintedAsAnAnswerIsAcceptedWhenTypedBack) {
  std::mt19937 random(2026);
  std::uniform_real_distribution<double> exponent(-13, 9), fineness(-9, 0), sign(-1, 1);
  for (const char* unit : {"",
                           "1",
                           "m",
                           "m²",
                           "m/s",
                           "m²/s",
                           "m⁴/s",
                           "N",
                           "N s",
                           "N·s",
                           "N·s/m",
                           "J",
                           "kg",
                           "kg m²/s",
                           "°",
                           "deg",
                           "rad",
                           "rad/s",
                           "mm",
                           "cm",
                           "ms",
                           "Hz",
                           "%",
                           "1/s",
                           "1/kg",
                           "m²/kg",
                           "gh",
                           "mgL",
                           "½mv²",
                           "boxes",
                           "row-solves a row",
                           "of the first",
                           "v"})
    for (int i = 0; i < 200; ++i) {
      const double answer = std::copysign(std::pow(10, exponent(random)), sign(random));
      const Prediction question = asked(answer, unit, std::abs(answer) * std::pow(10, fineness(random)));
      const std::string printed = printed_answer(question);
      EXPECT_TRUE(grade(question, printed).right) << printed << " for " << answer << " ± " << question.tolerance;
    }
}

TEST(Grading, LongNonsenseIsRefusedAtOnce) {
  for (const std::string& words :
       {std::string(100'000, '('), std::string(100'000, 'm'), "1 " + std::string(60, 'm') + "x"})
    EXPECT_FALSE(grade(asked(1, "m", 0.1), words).understood);
}

TEST(Grading, AChoiceIsANumberOrItsWordsInAnyCase) {
  const Choice question{.ask = "Does it?", .options = {{"Yes", "It does."}, {"no", "It does not."}}, .answer = 0};
  for (const char* words : {"1", " 1 ", "Yes", "yes", "YES"}) EXPECT_TRUE(grade(question, words).right) << words;
  for (const char* words : {"2", "No"}) {
    EXPECT_FALSE(grade(question, words).right) << words;
    EXPECT_EQ(grade(question, words).reply, "It does not.");
  }
  for (const char* words : {"3", "0", "", "maybe"}) EXPECT_FALSE(grade(question, words).understood) << words;
}

}  // namespace
}  // namespace byhand::tests
