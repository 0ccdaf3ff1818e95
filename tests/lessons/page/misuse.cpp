// A lesson that is written wrongly does not run: status 1 and a sentence that says what is wrong.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "lessons/page/lesson.hpp"

namespace byhand::tests {
namespace {

using namespace byhand::course;
using testing::HasSubstr;
using testing::IsEmpty;

Claim true_claim() { return {.quantity = "one", .expected = 1, .source = "arithmetic", .measured = 1}; }

struct Ran {
  int status;
  std::string complained;
};

/// Runs a lesson of one step with `--check`, or with whatever arguments are given.
Ran check(const StepFunction& step, std::vector<const char*> arguments = {"--check"}) {
  Lesson lesson({.slug = "98_wrong", .title = "Wrong", .summary = "A lesson to be refused."});
  lesson.parameter("size", 1.0, "1", {0, 10}, "of nothing");
  lesson.step("Only step", step);
  arguments.insert(arguments.begin(), "98_wrong");
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const int status = lesson.run(static_cast<int>(arguments.size()), arguments.data());
  testing::internal::GetCapturedStdout();
  return {status, testing::internal::GetCapturedStderr()};
}

TEST(Lesson, ATrueClaimIsStatusZero) {
  const Ran ran = check([](Page& page) { page.claim(true_claim()); });
  EXPECT_EQ(ran.status, 0);
  EXPECT_THAT(ran.complained, IsEmpty());
}

TEST(Lesson, AFalseClaimIsStatusOneAndNamed) {
  const Ran ran = check([](Page& page) {
    Claim claim = true_claim();
    claim.measured = 2;
    page.claim(claim);
  });
  EXPECT_EQ(ran.status, 1);
  EXPECT_THAT(ran.complained, HasSubstr("98_wrong step 1: one is false: measured 2, expected 1"));
}

TEST(Lesson, AMeasurementThatIsNoNumberIsFalse) {
  for (const Tolerance& tolerance : {absolute(1e9), relative(1e9), at_most(), at_least()}) {
    Claim claim = true_claim();
    claim.tolerance = tolerance;
    claim.measured = std::nan("");
    EXPECT_FALSE(claim.holds());
    claim.measured = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(claim.holds());
  }
}

TEST(Lesson, TolerancesHoldOnBothSidesOfTheirBounds) {
  EXPECT_TRUE(absolute(0.5).met(1, 1.5));
  EXPECT_FALSE(absolute(0.5).met(1, 1.5000001));
  EXPECT_TRUE(relative(0.25).met(-4, -5));
  EXPECT_FALSE(relative(0.25).met(-4, -5.000001));
  EXPECT_TRUE(at_most().met(1, 1));
  EXPECT_FALSE(at_most().met(1, 1.000001));
  EXPECT_TRUE(at_least().met(1, 1));
  EXPECT_FALSE(at_least().met(1, 0.999999));
}

struct Misuse {
  const char *name, *sentence;
  StepFunction step;
};

class RefusedMisuse : public testing::TestWithParam<Misuse> {};

TEST_P(RefusedMisuse, WithASentence) {
  const Ran ran = check(GetParam().step);
  EXPECT_EQ(ran.status, 1);
  EXPECT_THAT(ran.complained, HasSubstr(GetParam().sentence));
}

void predict(Page& page, double wrong) {
  page.predict({.ask = "How many?", .answer = 1, .tolerance = 0.5, .wrong = {{wrong, "No."}}});
}

const std::vector<Misuse> misuses = {
    {"NoClaim", "needs at least one claim", [](Page& page) { page.text("All talk."); }},
    {"NoSource", "does not say where", [](Page& page) { page.claim({.quantity = "q"}); }},
    {"NoRange", "does not say where it is",
     [](Page& page) { page.claim({.quantity = "q", .source = "s", .range = {false}}); }},
    {"NoSuchEquation", "no equation (24)", [](Page& page) { page.equation(24); }},
    {"NoSuchTag", "no lines between",
     [](Page& page) { page.excerpt("tests/lessons/fixture/main.cpp", "nothing"); }},
    {"TooFewValues", "2 places for 1 values", [](Page& page) { page.text("@ and @", 1); }},
    {"TooManyValues", "0 places for 1 values", [](Page& page) { page.text("none", 1); }},
    {"FormulasDisagree", "1 places for 2 values", [](Page& page) { page.formula("@ @", "@", 1, 2); }},
    {"AnswersMeet", "lies within", [](Page& page) { predict(page, 1.5); }},
    {"NoTolerance", "needs a tolerance", [](Page& page) { page.predict({.ask = "How many?", .answer = 1}); }},
    {"NoSuchOption", "no option 2",
     [](Page& page) {
       page.choose({.ask = "Which?", .options = {{"a", ""}, {"b", ""}}, .answer = 2});
     }},
    {"RowOfATableTooShort", "2 columns, but a row of 1 cells",
     [](Page& page) {
       page.table({"symbol", "meaning"}, {{"d"}});
     }},
    {"DerivationWithoutLines", "has no lines", [](Page& page) { page.derivation("Why", {}); }},
    {"DerivationWithoutAReason", "without its reason",
     [](Page& page) {
       page.derivation("Why", {{"", "C = 0", "C = 0"}});
     }},
    {"PictureTwice", "two pictures are called twice",
     [](Page& page) {
       for (int i = 0; i < 2; ++i) page.figure("twice", "A picture.", [](renderer::Canvas&) {});
       page.claim(true_claim());
     }},
    {"PictureInAnotherFolder", "cannot name a picture",
     [](Page& page) { page.figure("../up", "A picture.", [](renderer::Canvas&) {}); }},
};

TEST(Lesson, ASourceThatIsMissingIsTheEnvironments) {
  const Ran ran = check([](Page& page) { page.excerpt("solver/nothing.hpp", "tag"); });
  EXPECT_EQ(ran.status, 3);
  EXPECT_THAT(ran.complained, HasSubstr("solver/nothing.hpp cannot be read"));
}

INSTANTIATE_TEST_SUITE_P(Lesson, RefusedMisuse, testing::ValuesIn(misuses),
                         [](const auto& misuse) { return std::string(misuse.param.name); });

TEST(Lesson, AnswersThatMeetAtAnotherParameterAreDropped) {
  const auto step = [](Page& page) {
    predict(page, 1.5);
    page.claim(true_claim());
  };
  EXPECT_EQ(check(step, {"--check", "--set", "size=2"}).status, 0);
}

TEST(Lesson, AnswersThatStandApartAreFine) {
  EXPECT_EQ(check([](Page& page) {
              predict(page, 1.51);
              page.claim(true_claim());
            }).status,
            0);
}

TEST(Lesson, HasAtMostSevenCoreStepsAndAnyNumberOfDeeperOnes) {
  Lesson lesson({.slug = "98_long", .title = "Long", .summary = "Too long."});
  for (int i = 0; i < 7; ++i) {
    lesson.step("core", [](Page&) {});
    lesson.deeper("deeper", [](Page&) {});
    lesson.deeper("deeper still", [](Page&) {});
  }
  EXPECT_EQ(lesson.steps()[5].label, "2b");
  EXPECT_THROW(lesson.step("one too many", [](Page&) {}), LessonError);
}

TEST(Lesson, IsNamedByNumberAndWord) {
  for (const char* slug : {"", "jacobian", "1_jacobian", "01-jacobian", "01_", "01_Jacobian", "01_a/b"})
    EXPECT_THROW(Lesson({.slug = slug}), LessonError) << slug;
  EXPECT_EQ(Lesson({.slug = "04_baumgarte"}).number(), 4);
}

TEST(Lesson, AStepAnswersToParametersThatItAloneLooksAt) {
  Lesson lesson({.slug = "98_parameters"});
  for (const char* name : {"h", "budget", "drift"}) lesson.parameter(name, 0.1, "1", {0, 1}, "a number");
  lesson.step("Any", [](Page&) {});
  lesson.step("The one", [](Page&) {});
  lesson.answers({"budget", "drift"});
  EXPECT_THROW(lesson.answers({"nothing"}), LessonError);
  EXPECT_EQ(lesson.step_of({{"budget", "1"}, {"drift", "1"}}), "2");
  EXPECT_EQ(lesson.step_of({{"budget", "1"}, {"h", "1"}}), "") << "another step looks at h";
  EXPECT_EQ(lesson.step_of({}), "");
}

TEST(Lesson, RefusesParametersThatContradictThemselves) {
  Lesson lesson({.slug = "98_parameters"});
  lesson.parameter("h", 0.1, "s", {0, 1}, "time step");
  EXPECT_THROW(lesson.parameter("h", 0.1, "s", {0, 1}, "again"), LessonError);
  EXPECT_THROW(lesson.parameter("beta", 2.0, "1", {0, 1}, "out of its range"), LessonError);
  EXPECT_THROW(lesson.answers({"h"}), LessonError) << "before any step";
  EXPECT_THROW(lesson.parameter("scene", "tower", {"chain", "stack"}, "none of its choices"), LessonError);
  EXPECT_THROW(lesson.parameter("scene", "a chain", {"a chain"}, "cannot be typed"), LessonError);
}

}  // namespace
}  // namespace byhand::tests
