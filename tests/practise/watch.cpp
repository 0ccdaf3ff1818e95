// A learner at a terminal.

#include "tests/lessons/terminal/terminal.hpp"
#include "tests/practise/learner.hpp"

namespace byhand::tests {
namespace {

TEST(Watch, JudgesEachSaveUntilCtrlC) {
  const Folder state, mine;
  Terminal learner({BYHAND_PRACTISE, "8", "--folder", mine.path().string()},
                   {{"TERM", "dumb"}, {"NO_COLOR", "1"}, {"XDG_STATE_HOME", state.path().string()}});
  learner.expect("double bias(double C, double beta, double h);");
  learner.expect("Not written yet.");
  const auto save = [&](const std::string& file, const std::string& sentence) {
    std::ofstream(mine / "08_bias.cpp") << text_of(8, file);
    learner.expect(sentence);
  };
  save("mutants/minus.cpp", "b = +β/h·C");
  save("mutants/no_step.cpp", "yours is a rate");
  save("mutants/squared.cpp", "yours is four times as large");
  learner.expect("08_bias.png");
  EXPECT_TRUE(std::filesystem::exists(mine / "08_bias.png"));
  learner.enter("h");
  learner.expect("Hint 1 of 3");
  learner.enter("h");
  learner.expect("Hint 2 of 3");
  save("solution.cpp", "Right, on all");
  learner.expect("Its derivation");
  learner.expect("Next: ./lessons/run practise 8 --unmask");
  learner.type("\x03");
  learner.expect("goes on with");
  EXPECT_EQ(learner.leave(), 0);
  EXPECT_EQ(contents(mine / "08_bias.cpp"), text_of(8, "solution.cpp"));
}

TEST(Watch, FollowsAnEditorThatReplacesTheFile) {
  const Folder state, mine;
  Terminal learner({BYHAND_PRACTISE, "8", "--folder", mine.path().string()},
                   {{"TERM", "dumb"}, {"NO_COLOR", "1"}, {"XDG_STATE_HOME", state.path().string()}});
  learner.expect("Not written yet.");
  std::ofstream(mine / "new") << "double bias(double, double, double) { return betta; }\n";
  std::filesystem::rename(mine / "new", mine / "08_bias.cpp");
  learner.expect("08_bias.cpp:1:");
  learner.enter("q");
  EXPECT_EQ(learner.leave(), 0);
}

}  // namespace
}  // namespace byhand::tests
