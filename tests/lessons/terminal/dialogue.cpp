// The lesson as a person meets it, key by key through a pseudo-terminal.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "tests/lessons/terminal/process.hpp"
#include "tests/lessons/terminal/terminal.hpp"

namespace byhand::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr auto prompt = "▸";

/// A reader with a state folder and an output folder of their own, who can come back.
class Dialogue : public testing::Test {
 protected:
  Terminal open(std::vector<std::string> options = {}) {
    std::vector<std::string> command = {BYHAND_FIXTURE, "--quality", "low", "--output",
                                        (folder_ / "output").string()};
    command.insert(command.end(), options.begin(), options.end());
    return {command, {{"TERM", "dumb"}, {"XDG_STATE_HOME", (folder_ / "state").string()}}};
  }
  std::string place() const { return contents(folder_ / "state/constraints-by-hand/99_fixture.json"); }

  Folder folder_;
};

TEST_F(Dialogue, EnterGoesOnToTheEndAndLeavesThePage) {
  Terminal reader = open();
  reader.expect("1/2  The error shrinks");
  reader.expect(prompt);
  reader.enter("");
  reader.expect("`deeper` shows “What a picture adds”");
  reader.expect(prompt);
  reader.enter("");
  reader.expect("2/2  It settles, or not");
  reader.expect(prompt);
  reader.enter("");
  reader.expect(prompt);
  reader.enter("");
  reader.expect("What you now know");
  reader.expect("./lessons/run 99 --set beta=2.1");
  EXPECT_EQ(reader.leave(), 0);
  EXPECT_THAT(contents(folder_ / "output/99_fixture/lesson.md"), HasSubstr("What a picture adds"));
  EXPECT_THAT(place(), HasSubstr("\"finished\":true"));
}

TEST_F(Dialogue, ARightPredictionIsPraisedAndGoesOn) {
  Terminal reader = open();
  reader.expect(prompt);
  reader.enter("0.033");
  reader.expect("Yes.");
  reader.expect("(1 − β)ⁿ is left");
  reader.expect("Enter goes on");
}

TEST_F(Dialogue, APredictionMayCarryItsUnitOrBeAFraction) {
  for (const char* typed : {"0.033 m", "0.033m", "1/30"}) {
    Terminal reader = open();
    reader.expect(prompt);
    reader.enter(typed);
    reader.expect("Yes.");
  }
}

TEST_F(Dialogue, WrongPredictionsGetTheirOwnReplyAndAnotherTry) {
  Terminal reader = open();
  reader.expect(prompt);
  reader.enter("0");
  reader.expect("It is a share of what is left, not of the start.");
  reader.expect(prompt);
  reader.enter("-0.0328");
  reader.expect("think about the sign");
  reader.expect(prompt);
  reader.enter("0.02");
  reader.expect("more than that");
  reader.expect(prompt);
  reader.enter("0.05");
  reader.expect("less than that");
  reader.expect(prompt);
  reader.enter("many");
  reader.expect("\"many\" is not a number");
  reader.expect(prompt);
  reader.enter("0.0328");
  reader.expect("Yes.");
}

TEST_F(Dialogue, HintsAndShows) {
  Terminal reader = open();
  reader.expect(prompt);
  reader.enter("why");
  reader.expect("There is no derivation in this step so far.");
  reader.expect(prompt);
  reader.enter("h");
  reader.expect("Look at what one step leaves.");
  reader.expect(prompt);
  reader.enter("hint");
  reader.expect("A step leaves (1 − β) of the error.");
  for (int i = 0; i < 2; ++i) {
    reader.expect(prompt);
    reader.enter("hint");
    reader.expect("Multiply by the same number each time.");
  }
  reader.expect(prompt);
  reader.enter("s");
  reader.expect("0.03277 m");
  reader.expect("Enter goes on");
  reader.enter("h");
  reader.expect("There is no question here.");
}

TEST_F(Dialogue, AReaderWhoPassesGetsTheExplanation) {
  Terminal reader = open();
  reader.expect(prompt);
  reader.enter("");
  reader.expect("0.03277 m");
  reader.expect("(1 − β)ⁿ is left");
  reader.expect("Enter goes on");
}

TEST_F(Dialogue, WhyOpensADerivation) {
  Terminal reader = open();
  reader.expect(prompt);
  reader.enter("s");
  reader.expect("Why (1 − β)ⁿ: `why` shows it line by line.");
  EXPECT_THAT(reader.said_until(prompt), Not(HasSubstr("C₀")));
  reader.enter("why");
  reader.expect("Cₙ = (1 − β)ⁿ C₀");
  reader.expect("n steps, one after the other");
}

TEST_F(Dialogue, AChoiceIsGradedByNumberOrWords) {
  Terminal reader = open({"--step", "2"});
  reader.expect("Does it settle?");
  reader.expect(prompt);
  reader.enter("2");
  reader.expect("No. Each step leaves more than there was.");
  reader.expect(prompt);
  reader.enter("3");
  reader.expect("type a number from 1 to 2");
  reader.expect(prompt);
  reader.enter("yes");
  reader.expect("Yes.");
}

TEST_F(Dialogue, AChangedParameterShowsOldAndNewOnOneLine) {
  Terminal reader = open();
  reader.expect(prompt);
  reader.enter("s");
  reader.expect("Enter goes on");
  reader.enter("beta 0.5");
  reader.expect("beta: 0.2 → 0.5");
  reader.expect("|C|: 0.032768 m → 0.003125 m");
  reader.expect("|C| at the end: 0.032768 m (holds) → 0.003125 m (holds)");
  reader.expect("C (m)");  // the chart is drawn again
  reader.expect(prompt);
  reader.enter("steps = 2");
  reader.expect("|C|: 0.003125 m → 0.025 m");
}

TEST_F(Dialogue, AChangeInFrontOfAQuestionDoesNotGiveItsAnswerAway) {
  Terminal reader = open();
  reader.expect(prompt);
  reader.enter("beta 0.5");
  reader.expect("beta: 0.2 → 0.5");
  const std::string said = reader.said_until("Your prediction");
  EXPECT_THAT(said, Not(HasSubstr("0.003125")));
  EXPECT_THAT(said, HasSubstr("After 5 steps?"));
  reader.expect(prompt);
  reader.enter("0.003");
  reader.expect("Yes.");
}

TEST_F(Dialogue, FractionsAreNumbersAndKeysMayBeNames) {
  Terminal reader = open();
  reader.expect(prompt);
  reader.enter("h 1/120");
  reader.expect("h: 1/60 → 1/120");
  reader.expect(prompt);
  reader.enter("h 2 ms");
  reader.expect("h: 1/120 → 0.002");
  reader.expect(prompt);
  reader.enter("bob box");
  reader.expect("bob: disc → box");
  reader.expect(prompt);
  reader.enter("h");
  reader.expect("Look at what one step leaves.");
}

TEST_F(Dialogue, ABadValueIsRefusedInASentenceAndChangesNothing) {
  Terminal reader = open();
  for (const auto& [typed, sentence] :
       std::map<std::string, std::string>{{"beta 7", "goes from 0 to 3"},
                                          {"beta much", "\"much\" is not a number"},
                                          {"beta nan", "is not a number"},
                                          {"steps 2.5", "is not a whole number"},
                                          {"h 1/0", "divides by zero"},
                                          {"bob sphere", "is none of its choices"}}) {
    reader.expect(prompt);
    reader.enter(typed);
    reader.expect(sentence);
    reader.expect("Nothing was");
  }
  reader.expect(prompt);
  reader.enter("beta");
  reader.expect("beta = 0.2 [1], from 0 to 3");
  reader.expect(prompt);
  reader.enter("bob");
  reader.expect("bob = disc, one of disc, box: how it is drawn");
  reader.expect(prompt);
  reader.enter("gamma 3");
  reader.expect("\"gamma 3\" is not a number");
}

TEST_F(Dialogue, GoesDeeperAndBack) {
  Terminal reader = open();
  reader.expect(prompt);
  reader.enter("b");
  reader.expect("This is where the lesson begins.");
  reader.expect(prompt);
  reader.enter("");
  reader.expect(prompt);
  reader.enter("d");
  reader.expect("1a  What a picture adds (deeper)");
  reader.expect(prompt);
  reader.enter("d");
  reader.expect("Nothing goes deeper here.");
  reader.expect(prompt);
  reader.enter("b");
  reader.expect("1/2  The error shrinks");
  reader.expect(prompt);
  reader.enter("d");
  reader.expect("1a  What a picture adds");
  reader.expect(prompt);
  reader.enter("");
  reader.expect("2/2  It settles, or not");
  reader.expect(prompt);
  reader.enter("b");
  reader.expect("1/2  The error shrinks");
}

TEST_F(Dialogue, HelpNamesEveryKeyAndParameter) {
  Terminal reader = open();
  reader.expect(prompt);
  reader.enter("?");
  const std::string said = reader.said_until(prompt);
  for (const char* word :
       {"Enter", "back", "deeper", "hint", "show", "again", "leave", "beta", "steps", "1/60 [s]"})
    EXPECT_THAT(said, HasSubstr(word));
}

TEST_F(Dialogue, QuitRemembersThePlace) {
  {
    Terminal reader = open();
    reader.expect(prompt);
    reader.enter("");
    reader.expect(prompt);
    reader.enter("");
    reader.expect("2/2");
    reader.expect(prompt);
    reader.enter("q");
    reader.expect("Until next time");
    EXPECT_EQ(reader.leave(), 0);
  }
  Terminal reader = open();
  reader.expect("You stopped here last time");
  reader.expect("2/2");
}

TEST_F(Dialogue, EndOfInputLeaves) {
  Terminal reader = open();
  reader.expect(prompt);
  reader.type("\x04");
  reader.expect("Until next time");
  EXPECT_EQ(reader.leave(), 0);
  EXPECT_THAT(place(), HasSubstr("\"step\":\"1\""));
}

TEST_F(Dialogue, ControlCLeavesAndRemembersThePlace) {
  Terminal reader = open({"--step", "2"});
  reader.expect(prompt);
  reader.type("\x03");
  reader.expect("Until next time");
  EXPECT_EQ(reader.leave(), 0);
  EXPECT_THAT(place(), HasSubstr("\"step\":\"2\""));
}

TEST_F(Dialogue, InteractiveWithoutATerminalEndsWithItsInput) {
  const Finished finished =
      run(std::string(BYHAND_FIXTURE) + " --interactive --output " + (folder_ / "output").string());
  EXPECT_EQ(finished.status, 0);
  EXPECT_THAT(finished.said, HasSubstr("Until next time"));
}

TEST_F(Dialogue, ColoursAndPicturesComeWithATerminalThatHasThem) {
  const std::map<std::string, std::string> environment = {{"TERM", "xterm-256color"},
                                                          {"XDG_STATE_HOME", (folder_ / "state").string()}};
  auto with = environment;
  with["NO_COLOR"] = "1";
  const auto command = [&](const char* output) -> std::vector<std::string> {
    return {BYHAND_FIXTURE, "--quality", "low", "--step", "1a", "--output", (folder_ / output).string()};
  };
  Terminal colourful(command("coloured"), environment), plain(command("plain"), with);
  colourful.expect("The bob where it ended.");
  plain.expect("The bob where it ended.");
  const std::regex colour(R"(\x1b\[[0-9;]+m)");
  EXPECT_TRUE(std::regex_search(colourful.transcript(), colour));
  EXPECT_FALSE(std::regex_search(plain.transcript(), colour));
  for (const Terminal* terminal : {&colourful, &plain})
    EXPECT_THAT(terminal->transcript(), HasSubstr("⠁")) << "the disc in braille";
}

TEST_F(Dialogue, NoLineIsWiderThanTheTerminal) {
  Terminal reader = open();
  reader.expect(prompt);
  reader.enter("s");
  reader.expect("`?` lists");
  reader.enter("?");
  reader.expect("how many steps");
  std::istringstream lines(reader.transcript());
  for (std::string line; std::getline(lines, line);)
    EXPECT_LE(std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; }), 80) << line;
}

}  // namespace
}  // namespace byhand::tests
