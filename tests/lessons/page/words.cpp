// Numbers and words as a reader sees them.

#include "lessons/page/words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <random>
#include <sstream>

#include "lessons/page/article_equations.hpp"
#include "lessons/page/parameter.hpp"
#include "lessons/page/typed_quantity.hpp"
#include "lessons/terminal/typeset.hpp"

namespace byhand::tests {
namespace {

using namespace byhand::course;

TEST(Number, HasTheDigitsThatMatterAndATrueMinus) {
  EXPECT_EQ(number(0), "0");
  EXPECT_EQ(number(-0.0), "0");
  EXPECT_EQ(number(-0.42477), "−0.4248");
  EXPECT_EQ(number(2), "2");
  EXPECT_EQ(number(123456.7), "123457");
  EXPECT_EQ(number(9.99996), "10");
  EXPECT_EQ(number(-1.25e-7), "−1.25·10⁻⁷");
  EXPECT_EQ(number(1e-12), "10⁻¹²");
  EXPECT_EQ(number(2.5e6), "2.5·10⁶");
  EXPECT_EQ(number(-std::numeric_limits<double>::infinity()), "−∞");
  EXPECT_EQ(latex_number(-1.25e-7), "-1.25\\cdot 10^{-7}");
}

TEST(Say, PutsNumbersListsAndWordsInTheirPlaces) {
  EXPECT_EQ(say("@ links, d = @, @", 10, Eigen::Vector2d(1.2, -1.6), "taut"), "10 links, d = (1.2, −1.6), taut");
  EXPECT_EQ(say("@", 1234567), "1234567");
  const Formula formula = fill("λ = @", R"(\lambda = @)", {Value(-0.5)});
  EXPECT_EQ(formula.plain, "λ = −0.5");
  EXPECT_EQ(formula.latex, R"(\lambda = -0.5)");
}

TEST(Several, CountsOneAndMany) {
  EXPECT_EQ(several(1, "box", "boxes"), "1 box");
  EXPECT_EQ(several(0, "box", "boxes"), "0 boxes");
  EXPECT_EQ(several(2, "box", "boxes"), "2 boxes");
  EXPECT_EQ(several(17, "link"), "17 links");
  EXPECT_EQ(several(1, "link"), "1 link");
}

TEST(ReadNumber, TakesWhatPeopleType) {
  EXPECT_EQ(read_number("0.5"), 0.5);
  EXPECT_EQ(read_number("+.5"), 0.5);
  EXPECT_EQ(read_number("−2"), -2);
  EXPECT_EQ(read_number("1/60"), 1.0 / 60);
  EXPECT_EQ(read_number("1e-3"), 1e-3);
  for (const char* bad : {"", "x", "1x", "1/0", "0/0", "1//2", "/", "nan", "inf", "1e999", "1 2", "0x10"})
    EXPECT_THROW(read_number(bad), std::invalid_argument) << bad;
}

TEST(ReadNumber, ACommaThatMayPartThousandsIsRefusedWithBothMeanings) {
  EXPECT_EQ(read_number("0,205"), 0.205);
  EXPECT_EQ(read_number("1,5"), 1.5);
  EXPECT_EQ(read_number("1,50"), 1.5);
  EXPECT_EQ(read_number("1,5000"), 1.5);
  EXPECT_EQ(read_number("1234,500"), 1234.5);
  EXPECT_EQ(read_number(",500"), 0.5);
  for (const char* two : {"1,500", "-1,500", "12,000", "999,999", "2·1,500", "1,500/3", "1,500e3"})
    EXPECT_THROW(read_number(two), std::invalid_argument) << two;
  try {
    read_number("1,500");
    FAIL();
  } catch (const std::invalid_argument& refusal) {
    EXPECT_STREQ(refusal.what(), "\"1,500\" may mean 1500 or 1.500; write one of them");
  }
}

TEST(ReadQuantity, PiWithoutAUnitIsNoNumberOfDegrees) {
  EXPECT_NEAR(read_quantity("pi/6 rad", "deg"), 30, 1e-12);
  EXPECT_EQ(read_quantity("30", "deg"), 30);
  EXPECT_EQ(read_quantity("30°", "deg"), 30);
  EXPECT_NEAR(read_quantity("pi/6", "rad"), 0.5236, 1e-4);
  EXPECT_NEAR(read_quantity("pi/6", "m"), 0.5236, 1e-4);
  for (const char* unit : {"deg", "°"})
    for (const char* typed : {"pi/6", "π", "2 pi", "30 + pi"})
      EXPECT_THROW(read_quantity(typed, unit), std::invalid_argument) << typed << unit;
}

TEST(Typed, IsReadBackAsTheSameNumber) {
  std::mt19937 random(2026);
  std::uniform_real_distribution<double> exponent(-6, 6);
  EXPECT_EQ(typed(1.0 / 60), "1/60");
  EXPECT_EQ(typed(0.2), "0.2");
  for (int i = 0; i < 1000; ++i) {
    const double value = std::pow(10, exponent(random));
    EXPECT_EQ(read_number(typed(value)), value);
    EXPECT_EQ(read_number(typed(1 / std::ceil(value))), 1 / std::ceil(value));
  }
}

TEST(DisplayWidth, CountsColumnsNotBytes) {
  EXPECT_EQ(display_width("JM⁻¹Jᵀ"), 6);
  EXPECT_EQ(display_width("λ̇"), 1);  // a combining dot
  EXPECT_EQ(display_width("表"), 2);
  EXPECT_EQ(display_width("\033[1;36mβ\033[0m"), 1);
}

TEST(Words, ATextHasTheLinesBetweenItsLineBreaks) {
  EXPECT_THAT(lines_of("one\n\n two\n"), testing::ElementsAre("one", "", " two"));
  EXPECT_THAT(lines_of("one\ntwo"), testing::ElementsAre("one", "two"));
  EXPECT_THAT(lines_of("\n"), testing::ElementsAre(""));
  EXPECT_THAT(lines_of(""), testing::IsEmpty());
}

TEST(Unwrapped, MakesOneLineOfEachParagraphAndItem) {
  EXPECT_EQ(unwrapped(R"(One paragraph
      over two lines.

      Another,  with
        - a list:
      - an item
        over two lines
      - 3 - 1
      )"),
            "One paragraph over two lines.\n\nAnother,  with\n- a list:\n- an item over two lines\n- 3 - 1");
  EXPECT_EQ(unwrapped("\n  \n  first\n   \n\n second\n"), "first\n\nsecond");
  EXPECT_EQ(unwrapped("one line"), "one line");
  EXPECT_EQ(unwrapped(""), "");
}

TEST(Wrapped, KeepsEveryLineWithinTheWidthAndEveryWord) {
  const std::string words =
      "Die *Geschwindigkeit* λ̇ of `JM⁻¹Jᵀ` and **β**, said at length so that the line must break somewhere.\n\n- "
      "one item that is "
      "longer than a line of forty columns can hold\n- another";
  for (const bool colours : {false, true}) {
    std::istringstream lines(wrapped(words, {40, colours}, 4));
    std::string line;
    int count = 0;
    for (; std::getline(lines, line); ++count) {
      EXPECT_LE(display_width(line), 40) << line;
      EXPECT_TRUE(line.empty() || line.starts_with("    ")) << line;
    }
    EXPECT_GE(count, 6);
  }
  EXPECT_EQ(wrapped("*a* `b` **c** 2 * 3", {80, false}), "a `b` c 2 * 3\n");
}

TEST(Folded, KeepsShortLinesAsTheyAreAndBreaksLongOnesBetweenWords) {
  EXPECT_EQ(folded("JV = [ l₁  a₁ ]\n     [ l₂ ]", {40, false}, 2), "  JV = [ l₁  a₁ ]\n       [ l₂ ]\n");
  EXPECT_EQ(folded("  a quite long line of code that goes on;\n\nb", {24, false}, 2),
            "    a quite long line of\n        code that goes\n        on;\n\n  b\n");
}

TEST(TableOfWords, KeepsWithinTheWidthAndKeepsEveryWord) {
  const std::vector<std::vector<std::string>> rows = {
      {"**symbol**", "**meaning**", "unit"},
      {"C̈", "a second derivative, said at such length that it goes on and on", "m/s²"}};
  for (const int width : {30, 40, 80, 200}) {
    std::istringstream lines(table(rows, Style{width, true}, 2));
    std::string shown;
    for (std::string line; std::getline(lines, line); shown += line + " ")
      EXPECT_LE(display_width(line), width) << line;
    std::istringstream words(
        "symbol meaning unit C̈ a second derivative, said at such length that it goes on m/s²");
    for (std::string word; words >> word;) EXPECT_NE(shown.find(word), std::string::npos) << word;
  }
  EXPECT_EQ(table({{"a", "b"}, {"ccc", "d"}}, Style{80, false}, 2), "  a    b\n  ccc  d\n");
}

TEST(ArticleEquation, IsThereFrom1To23InBothForms) {
  for (int number = 1; number <= 23; ++number) {
    const Formula& formula = article_equation(number);
    EXPECT_FALSE(formula.plain.empty());
    EXPECT_EQ(std::count(formula.latex.begin(), formula.latex.end(), '{'),
              std::count(formula.latex.begin(), formula.latex.end(), '}'));
    std::istringstream lines(formula.plain);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(display_width(line), 80 - 6 - 6) << line;
  }
}

}  // namespace
}  // namespace byhand::tests
