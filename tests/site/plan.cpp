#include "lessons/site/course/plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace byhand::tests {
namespace {

using site::Digest;
using site::PlannedPart;

int minutes(const std::vector<PlannedPart>& parts) {
  int sum = 0;
  for (const PlannedPart& part : parts) sum += part.minutes;
  return sum;
}

TEST(Plan, FillsTheClassWithTheCoreStepsAndTheExercises) {
  for (int steps = 1; steps <= 7; ++steps) {
    Digest lesson;
    for (int i = 1; i <= steps; ++i)
      lesson.steps.push_back({.label = std::to_string(i),
                              .words = std::string(static_cast<size_t>(500 * i), ' '),
                              .questions = i % 3});
    lesson.steps.push_back({.label = "7a", .deeper = true});
    const auto parts = plan(lesson, {8, 9});
    EXPECT_EQ(parts.size(), steps + 1U);
    EXPECT_EQ(minutes(parts), site::minutes_of_a_class);
    for (const PlannedPart& part : parts) EXPECT_GT(part.minutes, 0);
    EXPECT_EQ(parts.back().show, "exercises 8, 9");
  }
}

TEST(Plan, SaysWhatToShowAndWhatToAskFirst) {
  const Digest lesson{
      .steps = {{.label = "1", .questions = 2, .films = 1, .scene = true}, {.label = "2", .questions = 1}}};
  const auto parts = plan(lesson, {});
  EXPECT_EQ(parts[0].show, "the scene to hold, the film");
  EXPECT_EQ(parts[0].ask, "questions 1.1 to 1.2");
  EXPECT_EQ(parts[1].show, "the formulas and figures");
  EXPECT_EQ(parts[1].ask, "question 2.1");
  EXPECT_GT(parts[0].minutes, parts[1].minutes);
}

}  // namespace
}  // namespace byhand::tests
