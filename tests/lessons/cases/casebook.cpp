// The casebook: every number that the equations give is what the run gives.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "lessons/cases/case.hpp"
#include "lessons/doctor/doctor.hpp"

namespace byhand::cases {
namespace {

class Casebook : public testing::TestWithParam<int> {
 protected:
  const Folder& folder() const { return all()[static_cast<std::size_t>(GetParam())]; }
  static void expect(const std::vector<Number>& numbers) {
    ASSERT_FALSE(numbers.empty());
    for (const Number& number : numbers)
      EXPECT_TRUE(number.tolerance().met(number.predicted, number.found))
          << number.what << ": predicted " << number.predicted << ", found " << number.found;
  }
};
TEST_P(Casebook, PredictsWhatTheRunGives) { expect(folder().make().numbers(scene_of(folder()))); }
TEST_P(Casebook, PredictsTheCure) {
  const Case told = folder().make();
  expect(told.numbers_cured(told.cured(scene_of(folder()))));
}
TEST_P(Casebook, IsToldInFull) {
  const Case told = folder().make();
  for (const std::string& words : {told.title, told.report, told.link, told.why, told.equation.plain,
                                   told.equation.latex, told.cure, told.takeaway})
    EXPECT_FALSE(words.empty());
  EXPECT_NE(told.link.find("https://"), std::string::npos);
  for (const Number& number : told.numbers(scene_of(folder()))) {
    EXPECT_LE(number.within, 0.1) << number.what;
    EXPECT_FALSE(number.from.empty()) << number.what;
  }
}
/// By how much the scene is beyond the case's law, as the doctor sees it before the run; 0 where it says nothing.
double beyond(const SceneFile& file, int law) {
  double worst = 0;
  for (const doctor::Finding& one : doctor::diagnose(file).findings)
    if (one.law == law) worst = std::max(worst, one.excess());
  return worst;
}
TEST_P(Casebook, IsFoundByTheDoctorAndNotOnceItIsCured) {
  const Case told = folder().make();
  const SceneFile file = scene_of(folder());
  const double reported = beyond(file, told.law), cured = beyond(told.cured(file), told.law);
  EXPECT_GT(reported, 0);
  EXPECT_LT(cured, 0.5 * reported);
  EXPECT_LT(cured, 1);
}
TEST_P(Casebook, IsNamedByAStepOfLessonEight) {
  const std::string command = "`./lessons/run case " + std::to_string(std::stoi(folder().slug)) + "`";
  bool named = false;
  for (const auto& entry : std::filesystem::directory_iterator(BYHAND_LESSON_8)) {
    std::ifstream stream(entry.path());
    std::ostringstream text;
    text << stream.rdbuf();
    named = named || text.str().find(command) != std::string::npos;
  }
  EXPECT_TRUE(named) << command;
}
INSTANTIATE_TEST_SUITE_P(All, Casebook, testing::Range(0, static_cast<int>(all().size())),
                         [](const auto& one) { return all()[static_cast<std::size_t>(one.param)].slug; });

TEST(CasesInAll, AreAtLeastTwelveWithNumbersOfTheirOwn) {
  std::set<std::string> numbers;
  for (const Folder& folder : all()) numbers.insert(folder.slug.substr(0, 2));
  EXPECT_EQ(numbers.size(), all().size());
  EXPECT_GE(all().size(), 12U);
}

}  // namespace
}  // namespace byhand::cases
