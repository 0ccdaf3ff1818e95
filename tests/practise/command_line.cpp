// `./lessons/run practise` without a terminal.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/practise/learner.hpp"

namespace byhand::tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

Finished practise_run(const std::string& arguments, const Folder& state) {
  return run(fmt::format("XDG_STATE_HOME={} {} {}", state.path().string(), BYHAND_PRACTISE, arguments));
}

std::string check(int number, const std::string& file) {
  return fmt::format("{} --check {}", number, (exercise(number).folder() / file).string());
}

TEST(CommandLine, ExitStatusTellsRightWrongBadUsageAndDoesNotCompile) {
  const Folder state;
  std::ofstream(state / "broken.cpp") << "double bias(\n";
  EXPECT_EQ(practise_run(check(8, "solution.cpp"), state).status, 0);
  EXPECT_EQ(practise_run(check(8, "stub.cpp"), state).status, 1);
  EXPECT_EQ(practise_run(check(8, "mutants/minus.cpp"), state).status, 1);
  EXPECT_EQ(practise_run("8 --check " + (state / "broken.cpp").string(), state).status, 3);
  for (const char* usage : {"8 --check /nowhere.cpp", "12", "0", "x", "8 --hint 4", "--check x", "8 --no-such"}) {
    const Finished finished = practise_run(usage, state);
    EXPECT_EQ(finished.status, 2) << usage;
    EXPECT_EQ(std::count(finished.complained.begin(), finished.complained.end(), '\n'), 1) << finished.complained;
  }
  EXPECT_THAT(practise_run("12", state).complained, HasSubstr("There is no exercise 12; there are 1 to 11"));
}

TEST(CommandLine, ProgressIsKept) {
  const Folder state;
  EXPECT_THAT(practise_run("", state).said, testing::Not(HasSubstr("solved")));
  practise_run(check(8, "solution.cpp"), state);
  EXPECT_THAT(practise_run("", state).said, HasSubstr("lesson 4  solved"));
  EXPECT_THAT(practise_run("3 --solution", state).said, HasSubstr("requested before the exercise was solved"));
  EXPECT_THAT(practise_run("", state).said, HasSubstr("(solution requested)"));
  EXPECT_THAT(practise_run("8 --solution", state).said, testing::Not(HasSubstr("requested")));
}

TEST(CommandLine, CopiesTheStubOnceAndNeverIntoOutput) {
  const Folder state, mine;
  const std::string folder = " --folder " + mine.path().string();
  EXPECT_THAT(practise_run("8" + folder, state).said,
              AllOf(HasSubstr("double bias(double C"), HasSubstr("[β] = 1")));
  EXPECT_EQ(contents(mine / "08_bias.cpp"), text_of(8, "stub.cpp"));
  std::ofstream(mine / "08_bias.cpp") << "mine";
  practise_run("8" + folder, state);
  EXPECT_EQ(contents(mine / "08_bias.cpp"), "mine");
  EXPECT_EQ(practise_run("8 --folder output/mine", state).status, 2);
}

TEST(CommandLine, AnEmptyFilmFolderGetsTheFilm) {
  const Folder state, mine;
  const std::string film = (mine / "film").string();
  EXPECT_EQ(practise_run(check(8, "mutants/minus.cpp") + " --film " + film, state).status, 1);
  EXPECT_TRUE(std::filesystem::exists(film + "/0090.png"));
  EXPECT_TRUE(std::filesystem::exists(film + ".png"));
}

TEST(CommandLine, AMutantIsUnmaskedByNumbersThatShowIt) {
  const Folder state;
  EXPECT_THAT(practise_run("3 --unmask", state).said, AllOf(HasSubstr("I1=1"), HasSubstr("J.a1 * J.a1 +")));
  EXPECT_EQ(practise_run("3 --unmask m1=7", state).status, 1);
  const Finished finished = practise_run("3 --unmask I1=0.5", state);
  EXPECT_EQ(finished.status, 0);
  EXPECT_THAT(finished.said, StartsWith("Unmasked. Look at the units"));
  EXPECT_EQ(practise_run("3 --unmask I3=0.5", state).status, 2);
  EXPECT_EQ(practise_run("3 --unmask I1=much", state).status, 2);
}

TEST(CommandLine, TheCourseKnowsIt) {
  EXPECT_THAT(run(std::string(BYHAND_REAL_COURSE) + " practise 8 --hint 1").said, StartsWith("Hint 1 of 3"));
}

}  // namespace
}  // namespace byhand::tests
