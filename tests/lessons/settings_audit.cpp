// Each rule of the settings finds a page that breaks it and passes its neighbour, and the audit finds the setting
// at which a lesson breaks one: without this a rule that finds nothing would look like a course without faults.

#include "tests/lessons/settings/audit.hpp"
#include "tests/lessons/settings/frame.hpp"
#include "tests/lessons/settings/judgements.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "lessons/page/typed_quantity.hpp"
#include "renderer/canvas.hpp"
#include "tests/lessons/settings/numbers.hpp"
#include "tests/lessons/settings/pictures.hpp"

namespace byhand::tests {
namespace {

using namespace byhand::course;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr double infinity = HUGE_VAL;
const double nan = std::nan("");

Page with(Item item) {
  Page page;
  page.items().push_back(std::move(item));
  return page;
}
std::vector<std::string> broken_by(const Page& page, const std::vector<std::string>& given = {}) {
  std::vector<std::string> rules;
  for (const Finding& finding : broken_rules(page, given)) rules.push_back(finding.rule);
  return rules;
}

Claim claim(double measured, Tolerance tolerance, bool claimed = true) {
  return {.quantity = "q",
          .unit = "m",
          .expected = 1,
          .source = "s",
          .measured = measured,
          .tolerance = tolerance,
          .range = {claimed, "β < 2"}};
}

Item question(double answer, double wrong, double tolerance) {
  return Prediction{
      .ask = "How far?", .answer = answer, .unit = "m", .tolerance = tolerance, .wrong = {{wrong, "No."}}};
}
Item hinted(std::string hint, double answer, double gives = nan) {
  return Prediction{.ask = "How far?",
                    .answer = answer,
                    .tolerance = 0.01,
                    .hints = {"Look.", std::move(hint)},
                    .hinted = gives};
}
Item choice(std::string first, std::string second) {
  return Choice{.ask = "Which?", .options = {{std::move(first), "Yes."}, {std::move(second), "No."}}};
}

renderer::Chart chart(std::vector<double> y, renderer::CurveStyle style = renderer::CurveStyle::line) {
  renderer::Curve curve{.y = std::move(y), .style = style};
  for (size_t i = 0; i < curve.y.size(); ++i) curve.x.push_back(static_cast<double>(i));
  renderer::Chart made;
  made.curves = {curve};
  return made;
}
Item figure(const renderer::Chart& shown, const std::string& caption = "Caption.") {
  return Figure{"name", caption, shown};
}
Item logarithmic(std::vector<double> y) {
  renderer::Chart made = chart(std::move(y));
  made.y.scale = renderer::Scale::logarithmic;
  return figure(made);
}
Item ranged(std::vector<double> y, double low, double high) {
  renderer::Chart made = chart(std::move(y));
  made.y.range = {{low, high}};
  return figure(made);
}
Item bars(double value) {
  renderer::Chart made;
  made.bar_names = {"a", "b"};
  made.bars = {{.values = {nan, value}}};
  return figure(made);
}
Item map(double value) {
  renderer::Chart made;
  made.heat_map = renderer::HeatMap{.x = {0, 1}, .y = {0}, .values = {nan, value}};
  return figure(made);
}

TEST(Rules, FindWhatBreaksThemAndPassItsNeighbour) {
  const std::string finite = "not a finite number", large = "a number above 10⁹",
                    small = "a number below 10⁻¹¹ that is not said to be rounding", many = "one of many",
                    empty = "an empty figure", rounding = "a figure of rounding alone",
                    same = "two answers are the same";
  struct Case {
    std::string rule;
    Item broken, sound;
  };
  const std::vector<Case> cases = {
      {finite, Text{say("The bob is at @ m.", nan)}, Text{"The bob is at 1 m."}},
      {finite, Text{say("It falls to @ m.", -infinity)}, Text{"The interval from −∞ to ∞."}},
      {finite, Text{"It rises from 2 to ∞."}, Text{"λ lies in the interval from 0 to ∞."}},
      {large, Text{say("The energy is @ J.", 1.001e9)}, Text{say("The energy is @ J.", 1e9)}},
      {large, Text{say("The energy is @ J.", -4e140)}, Text{"123456789 sweeps"}},
      {small, Text{say("@ is left.", 9.9e-12)}, Text{say("@ is left.", 1e-11)}},
      {small, Text{say("@ is left by its surroundings.", 3e-17)},
       Text{say("@ is left, which is rounding.", 3e-17)}},
      {"a number below 10⁻³⁰, too small for rounding", Text{say("@ is left, which is rounding.", 4.8e-140)},
       Text{say("@ is left.", 0)}},
      {many, Text{"A stack of 1 boxes."}, Text{"11 boxes, 0.1 seconds, 1/60 seconds, 10⁻¹ steps, 2·1 rows"}},
      {many, Text{"1 warm sweeps a step"}, Text{"1 warm sweep, body 1 has two rods, step 1 and boxes"}},
      {many, Text{"after **1** sweeps"}, Text{"β = 1 leaves links, −1 degrees, 1. Boxes"}},
      {many, Text{"Only 1 links."}, Text{"1 mass, 1 s"}},
      {"a claim is false", claim(1.2, absolute(0.1)), claim(1.05, absolute(0.1))},
      {"a claim is false", claim(1.2, absolute(0.1)), claim(1.2, absolute(0.1), false)},
      {"a claim allows as much as it claims", claim(1, relative(27.3)), claim(1, relative(0.99))},
      {same, question(1, 1.00001, 1e-6), question(1, 1.001, 1e-4)},  // as they are printed
      {same, choice("2 m", "2 m"), choice("2 m", "3 m")},
      {"zero is taken for the answer", question(0.003, 1, 0.02), question(0, 1, 0.02)},
      {"the answer is refused as it is printed", question(1.0 / 3, 1, 1e-20), question(1.0 / 3, 1, 1e-6)},
      {"what the last hint gives is refused", hinted("½(2.1² − 2²) = …", 0.3), hinted("½(2.1² − 2²) = …", 0.205)},
      {"what the last hint gives is refused", hinted("C is βC/β: 2.5/0.1 = …", 24),
       hinted("Look: 2.4/0.1 = …", 24)},
      {"nothing says what the last hint gives", hinted("Look at the sign.", 1), hinted("Look at the sign.", 1, 1)},
      {"what the last hint gives is not the answer", hinted("m grows.", 1, 2), hinted("m grows.", 1, 1.2)},
      {"two options have one reply", Choice{.ask = "Settles?", .options = {{"yes", "It is."}, {"no", "It is."}}},
       choice("yes", "no")},
      {empty, figure(chart({})), figure(chart({3, 3}))},
      {empty, figure(chart({nan, nan})), figure(chart({3, infinity}))},  // a cross says that the run failed
      {empty, figure(chart({1})), figure(chart({1}, renderer::CurveStyle::markers))},  // a line needs two points
      {empty, logarithmic({-1, 0, 2, -3}), logarithmic({-1, 1, 2, -3})},
      {empty, bars(nan), bars(1)},
      {empty, map(nan), map(1)},
      {"a chart cannot be drawn", ranged({1, 2}, 2, 1), ranged({1, 2}, 1, 2)},
      {rounding, figure(chart({1e-16, -3e-16, 0})), figure(chart({1e-16, -3e-16, 0}), "What rounding leaves.")},
      {rounding, figure(chart({9.81, 9.81 + 4e-15})), figure(chart({9.81, 9.81 + 1e-9}))},
      {rounding, figure(chart({9.81, 9.81 + 4e-15})), ranged({9.81, 9.81 + 4e-15}, 0, 10)},  // a straight line
  };
  for (const Case& one : cases) {
    const auto at = &one - cases.data();
    EXPECT_THAT(broken_by(with(one.broken)), ElementsAre(one.rule)) << "case " << at;
    EXPECT_THAT(broken_by(with(one.sound)), IsEmpty()) << "case " << at << ", " << one.rule;
  }
  EXPECT_THAT(broken_by(with(Text{"You asked for 10⁻¹⁴ m."}), {"0.5", "1e-14"}), IsEmpty());
  EXPECT_THAT(broken_by(with(Text{"You asked for 1e-14 m."}), {"1e-13"}), SizeIs(1));
}

TEST(Rules, HoldForAllThatAPageSays) {
  const std::string bad = say("@ m", 1e12);
  renderer::Chart labelled = chart({1, 2});
  labelled.references = {{.value = 1, .label = bad}};
  const std::vector<Item> items = {
      Text{"Fine.\n\n" + bad},
      Equation{0, {bad, ""}},
      course::Table{{"a"}, {{"1"}, {bad}}},
      Derivation{"Why", {{"by (4)", bad, ""}}},
      Measure{"energy", 1e12, "J"},
      Figure{"name", bad, Drawing()},
      figure(labelled),
      Sequence{"name", bad, Frames{1}, {}},
      Prediction{.ask = bad, .answer = 1},
      Prediction{.ask = "How many?", .answer = 1e12},
      Prediction{.ask = "How many?", .answer = 1, .hints = {"Look.", bad}, .hinted = 1},
      Prediction{.ask = "How many?", .answer = 1, .right = bad},
      Prediction{.ask = "How many?", .answer = 1, .wrong = {{1e12, "No."}}},
      Prediction{.ask = "How many?", .answer = 1, .wrong = {{2, bad}}},
      Choice{.ask = bad, .options = {{"a", ""}}},
      Choice{.ask = "Which?", .options = {{"a", ""}, {bad, "No."}}},
      Choice{.ask = "Which?", .options = {{"a", ""}, {"b", bad}}},
      Choice{.ask = "Which?", .options = {{"a", ""}, {"b", "No."}}, .hints = {bad}},
      Claim{.quantity = bad, .source = "s"},
      Claim{.quantity = "q", .expected = 1e12, .source = "s", .measured = 1e12},
  };
  for (const Item& item : items) {
    EXPECT_THAT(broken_by(with(item)), testing::Not(IsEmpty())) << item.index();
    EXPECT_THAT(broken_by(with(item)), testing::Each("a number above 10⁹")) << item.index();
  }
}

TEST(Rules, AQuestionComesBeforeItsAnswer) {
  const Item ask = question(0.4905, 2, 0.01), says_it = Text{"It is 0.4905 m."}, other = Text{"It is 0.52 m."};
  const auto rules = [&](std::vector<Item> items, const std::vector<std::string>& given = {}) {
    Page page;
    page.items() = std::move(items);
    return broken_by(page, given);
  };
  const std::string above = "the answer is above its question", below = "the answer is right below its question";
  EXPECT_THAT(rules({says_it, other, ask}), ElementsAre(above));
  EXPECT_THAT(rules({claim(0.4905, absolute(1)), ask}), testing::Contains(above));
  EXPECT_THAT(rules({ask, says_it}), ElementsAre(below));
  EXPECT_THAT(rules({other, ask, other, says_it}), IsEmpty());
  EXPECT_THAT(rules({says_it, ask}, {"0.4905"}), IsEmpty()) << "the reader's own number";
  EXPECT_THAT(rules({Text{"It is 2.5 m."}, question(2.5, 7, 0.01)}), IsEmpty()) << "too few digits to tell";
}

TEST(Rules, AFilmBeginsWithABody) {
  const auto film = [](double begin) {
    return out_of_frame(with(Sequence{"name", "Caption.", Seconds{2}, [=](renderer::Canvas& canvas, double time) {
                                        if (time >= begin) canvas.disc(canvas.page().centre(), 30);
                                      }}));
  };
  EXPECT_THAT(film(0), IsEmpty());
  ASSERT_THAT(film(0.5), SizeIs(1));
  EXPECT_EQ(film(0.5)[0].rule, "a film begins without a body");
}

TEST(Rules, APictureIsNotBlank) {
  PictureDrawer pictures(small_quality);
  const auto blanks = [&](Item item) { return blank_pictures(with(std::move(item)), pictures).size(); };
  const Drawing disc = [](renderer::Canvas& canvas) { canvas.disc(canvas.page().centre(), 100); };
  EXPECT_EQ(blanks(Figure{"name", "Caption.", [](renderer::Canvas& canvas) { canvas.disc({1e6, 0}, 100); }}), 1U);
  EXPECT_EQ(blanks(Figure{"name", "Caption.", disc}), 0U);
  const auto until = [&](double end) {
    return Sequence{"name", "Caption.", Seconds{2}, [=](renderer::Canvas& canvas, double time) {
                      if (time < end) disc(canvas);
                    }};
  };
  EXPECT_EQ(blanks(until(3)), 0U);
  EXPECT_EQ(blanks(until(2)), 1U) << "the last frame";
}

TEST(Rules, AFrameHoldsWhatItShows) {
  const auto broken = [](const Drawing& draw) {
    std::vector<std::string> rules;
    for (const Finding& finding : out_of_frame(draw, "film: Caption.")) rules.push_back(finding.rule);
    return rules;
  };
  const auto disc_at = [](double x, bool clipped) {
    return [=](renderer::Canvas& canvas) {
      if (clipped) canvas.clip(renderer::Rectangle{100, 100, 400, 300});
      canvas.disc({x, 250}, 30);
    };
  };
  EXPECT_THAT(broken(disc_at(300, true)), IsEmpty());
  EXPECT_THAT(broken(disc_at(480, true)), ElementsAre("a body leaves its frame"));
  EXPECT_THAT(broken(disc_at(480, false)), IsEmpty());
  EXPECT_THAT(broken(disc_at(1270, false)), ElementsAre("a body leaves its frame"));
  const auto words_at = [](double x, double y) {
    return [=](renderer::Canvas& canvas) {
      canvas.text({640, 300}, "first label");
      canvas.text({x, y}, "second label");
    };
  };
  EXPECT_THAT(broken(words_at(640, 330)), IsEmpty());
  EXPECT_THAT(broken(words_at(660, 305)), ElementsAre("a label covers another"));
  EXPECT_THAT(broken(words_at(1270, 100)), ElementsAre("a label leaves the page"));
}

TEST(Rules, AJudgementIsAVerdict) {
  const auto judged = [](const std::string& words, const std::vector<std::string>& given = {}) {
    return unclaimed_judgements(with(Text{words}), given).size();
  };
  EXPECT_EQ(judged("The stack stands for 20.5 s."), 1U);
  EXPECT_EQ(judged("It is down after 9.3 s."), 1U);
  EXPECT_EQ(judged("The error is about 3 times as large, 8.25 m."), 1U);
  EXPECT_EQ(judged("The stack moves by 20.5 mm."), 0U) << "a number without a judgement";
  EXPECT_EQ(judged("A stack at rest stands still."), 0U) << "a judgement of no number";
  EXPECT_EQ(judged("It stands for 20.5 s.", {"20.5"}), 0U) << "the reader's own number";
  EXPECT_EQ(judged("It stands by (17), as step 12 says."), 0U);
  Page page;
  page.text("@", page.verdict({{.when = Quantity("t", 20.5) > 20, .say = "The stack stands for 20.5 s."}}));
  EXPECT_THAT(unclaimed_judgements(page, {}), IsEmpty());
}

TEST(Settings, NumbersAreReadAsLessonsPrintThem) {
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

TEST(Settings, AnyValueIsSpreadOverItsRange) {
  const auto counts = [](const ParameterRecord& parameter, const std::vector<double>& ends) {
    std::mt19937 random(7);
    std::vector<int> all(ends.size() - 1);
    for (int i = 0; i < 2000; ++i) {
      const double value = read_number(any_value(parameter, random));
      const auto above = std::upper_bound(ends.begin(), ends.end(), value);
      if (above != ends.begin() && above != ends.end()) ++all[static_cast<size_t>(above - ends.begin() - 1)];
    }
    return all;
  };
  const auto about = [](int count) {
    return testing::AllOf(testing::Gt(count - 0.2 * count - 50), testing::Lt(count + 0.2 * count + 50));
  };
  const double beyond = 1.0000001;
  EXPECT_THAT(counts({.name = "x", .range = {-1, 1}}, {-1, 0, beyond}), ElementsAre(about(1000), about(1000)));
  EXPECT_THAT(counts({.name = "x", .range = {1e-4, 1}}, {1e-4, 1e-3, 1e-2, 1e-1, beyond}),
              testing::Each(about(500)));
  EXPECT_THAT(counts({.name = "x", .range = {0, 1}}, {0, 1e-7, 1e-3, beyond}),
              ElementsAre(about(500), about(250), about(1250)));
  EXPECT_THAT(counts({.name = "x", .range = {1, 3}, .integer = true}, {1, 2, 3, 4}),
              testing::Each(testing::Gt(0)));
  EXPECT_THAT(ends({.name = "scene", .choices = {"chain", "stack", "top"}}), ElementsAre("chain", "stack", "top"));
}

/// A lesson with a, b and c from 0 to 1, of which only the step that is given looks at a and b.
struct Knobs {
  Lesson lesson{{.slug = "98_knobs", .title = "Knobs", .summary = "Turned."}};
  Parameter<double> a = lesson.parameter("a", 0.5, "1", {0, 1}, "one");
  Parameter<double> b = lesson.parameter("b", 0.5, "1", {0, 1}, "another");
  Parameter<double> c = lesson.parameter("c", 0.5, "1", {0, 1}, "of another step");
  int other_runs = 0;

  explicit Knobs(const std::function<double(double a, double b)>& size) {
    lesson.step("All", [=, this](Page& page) { page.text("It is @.", size(a, b)); });
    lesson.step("Other", [this](Page& page) {
      ++other_runs;
      page.text("c = @", c);
    });
  }
  std::vector<Failure> failures(const Extent& extent) { return Audit(lesson, extent).failures(); }
};

TEST(Audit, FindsTheSettingAtWhichALessonIsWrongAndGivesItsCommand) {
  struct Case {
    std::function<bool(double a, double b)> wrong;
    Extent extent;
    std::string setting;
    int settings = 1;
  };
  const Suggestion quarter = suggestion("./lessons/run 98 --step 1 --set a=0.25");
  const std::vector<Case> cases = {
      {[](double a, double) { return a == 1; }, {.random = 0}, " --set a=1", 3},  // alone, beside both ends of b
      {[](double a, double b) { return a == 1 && b == 0; }, {.random = 0}, " --set a=1 --set b=0"},
      {[](double a, double) { return a == 1; }, {.random = 0, .step = "1", .pairs = false}, " --set a=1"},
      {[](double a, double) { return a == 0.25; },
       {.random = 0, .seconds = 0, .also = {quarter}},
       " --set a=0.25"},
  };
  for (const Case& one : cases) {
    Knobs knobs([&](double a, double b) { return one.wrong(a, b) ? 1e12 : a + b; });
    const auto failures = knobs.failures(one.extent);
    ASSERT_THAT(failures, SizeIs(1)) << one.setting;
    EXPECT_EQ(failures[0].command, "./lessons/run 98 --step 1" + one.setting);
    EXPECT_EQ(failures[0].finding.words, "It is 10¹².");
    EXPECT_EQ(failures[0].settings, one.settings) << one.setting;
    EXPECT_EQ(knobs.other_runs > 0, one.extent.step.empty());
  }
}

TEST(Audit, TriesWhatALessonSuggests) {
  Knobs knobs([](double a, double b) { return a == 0.25 ? 1e12 : a + b; });
  knobs.lesson.closing(
      {.tries = {{"A quarter.", "./lessons/run 98 --step 1 --set a=1/4"}, {"", "./lessons/run 4"}}});
  const auto failures = knobs.failures({.random = 0});
  ASSERT_THAT(failures, SizeIs(1));
  EXPECT_EQ(failures[0].command, "./lessons/run 98 --step 1 --set a=1/4");
}

TEST(Audit, ASeedRepeatsItsRandomSettings) {
  const auto command = [](unsigned seed) {
    Knobs knobs([](double a, double b) { return a > 0.6 && a < 0.9 && b < 0.4 ? 1e12 : a + b; });
    const auto failures = knobs.failures({.random = 50, .seed = seed});
    return failures.size() == 1 ? failures[0].command : "";
  };
  EXPECT_NE(command(1), "");
  EXPECT_EQ(command(1), command(1));
  EXPECT_NE(command(1), command(2));
}

TEST(Audit, FindsAStepThatThrowsAndAParameterThatChangesNothing) {
  Knobs throws([](double a, double b) { return a == 1 ? throw std::runtime_error("a body is nowhere") : a + b; });
  const auto thrown = throws.failures({.random = 0});
  ASSERT_THAT(thrown, SizeIs(1));
  EXPECT_EQ(thrown[0].finding.rule, "exit status");
  EXPECT_EQ(thrown[0].finding.words, "a body is nowhere");
  Knobs unused([](double a, double) { return a; });
  const auto nowhere = unused.failures({.random = 0});
  ASSERT_THAT(nowhere, SizeIs(1));
  EXPECT_EQ(nowhere[0].finding.rule, "no step says anything else");
  EXPECT_EQ(nowhere[0].command, "./lessons/run 98 --set b=0");
}

TEST(Audit, RunsAStepOnceForEachSettingThatChangesIt) {
  Knobs knobs([](double a, double b) { return a + b; });
  const Audit audit(knobs.lesson, {.random = 10});
  EXPECT_THAT(audit.failures(), IsEmpty());
  EXPECT_THAT(audit.left_out(), IsEmpty());
  EXPECT_EQ(knobs.other_runs, 1 + 6 + 9) << "the base, six ends, and ten random settings, one of which is an end";
  Knobs based([](double a, double b) {
    EXPECT_TRUE(a == 0.125 || a == 0 || a == 1) << a << " is random";
    return a + b;
  });
  EXPECT_THAT(based.failures({.random = 20, .base = {{"a", "0.125"}}}), IsEmpty());
}

TEST(Audit, FindsAParameterThatAnotherStepLooksAtToo) {
  const auto failures = [](bool truly) {
    Lesson lesson({.slug = "98_answers", .title = "Answers", .summary = "One step answers."});
    const auto a = lesson.parameter("a", 0.5, "1", {0, 1}, "of the second step");
    lesson.step("First", [=](Page& page) { page.text("It is @.", truly ? 1 : a()); });
    lesson.step("Second", [=](Page& page) { page.text("It is @.", a); });
    lesson.answers({"a"});
    return Audit(lesson, {.random = 0}).failures();
  };
  EXPECT_THAT(failures(true), IsEmpty());
  ASSERT_THAT(failures(false), SizeIs(1));
  EXPECT_EQ(failures(false)[0].finding.rule, "answers() gives its parameter to another step");
}

TEST(Audit, CountsWhatItLeavesOut) {
  Knobs slow([](double a, double b) { return a + b; }),
      beyond([](double a, double b) { return a == 1 ? 1e12 : a + b; });
  EXPECT_THAT(Audit(slow.lesson, {.random = 10, .seconds = 0}).left_out(), SizeIs(2));
  const Audit audit(beyond.lesson, {.random = 0, .pairs = false, .beyond = {{"a", "1"}}});
  EXPECT_THAT(audit.failures(), IsEmpty());
  EXPECT_THAT(audit.left_out(), testing::Contains("step 1 at 6 of 7 settings, for want of time"));
}

}  // namespace
}  // namespace byhand::tests
