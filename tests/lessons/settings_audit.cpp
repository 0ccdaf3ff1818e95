// Which settings are tried, and that a lesson which goes wrong at one of them is caught with the command that
// shows it.

#include "tests/lessons/settings/audit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ctime>
#include <stdexcept>

#include "lessons/page/typed_quantity.hpp"

namespace byhand::tests {
namespace {

using namespace byhand::course;
using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::Field;
using testing::Ge;
using testing::IsEmpty;
using testing::Le;
using testing::SizeIs;

TEST(Suggestions, AreTheSettingsOfTheCommands) {
  const auto all = suggestions(
      {.tries = {{"One.", "./lessons/run 4 --step 6b --set sweeps=8 --set h=1/120"}, {"", "./lessons/run 4"}}});
  ASSERT_THAT(all, SizeIs(2));
  EXPECT_EQ(all[0].step, "6b");
  EXPECT_EQ(options(all[0].setting), " --set sweeps=8 --set h=1/120");
  EXPECT_EQ(all[1].step, "");
  EXPECT_THAT(all[1].setting, IsEmpty());
}

std::vector<double> many_values(const ParameterRecord& parameter) {
  std::mt19937 random(7);
  std::vector<double> values;
  for (int i = 0; i < 2000; ++i) values.push_back(read_number(any_value(parameter, random)));
  return values;
}

int count(const std::vector<double>& values, double low, double high) {
  return static_cast<int>(
      std::count_if(values.begin(), values.end(), [&](double v) { return low <= v && v < high; }));
}

TEST(AnyValue, IsInRangeAndSpreadOverIt) {
  const auto uniform = many_values({.name = "x", .range = {-1, 1}});
  EXPECT_THAT(uniform, Each(AllOf(Ge(-1), Le(1))));
  EXPECT_NEAR(count(uniform, -1, 0), 1000, 150);
  const auto decades = many_values({.name = "x", .range = {1e-4, 1}});
  EXPECT_THAT(decades, Each(AllOf(Ge(1e-4), Le(1))));
  for (const double low : {1e-4, 1e-3, 1e-2, 1e-1}) EXPECT_NEAR(count(decades, low, 10 * low), 500, 100) << low;
  const auto from_zero = many_values({.name = "x", .range = {0, 1}});
  EXPECT_NEAR(count(from_zero, 0, 1e-7), 500, 100);
  EXPECT_NEAR(count(from_zero, 1e-7, 1e-3), 250, 100);
  const auto whole = many_values({.name = "x", .range = {1, 3}, .integer = true});
  for (const double one : whole) EXPECT_EQ(one, std::round(one));
  EXPECT_GT(count(whole, 1, 2) * count(whole, 3, 4), 0) << "both ends";
}

TEST(AnyValue, IsOneOfTheChoices) {
  std::mt19937 random(7);
  std::set<std::string> values;
  const ParameterRecord scene{.name = "scene", .choices = {"chain", "stack", "top"}};
  for (int i = 0; i < 100; ++i) values.insert(any_value(scene, random));
  EXPECT_THAT(values, ElementsAre("chain", "stack", "top"));
  EXPECT_THAT(ends(scene), ElementsAre("chain", "stack", "top"));
}

/// A lesson with a, b and c from 0 to 1, of which only the step that is given looks at a and b.
struct Knobs {
  Lesson lesson{{.slug = "98_knobs", .title = "Knobs", .summary = "Turned."}};
  Parameter<double> a = lesson.parameter("a", 0.5, "1", {0, 1}, "one");
  Parameter<double> b = lesson.parameter("b", 0.5, "1", {0, 1}, "another");
  Parameter<double> c = lesson.parameter("c", 0.5, "1", {0, 1}, "of another step");
  int other_runs = 0;

  explicit Knobs(const std::function<void(Page&, double a, double b)>& step) {
    lesson.step("All", [=, this](Page& page) { step(page, a, b); });
    lesson.step("Other", [this](Page& page) {
      ++other_runs;
      page.text("c = @", c);
    });
  }
};

void say_size(Page& page, double size) { page.text("It is @.", size); }

TEST(Audit, FindsNothingInALessonThatIsTrueEverywhere) {
  Knobs knobs([](Page& page, double a, double b) { say_size(page, a + b); });
  const Audit audit(knobs.lesson, {.random = 20});
  EXPECT_THAT(audit.failures(), IsEmpty());
  EXPECT_THAT(audit.left_out(), IsEmpty());
}

TEST(Audit, CatchesAnEndAndGivesTheCommand) {
  Knobs knobs([](Page& page, double a, double b) { say_size(page, a == 1 ? 1e12 : a + b); });
  const auto failures = Audit(knobs.lesson, {.random = 0}).failures();
  ASSERT_THAT(failures, SizeIs(1));
  EXPECT_EQ(failures[0].step, "1");
  EXPECT_EQ(failures[0].command, "./lessons/run 98 --step 1 --set a=1");
  EXPECT_EQ(failures[0].finding.words, "It is 10¹².");
  EXPECT_EQ(failures[0].settings, 3) << "alone and beside both ends of b";
}

TEST(Audit, CatchesAPairOfEnds) {
  const auto step = [](Page& page, double a, double b) { say_size(page, a == 1 && b == 0 ? 1e12 : a + b); };
  Knobs knobs(step), quick(step);
  const auto failures = Audit(knobs.lesson, {.random = 0}).failures();
  ASSERT_THAT(failures, SizeIs(1));
  EXPECT_EQ(failures[0].command, "./lessons/run 98 --step 1 --set a=1 --set b=0");
  EXPECT_THAT(Audit(quick.lesson, {.random = 0, .pairs = false}).failures(), IsEmpty());
}

TEST(Audit, CatchesASuggestion) {
  Knobs knobs([](Page& page, double a, double) { say_size(page, a == 0.25 ? 1e12 : a); });
  knobs.lesson.closing({.tries = {{"A quarter.", "./lessons/run 98 --step 1 --set a=1/4"}}});
  const auto failures = Audit(knobs.lesson, {.random = 0}).failures();
  EXPECT_THAT(failures, Contains(Field(&Failure::command, "./lessons/run 98 --step 1 --set a=1/4")));
}

TEST(Audit, CatchesARandomSettingAndTheSeedRepeatsIt) {
  const auto commands = [](unsigned seed) {
    Knobs knobs(
        [](Page& page, double a, double b) { say_size(page, a > 0.6 && a < 0.9 && b < 0.4 ? 1e12 : a + b); });
    std::vector<std::string> all;
    const Audit audit(knobs.lesson, {.random = 50, .seed = seed});
    for (const Failure& failure : audit.failures()) all.push_back(failure.command);
    return all;
  };
  EXPECT_THAT(commands(1), SizeIs(1)) << "one sentence";
  EXPECT_EQ(commands(1), commands(1));
  EXPECT_NE(commands(1), commands(2));
}

TEST(Audit, CatchesAStepThatThrows) {
  Knobs knobs([](Page& page, double a, double) {
    if (a == 1) throw std::runtime_error("a body is nowhere");
    say_size(page, a);
  });
  const auto failures = Audit(knobs.lesson, {.random = 0}).failures();
  EXPECT_THAT(failures, Contains(Field(&Failure::finding, AllOf(Field(&Finding::rule, "exit status"),
                                                                Field(&Finding::words, "a body is nowhere")))));
}

TEST(Audit, CatchesAParameterThatNoStepLooksAt) {
  Knobs knobs([](Page& page, double a, double) { say_size(page, a); });
  const auto failures = Audit(knobs.lesson, {.random = 0}).failures();
  ASSERT_THAT(failures, SizeIs(1));
  EXPECT_EQ(failures[0].finding.rule, "no step says anything else");
  EXPECT_EQ(failures[0].command, "./lessons/run 98 --set b=0");
}

TEST(Audit, RunsAStepOnlyForParametersThatChangeIt) {
  Knobs knobs([](Page& page, double a, double b) { say_size(page, a + b); });
  Audit(knobs.lesson, {.random = 10});
  EXPECT_EQ(knobs.other_runs, 1 + 6 + 9) << "the base, six ends, and ten random settings, one of which is an end";
}

TEST(Audit, RunsTheStepThatIsAskedForAlone) {
  Knobs knobs([](Page& page, double a, double b) { say_size(page, a == 1 ? 1e12 : a + b); });
  EXPECT_THAT(Audit(knobs.lesson, {.random = 10, .step = "1"}).failures(), SizeIs(1));
  EXPECT_EQ(knobs.other_runs, 0);
}

TEST(Audit, CatchesAParameterThatAnotherStepLooksAtToo) {
  const auto failures = [](bool truly) {
    Lesson lesson({.slug = "98_answers", .title = "Answers", .summary = "One step answers."});
    const auto a = lesson.parameter("a", 0.5, "1", {0, 1}, "of the second step");
    lesson.step("First", [=](Page& page) { say_size(page, truly ? 1 : a()); });
    lesson.step("Second", [=](Page& page) { say_size(page, a); });
    lesson.answers({"a"});
    return Audit(lesson, {.random = 0}).failures();
  };
  EXPECT_THAT(failures(true), IsEmpty());
  ASSERT_THAT(failures(false), SizeIs(1));
  EXPECT_EQ(failures(false)[0].step, "1");
  EXPECT_EQ(failures(false)[0].finding.rule, "answers() gives its parameter to another step");
}

TEST(Audit, LeavesOutWhatTakesTooLongAndSaysSo) {
  Knobs knobs([](Page& page, double a, double b) { say_size(page, a + b); });
  const Audit audit(knobs.lesson, {.random = 10, .seconds = 0});
  EXPECT_THAT(audit.left_out(), SizeIs(2));
}

TEST(Audit, KeepsTimeForRandomSettings) {
  int random = 0;
  Knobs knobs([&](Page& page, double a, double b) {
    const std::clock_t begin = std::clock();
    while (std::clock() < begin + CLOCKS_PER_SEC / 50) continue;
    random += (a > 0 && a < 0.5) || (a > 0.5 && a < 1);
    say_size(page, a + b);
  });
  const Audit audit(knobs.lesson, {.random = 1000, .seconds = 0.06, .all_steps = false});
  EXPECT_GE(random, 1) << "the base and six ends take longer than all";
  EXPECT_THAT(audit.left_out(),
              ElementsAre(testing::MatchesRegex("step 1 at .* of .* settings, for want of time")));
}

TEST(Audit, TriesASettingOnce) {
  int runs = 0;
  Lesson lesson({.slug = "98_choices", .title = "Choices", .summary = "Three."});
  const auto choice = lesson.parameter("choice", "one", {"one", "two", "three"}, "of three");
  lesson.step("Only", [&, choice](Page& page) { page.text("It is @.", (++runs, choice())); });
  Audit(lesson, {.random = 50});
  EXPECT_EQ(runs, 4) << "the base and three choices";
}

TEST(Audit, TriesWhatIsAskedForWhateverTheTime) {
  Knobs knobs([](Page& page, double a, double) { say_size(page, a == 0.25 ? 1e12 : a); });
  const std::vector<Suggestion> also{suggestion("./lessons/run 98 --step 1 --set a=0.25")};
  const auto failures = Audit(knobs.lesson, {.random = 0, .seconds = 0, .also = also}).failures();
  EXPECT_THAT(failures, Contains(Field(&Failure::command, "./lessons/run 98 --step 1 --set a=0.25")));
}

TEST(Audit, LeavesOutAndCountsWhatIsBeyondItsTime) {
  Knobs knobs([](Page& page, double a, double b) { say_size(page, a == 1 ? 1e12 : a + b); });
  const Audit audit(knobs.lesson, {.random = 0, .pairs = false, .beyond = {{"a", "1"}}});
  EXPECT_THAT(audit.failures(), IsEmpty());
  EXPECT_THAT(audit.left_out(), Contains("step 1 at 6 of 7 settings, for want of time"));
}

TEST(Audit, KeepsTheBaseAtRandom) {
  Knobs knobs([](Page& page, double a, double b) {
    EXPECT_TRUE(a == 0.125 || a == 0 || a == 1) << a;
    say_size(page, a + b);
  });
  EXPECT_THAT(Audit(knobs.lesson, {.random = 20, .base = {{"a", "0.125"}}}).failures(), IsEmpty());
}

}  // namespace
}  // namespace byhand::tests
