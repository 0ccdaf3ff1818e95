// Whatever is typed, the desk answers with a sentence.
#include <gtest/gtest.h>

#include "lessons/desk/sheet.hpp"

namespace byhand::desk {
namespace {

void expect_sentences(Sheet& sheet, const std::string& line) {
  for (const Check& check : sheet.add(line)) {
    const bool bad = check.outcome == Check::Outcome::wrong || check.outcome == Check::Outcome::unreadable;
    ASSERT_FALSE(bad && check.sentence.empty()) << line;
    ASSERT_GE(check.where.begin, 0) << line;
    ASSERT_LE(check.where.end, static_cast<int>(line.size())) << line;
  }
}

TEST(DeskHostile, AHundredThousandRandomLinesEndWithASentence) {
  static const char* const pieces[] = {
      "C",   "dC",    "J",         "=",      " = ",  "d",   "p1",     "p2",     "r1",    "x1",      "v1",
      "v2",  "w1",    "w2",        "L",      "n",    "u",   "k",      "R1",     "+",     "-",       ".",
      " x ", "*",     "/",         "|",      "(",    ")",   "[",      "]",      ",",     "^2",      "^T",
      "^",   "'",     "2",         "0.5",    "1e9",  "sin", "cos(",   "atan2(", "sqrt(", "\\frac{", "}",
      "{",   "\\dot", "\\omega_2", "\\left", ">= 0", ":",   "number", "\xff",   "é",     "ω1",      "\\",
      " ",   "_",     "perp(",     "skew(",  "E",    "&"};
  Random random(99);
  Sheet sheet, space(World{3, true});
  int answered = 0;
  for (int i = 0; i < 100000; ++i) {
    std::string line;
    const int length = 1 + random.below(14);
    if (random.below(2)) line = random.below(2) ? "C = " : "J = [";
    for (int k = 0; k < length; ++k) {
      if (random.below(12) == 0)
        line += static_cast<char>(random.below(256));
      else
        line += pieces[random.below(static_cast<int>(std::size(pieces)))];
    }
    Sheet& one = i % 2 ? sheet : space;
    expect_sentences(one, line);
    if (::testing::Test::HasFatalFailure()) return;
    ++answered;
  }
  EXPECT_EQ(answered, 100000);
}

TEST(DeskHostile, DeepAndLongLinesAreRefused) {
  Sheet sheet;
  const auto status_of = [](const std::string& line) {
    Sheet one;
    expect_sentences(one, line);
    return one.status();
  };
  EXPECT_EQ(status_of("C = " + std::string(1500, '(') + "d . n" + std::string(1500, ')')), 2);
  EXPECT_EQ(status_of("C = " + std::string(1500, '-') + "d . n"), 2);
  EXPECT_EQ(status_of("C = d . n" + std::string(500, '\'')), 2);
  EXPECT_EQ(status_of("C = " + std::string(100000, '1')), 2);
  EXPECT_EQ(status_of("C = d . n + " + std::string(800, '9') + " L"), 2);
  std::string sum = "C = d . n";
  for (int i = 0; i < 500; ++i) sum += "+d.n";
  EXPECT_NE(status_of(sum), 1);
  std::string tower = "C = sin(d.n/L)";
  for (int i = 0; i < 60; ++i) tower = "C = sin(" + tower.substr(4) + ")";
  expect_sentences(sheet, tower);
  expect_sentences(sheet, "dC = d . d'");
}

TEST(DeskHostile, DefinitionsThatDoubleDoNotTakeForever) {
  Sheet sheet;
  sheet.add("a0 = d . d");
  for (int i = 1; i < 60; ++i)
    expect_sentences(sheet,
                     "a" + std::to_string(i) + " = a" + std::to_string(i - 1) + " + a" + std::to_string(i - 1));
  expect_sentences(sheet, "C = a59");
  expect_sentences(sheet, "dC = 2 d . v2");
}

TEST(DeskHostile, NumbersBeyondDoublesCannotBeJudged) {
  Sheet sheet;
  const std::string huge = "1" + std::string(300, '0');
  expect_sentences(sheet, "C = " + huge + " " + huge + " (d . n)");
  expect_sentences(sheet, "dC = n . v2");
  EXPECT_NE(sheet.status(), 0);
}

}  // namespace
}  // namespace byhand::desk
