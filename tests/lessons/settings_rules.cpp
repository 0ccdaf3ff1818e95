// The rules that hold at every setting of a lesson: pages made by hand that break each of them, and their
// neighbours that do not.

#include "tests/lessons/settings/rules.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lessons/terminal/terminal_text.hpp"
#include "renderer/canvas.hpp"
#include "tests/lessons/settings/numbers.hpp"
#include "tests/lessons/settings/pictures.hpp"

namespace byhand::tests {
namespace {

using namespace byhand::course;
using renderer::Chart;
using renderer::Curve;
using renderer::CurveStyle;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double infinity = std::numeric_limits<double>::infinity(),
                 nan = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string> broken(const std::vector<Finding>& findings) {
  std::vector<std::string> rules;
  for (const Finding& finding : findings) rules.push_back(finding.rule);
  return rules;
}
auto broken_by(const std::string& words) { return broken(broken_rules(words)); }
auto broken_by(const Page& page) { return broken(broken_rules(page)); }

TEST(Numbers, AreReadAsLessonsPrintThem) {
  for (const double value : {0.2, 1234.0, 1e9, 2.5e9, 1e-11, 9.9e-12, 4.821e-140, 1e300, 123456.0}) {
    const auto all = numbers("is " + number(-value) + " m²");
    ASSERT_EQ(all.size(), 1u) << value;
    EXPECT_NEAR(all[0].magnitude, std::log10(value), 1e-4);
    EXPECT_EQ(numbers(typed(value))[0].magnitude, std::log10(value)) << typed(value);
  }
  EXPECT_THAT(numbers("P₁, r1 and λ² of (the) chain_2"), IsEmpty());
  EXPECT_EQ(numbers("1, 2/3 and 10⁻²·5").size(), 5u);
  EXPECT_EQ(without_numbers("1.5·10⁻¹² m in 60 steps of r1"), "# m in # steps of r1");
}

TEST(Rules, ANumberIsFinite) {
  EXPECT_THAT(broken_by(say("The bob is at @ m.", nan)), ElementsAre("not a finite number"));
  EXPECT_THAT(broken_by(say("It takes @ sweeps.", infinity)), ElementsAre("not a finite number"));
  EXPECT_THAT(broken_by(say("It falls to @ m.", -infinity)), ElementsAre("not a finite number"));
  EXPECT_THAT(broken_by("λ lies in the interval from 0 to ∞, or from −∞ to ∞."), IsEmpty());
  EXPECT_THAT(broken_by("It rises from 2 to ∞."), ElementsAre("not a finite number"));
}

TEST(Rules, ANumberIsNeitherAbove1e9NorBelow1eMinus11) {
  EXPECT_THAT(broken_by(say("The energy is @ J.", 1.001e9)), ElementsAre("a number above 10⁹"));
  EXPECT_THAT(broken_by(say("The energy is @ J.", -4e140)), ElementsAre("a number above 10⁹"));
  EXPECT_THAT(broken_by("1234567890123 sweeps"), ElementsAre("a number above 10⁹"));
  EXPECT_THAT(broken_by(say("The energy is @ J.", 1e9)), IsEmpty());
  const char* const small = "a number below 10⁻¹¹ that is not said to be rounding";
  EXPECT_THAT(broken_by(say("@ is left.", 9.9e-12)), ElementsAre(small));
  EXPECT_THAT(broken_by(say("@ is left.", -4.821e-140)), ElementsAre(small));
  EXPECT_THAT(broken_by(say("@ is left.", 1e-11)), IsEmpty());
  EXPECT_THAT(broken_by(say("@ is left.", 0)), IsEmpty());
}

TEST(Rules, ANumberAsSmallAsRoundingIsCalledRounding) {
  EXPECT_THAT(broken_by(say("@ is left, which is rounding.", 3e-17)), IsEmpty());
  EXPECT_THAT(broken_by(say("@ is left by its surroundings.", 3e-17)), testing::SizeIs(1));
  EXPECT_THAT(broken_by(say("@ is left, which is rounding.", 4.8e-140)),
              ElementsAre("a number below 10⁻³⁰, too small for rounding"));
}

TEST(Rules, ANumberThatTheReaderSetMayHaveAnySize) {
  EXPECT_THAT(broken_rules("You asked for 1e-14 m.", {"1e-14"}), IsEmpty());
  EXPECT_THAT(broken_rules("You asked for 10⁻¹⁴ m.", {"0.5", "1e-14"}), IsEmpty());
  EXPECT_THAT(broken_rules("You asked for 1e-14 m.", {"1e-13"}), testing::SizeIs(1));
}

TEST(Rules, OneIsNotMany) {
  for (const char* words : {"A stack of 1 boxes.", "1 warm sweeps a step", "after **1** sweeps", "Only 1 links.",
                            "1 times as heavy", "it is 1 steps."})
    EXPECT_THAT(broken_by(words), ElementsAre("one of many")) << words;
  for (const char* words : {"1 box", "11 boxes", "0.1 seconds", "1/60 seconds", "10⁻¹ steps", "2·1 rows",
                            "1 warm sweep", "n − 1 boxes of", "body 1 has two rods", "step 1 and boxes",
                            "β = 1 leaves links", "1 s", "1 mass", "−1 degrees", "1. Boxes"})
    EXPECT_THAT(broken_by(words),
                testing::Conditional(std::string(words).starts_with("n −"), ElementsAre("one of many"), IsEmpty()))
        << words;
}

Page with(Item item) {
  Page page;
  page.items().push_back(std::move(item));
  return page;
}

TEST(Rules, HoldForAllThatAPageSays) {
  const std::string bad = say("@ m", 1e12);
  const std::vector<Item> items = {
      Text{"Fine.\n\n" + bad},
      Equation{0, {bad, ""}},
      course::Table{{"a"}, {{"1"}, {bad}}},
      Derivation{"Why", {{"by (4)", bad, ""}}},
      Measure{"energy", 1e12, "J"},
      Figure{"name", bad, Drawing()},
      Sequence{"name", bad, Frames{1}, {}},
      Prediction{.ask = bad, .answer = 1},
      Prediction{.ask = "How many?", .answer = 1e12},
      Prediction{.ask = "How many?", .answer = 1, .hints = {"Look.", bad}},
      Prediction{.ask = "How many?", .answer = 1, .right = bad},
      Prediction{.ask = "How many?", .answer = 1, .wrong = {{1e12, "No."}}},
      Prediction{.ask = "How many?", .answer = 1, .wrong = {{2, bad}}},
      Choice{.ask = bad, .options = {{"a", ""}}},
      Choice{.ask = "Which?", .options = {{"a", ""}, {bad, ""}}},
      Choice{.ask = "Which?", .options = {{"a", ""}, {"b", bad}}},
      Choice{.ask = "Which?", .options = {{"a", ""}, {"b", ""}}, .hints = {bad}},
      Claim{.quantity = bad, .source = "s"},
      Claim{.quantity = "q", .expected = 1e12, .source = "s", .measured = 1e12},
  };
  for (const Item& item : items) {
    EXPECT_THAT(broken_by(with(item)), testing::Not(IsEmpty())) << item.index();
    EXPECT_THAT(broken_by(with(item)), testing::Each("a number above 10⁹")) << item.index();
  }
  EXPECT_THAT(broken_by(with(Text{"1 m"})), IsEmpty());
}

Claim claim(double expected, double measured, Tolerance tolerance) {
  return {.quantity = "q",
          .unit = "m",
          .expected = expected,
          .source = "s",
          .measured = measured,
          .tolerance = tolerance};
}

TEST(Rules, AClaimHoldsWhereItIsClaimed) {
  EXPECT_THAT(broken_by(with(claim(1, 1.2, absolute(0.1)))), ElementsAre("a claim is false"));
  EXPECT_THAT(broken_by(with(claim(1, 1.05, absolute(0.1)))), IsEmpty());
  Claim outside = claim(1, 1.2, absolute(0.1));
  outside.range = {false, "β < 2"};
  EXPECT_THAT(broken_by(with(outside)), IsEmpty());
}

TEST(Rules, AClaimAllowsLessThanItClaims) {
  EXPECT_THAT(broken_by(with(claim(1, 1, relative(27.3)))), ElementsAre("a claim allows as much as it claims"));
  EXPECT_THAT(broken_by(with(claim(1, 1, relative(0.99)))), IsEmpty());
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
  EXPECT_THAT(broken_by(with(claim(0, -4.8e-140, absolute(0.001)))), IsEmpty());
  EXPECT_EQ(expectation(claim(8e-14, 9e-14, absolute(1e-9))), "0 ± 10⁻⁹ m");
  EXPECT_EQ(measurement(claim(8e-14, 9e-14, absolute(1e-9))), "9·10⁻¹⁴ m (rounding)");
  EXPECT_EQ(expectation(claim(8e-14, 9e-14, absolute(1e-15))), "8·10⁻¹⁴ ± 10⁻¹⁵ m (rounding)");
  EXPECT_EQ(measurement(claim(0, 2e-11, absolute(0.001))), "2·10⁻¹¹ m");
  EXPECT_EQ(measurement(claim(5e-15, 2e-16, at_most())), "2·10⁻¹⁶ m (rounding)");
  EXPECT_EQ(measurement(claim(8e-20, 8e-20, relative(0.001))), "8·10⁻²⁰ m") << "what is expected is no rounding";
  EXPECT_THAT(broken_by(with(claim(8e-20, 8e-20, relative(0.001)))), testing::Not(IsEmpty()));
  EXPECT_THAT(broken_by(with(claim(0, 2e-16, absolute(1e-12)))), IsEmpty());
}

TEST(Claim, SaysNoMeaninglessNumberWhereNothingIsClaimed) {
  for (const double wild : {2e9, -2e140, 9e-12, nan, infinity}) {
    Claim outside = claim(wild, wild, absolute(1));
    EXPECT_NE(measurement(outside), "–") << "a claim shows what it measures";
    EXPECT_NE(expectation(outside), "–");
    outside.range = {false, "β < 2"};
    EXPECT_EQ(measurement(outside), "–") << wild;
    EXPECT_EQ(expectation(outside), "–") << wild;
    EXPECT_THAT(broken_by(with(outside)), IsEmpty());
  }
  Claim outside = claim(1, 0, absolute(0.1));
  outside.range.met = false;
  EXPECT_EQ(measurement(outside), "0 m");
  EXPECT_EQ(expectation(outside), "1 m") << "a tolerance is that of a claim";
}

TEST(Rules, TheAnswersOfAQuestionStayApart) {
  const auto question = [](double answer, double wrong, double tolerance) {
    return with(Prediction{
        .ask = "How far?", .answer = answer, .unit = "m", .tolerance = tolerance, .wrong = {{wrong, "No."}}});
  };
  EXPECT_THAT(broken_by(question(1, 1.00001, 1e-6)), ElementsAre("two answers are the same"))
      << "as they are printed";
  EXPECT_THAT(broken_by(question(1, 1.001, 1e-4)), IsEmpty());
  EXPECT_THAT(broken_by(question(0.003, 1, 0.02)), ElementsAre("zero is taken for the answer"));
  EXPECT_THAT(broken_by(question(0, 1, 0.02)), IsEmpty()) << "zero is the answer";
  EXPECT_THAT(broken_by(question(1.0 / 3, 1, 1e-20)), ElementsAre("the answer is refused as it is printed"));
  EXPECT_THAT(broken_by(question(1.0 / 3, 1, 1e-6)), IsEmpty());
  EXPECT_THAT(broken_by(with(Choice{.ask = "Which?", .options = {{"2 m", ""}, {"3 m", ""}, {"2 m", ""}}})),
              ElementsAre("two answers are the same"));
  EXPECT_THAT(broken_by(with(Choice{.ask = "Which?", .options = {{"2 m", ""}, {"3 m", ""}}})), IsEmpty());
}

Chart chart(std::vector<double> y, CurveStyle style = CurveStyle::line) {
  Curve curve;
  for (size_t i = 0; i < y.size(); ++i) curve.x.push_back(static_cast<double>(i));
  curve.y = std::move(y);
  curve.style = style;
  Chart made;
  made.curves = {curve};
  return made;
}
auto broken_by(const Chart& chart, const std::string& caption = "Caption.") {
  return broken(broken_rules(chart, caption));
}

TEST(Rules, AFigureShowsSomething) {
  EXPECT_THAT(broken_by(chart({})), ElementsAre("an empty figure"));
  EXPECT_THAT(broken_by(chart({nan, nan})), ElementsAre("an empty figure"));
  EXPECT_THAT(broken_by(chart({1})), ElementsAre("an empty figure")) << "a line needs two points";
  EXPECT_THAT(broken_by(chart({1}, CurveStyle::markers)), IsEmpty());
  EXPECT_THAT(broken_by(chart({0, 0, 0})), ElementsAre("an empty figure"));
  EXPECT_THAT(broken_by(chart({3, 3})), IsEmpty());
  EXPECT_THAT(broken_by(chart({3, infinity})), IsEmpty()) << "a cross says that the run failed";
  Chart logarithmic = chart({-1, 0, 2, -3});
  logarithmic.y.scale = renderer::Scale::logarithmic;
  EXPECT_THAT(broken_by(logarithmic), ElementsAre("an empty figure"));
  Chart bars;
  bars.bar_names = {"a", "b"};
  bars.bars = {{.values = {nan, nan}}};
  EXPECT_THAT(broken_by(bars), ElementsAre("an empty figure"));
  bars.bars[0].values[0] = 1;
  EXPECT_THAT(broken_by(bars), IsEmpty());
  Chart map;
  map.heat_map = renderer::HeatMap{.x = {0, 1}, .y = {0}, .values = {nan, nan}};
  EXPECT_THAT(broken_by(map), ElementsAre("an empty figure"));
  map.heat_map->values[1] = 1;
  EXPECT_THAT(broken_by(map), IsEmpty());
}

TEST(Rules, AFigureCanBeDrawn) {
  Chart reversed = chart({1, 2});
  reversed.y.range = {{2, 1}};
  EXPECT_THAT(broken_by(reversed), ElementsAre("a chart cannot be drawn"));
}

TEST(Rules, AFigureShowsMoreThanRounding) {
  const char* const rule = "a figure of rounding alone";
  EXPECT_THAT(broken_by(chart({1e-16, -3e-16, 0})), ElementsAre(rule));
  EXPECT_THAT(broken_by(chart({9.81, 9.81 + 4e-15})), ElementsAre(rule)) << "the axis would show the last digit";
  EXPECT_THAT(broken_by(chart({9.81, 9.81 + 1e-9})), IsEmpty());
  EXPECT_THAT(broken_by(chart({1e-16, 1})), IsEmpty());
  EXPECT_THAT(broken_by(chart({1e-16, -3e-16, 0}), "What rounding leaves."), IsEmpty());
  Chart ranged = chart({9.81, 9.81 + 4e-15});
  ranged.y.range = {{0, 10}};
  EXPECT_THAT(broken_by(ranged), IsEmpty()) << "a straight line";
}

TEST(Rules, APictureIsNotBlank) {
  PictureDrawer pictures(small_quality);
  const auto blank = [&](Item item) { return broken(blank_pictures(with(std::move(item)), pictures)); };
  const Drawing nothing = [](renderer::Canvas&) {};
  const Drawing disc = [](renderer::Canvas& canvas) { canvas.disc(canvas.page().centre(), 100); };
  const Drawing far_away = [](renderer::Canvas& canvas) { canvas.disc({1e6, 0}, 100); };
  EXPECT_THAT(blank(Figure{"name", "Caption.", nothing}), ElementsAre("a blank picture"));
  EXPECT_THAT(blank(Figure{"name", "Caption.", far_away}), ElementsAre("a blank picture"));
  EXPECT_THAT(blank(Figure{"name", "Caption.", disc}), IsEmpty());
  const auto until = [&](double end) {
    return Sequence{"name", "Caption.", Seconds{2}, [=](renderer::Canvas& canvas, double time) {
                      if (time < end) disc(canvas);
                    }};
  };
  EXPECT_THAT(blank(until(3)), IsEmpty());
  EXPECT_THAT(blank(until(2)), ElementsAre("a blank picture")) << "the last frame";
}

TEST(Rules, HoldForChartsOnAPage) {
  EXPECT_THAT(broken_by(with(Figure{"name", "Caption.", chart({nan})})), ElementsAre("an empty figure"));
  Chart labelled = chart({1, 2});
  labelled.references = {{.value = 1, .label = say("k = @", infinity)}};
  EXPECT_THAT(broken_by(with(Figure{"name", "Caption.", labelled})), ElementsAre("not a finite number"));
}

}  // namespace
}  // namespace byhand::tests
