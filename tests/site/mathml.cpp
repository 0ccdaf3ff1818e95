#include "lessons/page/html/mathml.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "lessons/page/article_equations.hpp"
#include "lessons/page/error.hpp"
#include "lessons/page/words.hpp"
#include "tests/site/markup.hpp"

namespace byhand::tests {
namespace {

using site::display_mathml;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// What stands within <math>.
std::string converted(const std::string& latex) {
  const std::string math = site::inline_mathml(latex);
  const auto begin = math.find('>') + 1;
  return math.substr(begin, math.rfind("</math>") - begin);
}

TEST(MathML, LettersAreVariablesAndDigitsNumbers) {
  EXPECT_EQ(converted("JV"), "<mi>J</mi><mi>V</mi>");
  EXPECT_EQ(converted("13.5"), "<mn>13.5</mn>");
  EXPECT_EQ(converted("2."), "<mn>2</mn><mo>.</mo>");
  EXPECT_EQ(converted("-\\beta"), "<mo form=\"prefix\">−</mo><mi>β</mi>");
}

TEST(MathML, IndicesAndExponentsBelongToTheLastElement) {
  EXPECT_EQ(converted("v_1"), "<msub><mi>v</mi><mn>1</mn></msub>");
  EXPECT_EQ(converted("J^T"), "<msup><mi>J</mi><mi>T</mi></msup>");
  EXPECT_EQ(converted("v_0^2"), converted("v^2_0"));
  EXPECT_EQ(converted("v_0^2"), "<msubsup><mi>v</mi><mn>0</mn><mn>2</mn></msubsup>");
  EXPECT_EQ(converted("10^{-5}"), "<msup><mn>10</mn><mrow><mo form=\"prefix\">−</mo><mn>5</mn></mrow></msup>");
  EXPECT_EQ(converted("C'"), "<msup><mi>C</mi><mrow><mo lspace=\"0\" rspace=\"0\">′</mo></mrow></msup>");
}

TEST(MathML, AnIndexOfManyLettersIsAName) {
  EXPECT_EQ(converted("V_{final}"), "<msub><mi>V</mi><mi>final</mi></msub>");
  EXPECT_EQ(converted("A_{ij}"), "<msub><mi>A</mi><mrow><mi>i</mi><mi>j</mi></mrow></msub>");
}

TEST(MathML, ADigitAfterACommandIsAnArgumentOfItsOwn) {
  EXPECT_EQ(converted("\\frac12"), "<mfrac><mn>1</mn><mn>2</mn></mfrac>");
  EXPECT_EQ(
      converted("\\tfrac12 m"),
      "<mstyle displaystyle=\"false\" scriptlevel=\"0\"><mfrac><mn>1</mn><mn>2</mn></mfrac></mstyle><mi>m</mi>");
  EXPECT_EQ(converted("v_12"), "<msub><mi>v</mi><mn>1</mn></msub><mn>2</mn>");
}

TEST(MathML, FunctionsAreUprightAndSpacedFromAnArgumentWithoutBrackets) {
  EXPECT_EQ(converted("\\cos(x)"),
            "<mi>cos</mi><mo stretchy=\"false\">(</mo><mi>x</mi><mo stretchy=\"false\">)</mo>");
  EXPECT_EQ(converted("\\cos x"), "<mi>cos</mi><mspace width=\"0.167em\"></mspace><mi>x</mi>");
  EXPECT_EQ(converted("\\cos^2 x"),
            "<msup><mi>cos</mi><mn>2</mn></msup><mspace width=\"0.167em\"></mspace><mi>x</mi>");
}

TEST(MathML, UnitsAreUpright) {
  EXPECT_EQ(converted("\\mathrm{N\\,s}"),
            "<mrow><mi mathvariant=\"normal\">N</mi><mspace width=\"0.167em\"></mspace>"
            "<mi mathvariant=\"normal\">s</mi></mrow>");
  EXPECT_EQ(converted("\\mathrm{m^2/kg}"),
            "<mrow><msup><mi mathvariant=\"normal\">m</mi><mn>2</mn></msup><mo lspace=\"0.06em\" "
            "rspace=\"0.06em\">/</mo><mi>kg</mi></mrow>");
}

TEST(MathML, AMatrixHasItsRowsAndColumns) {
  const Markup matrix(site::inline_mathml("\\begin{bmatrix} a & b \\\\ c & d \\\\ e & f \\end{bmatrix}"));
  EXPECT_THAT(matrix.all("//*[local-name()='mtr']"), ElementsAre("ab", "cd", "ef"));
  EXPECT_THAT(matrix.all("//*[local-name()='mtd']"), SizeIs(6));
}

TEST(MathML, DelimitersGrowWithWhatTheyHold) {
  EXPECT_THAT(converted("\\left(\\frac{1}{2}\\right)"), HasSubstr("<mo fence=\"true\">(</mo><mfrac>"));
  EXPECT_THAT(converted("\\bigl[x\\bigr]"), HasSubstr("minsize=\"1.2em\" maxsize=\"1.2em\">]"));
  EXPECT_EQ(converted("\\left. x \\right|"), "<mrow><mi>x</mi><mo fence=\"true\">|</mo></mrow>");
}

TEST(MathML, ADisplayBreaksBetweenStatementsAndBeforeRelationsButTheFirst) {
  const auto parts = [](const std::string& latex) {
    return Markup("<all>" + display_mathml(latex) + "</all>").all("//*[local-name()='math']");
  };
  EXPECT_THAT(parts("a = b \\quad c = d \\qquad e"), ElementsAre("a=b", "c=d", "e"));
  EXPECT_THAT(parts("a = b = c \\le d"), ElementsAre("a=b", "=c", "≤d"));
  EXPECT_THAT(parts("a = b, \\quad c = d"), ElementsAre("a=b,", "c=d"));
  EXPECT_THAT(parts("\\frac{a = b = c \\quad d}{e}"), SizeIs(1));
  EXPECT_THAT(parts("\\quad a"), ElementsAre("a"));
  EXPECT_THAT(parts("a = b + c"), SizeIs(1));
  EXPECT_THAT(parts(course::article_equation(19).latex), SizeIs(3)) << "a long sum breaks before its terms";
  EXPECT_THAT(display_mathml("a = (b \\cdot b)\\,c + d"), HasSubstr("><mo form=\"infix\">+</mo>"));
}

TEST(MathML, ASignWithoutAnOperandBeforeItBelongsToWhatFollows) {
  const std::string prefix = "<mo form=\"prefix\">−</mo>", binary = "<mo>−</mo>";
  for (const std::string before : {"", "a = ", "a + (", "2 \\cdot ", "\\frac{1}{2} = ", "a,\\, ", "a \\le ", "["})
    EXPECT_THAT(converted(before + "-b"), HasSubstr(prefix)) << before;
  for (const std::string before : {"a", "(a)", "a^2", "\\beta", "\\frac{1}{2}", "a\\,", "|a|", "3", "\\sqrt{2}"})
    EXPECT_THAT(converted(before + "-b"), HasSubstr(binary)) << before;
  EXPECT_THAT(converted("|-a|"), HasSubstr(prefix));
  EXPECT_THAT(converted("x^{-1}"), HasSubstr(prefix));
}

TEST(MathML, WhatItDoesNotKnowIsNamedWithTheFormula) {
  const auto refusal = [](const std::string& latex) {
    try {
      display_mathml(latex);
    } catch (const course::LessonError& error) {
      return std::string(error.what());
    }
    return std::string("converted");
  };
  EXPECT_THAT(refusal("a + \\mystery{b}"), HasSubstr("unknown command \\mystery"));
  EXPECT_THAT(refusal("a + \\mystery{b}"), HasSubstr("\"a + \\mystery{b}\""));
  for (const char* const bad :
       {"", "a}", "{a", "\\frac{a}", "a^", "\\left(a", "a\\right)", "\\begin{bmatrix}a",
        "\\begin{pmatrix}a\\end{pmatrix}", "\\sqrt", "a & b", "\\text{a", "\\bigl(a\\Bigr)", "\\"})
    EXPECT_NE(refusal(bad), "converted") << bad;
}

TEST(MathML, OfEveryEquationOfTheArticleIsWellFormedAndComplete) {
  for (int i = 1; i <= course::article_equations; ++i) {
    const Markup math("<all>" + display_mathml(course::article_equation(i).latex) + "</all>");
    EXPECT_EQ(math.mistake(), "") << i;
    EXPECT_THAT(math.all("//*[local-name()='msub' or local-name()='msup' or local-name()='mfrac'][count(*) != 2]"),
                IsEmpty());
    EXPECT_THAT(math.all("//*[local-name()='mi' or local-name()='mn' or local-name()='mo'][string()='']"),
                IsEmpty());
  }
}

TEST(MathML, HoldsEveryNumberThatAFormulaCanGet) {
  for (const double value : {0.0, -0.5, 1e-12, -3.2e7, 1e300, 1.0 / 3, std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    for (const char* const formula : {"\\frac{@}{@}", "x^{@}", "@\\,\\mathrm{m}", "\\tfrac12 \\cdot @^2"}) {
      const auto marks = static_cast<size_t>(std::count(formula, formula + std::strlen(formula), '@'));
      const std::vector<course::Value> values(marks, course::Value(value));
      const std::string latex = course::fill(std::string(marks, '@'), formula, values).latex;
      EXPECT_EQ(Markup(display_mathml(latex)).mistake(), "") << latex;
    }
}

}  // namespace
}  // namespace byhand::tests
