// The lesson on terminals that move their cursor: editing, pages, pictures and films, at several sizes.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <sstream>
#include <string>

#include "lessons/terminal/typeset.hpp"
#include "tests/lessons/terminal/process.hpp"
#include "tests/lessons/terminal/terminal.hpp"

namespace byhand::tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr auto prompt = "▸ ";
constexpr auto up = "\033[A", left = "\033[D";

class Keys : public testing::Test {
 protected:
  Terminal open(std::vector<std::string> options = {}, Size size = {},
                std::map<std::string, std::string> environment = {{"TERM", "xterm-256color"}}) {
    std::vector<std::string> command = {BYHAND_FIXTURE, "--quality", "low", "--output",
                                        (folder_ / "output").string()};
    command.insert(command.end(), options.begin(), options.end());
    environment["XDG_STATE_HOME"] = (folder_ / "state").string();
    return {command, environment, size};
  }
  Folder folder_;
};

/// The characters that a transcript shows: without escape sequences, and without what a carriage return of a film
/// or of line editing has overwritten.
std::string visible(const std::string& transcript) {
  static const std::regex escape(R"(\x1b(\[[0-9;?]*[A-Za-z]|[()][A-Z0-9]|[=>78])|-- Space turns the page --)");
  return std::regex_replace(transcript, escape, "");
}

TEST_F(Keys, ArrowsEditTheLineAndBringBackEarlierOnes) {
  Terminal reader = open();
  reader.expect(prompt);
  reader.enter(std::string("0.033") + left + left + left + left + left + "-");  // -0.033
  reader.expect("think about the sign");
  reader.expect(prompt);
  reader.enter(std::string(up) + "\x01" + "\x04");  // the same line without its first character
  reader.expect("Yes.");
}

TEST_F(Keys, TabCompletesCommandsParametersAndChoices) {
  Terminal reader = open();
  reader.expect(prompt);
  reader.enter("hi\t");
  reader.expect("Look at what one step leaves.");
  reader.expect(prompt);
  reader.enter("bo\tbo\t");
  reader.expect("bob: disc → box");
}

TEST_F(Keys, ControlRSearchesEarlierLines) {
  Terminal reader = open();
  reader.expect(prompt);
  reader.enter("hint");
  reader.expect("Look at what one step leaves.");
  reader.expect(prompt);
  reader.enter("beta");
  reader.expect("beta = 0.2 [1]");
  reader.expect(prompt);
  reader.type("\x12hin");
  reader.expect("hint");
  reader.enter("");
  reader.enter("");
  reader.expect("A step leaves (1 − β) of the error.");
}

TEST_F(Keys, ControlLClearsTheScreenAndKeepsTheLine) {
  Terminal reader = open();
  reader.expect(prompt);
  reader.type("hi\x0c");
  reader.expect("\033[H\033[2J");
  reader.enter("nt");
  reader.expect("Look at what one step leaves.");
}

TEST_F(Keys, PastedLinesAreReadOneByOne) {
  Terminal reader = open();
  reader.expect(prompt);
  reader.type("hint\nhint\n0.033\n");
  reader.expect("Look at what one step leaves.");
  reader.expect("A step leaves (1 − β)");
  reader.expect("Yes.");
}

TEST_F(Keys, AfterAnAnswerNoMoreThanAScreenWithoutAKey) {
  for (const Size size : {Size{80, 24}, Size{100, 40}, Size{50, 24}}) {
    Terminal reader = open({}, size);
    reader.expect(prompt);
    reader.turn_pages(false);
    reader.enter("0.033");
    for (int pages = 0; pages < 10; ++pages) {
      const std::string rest = reader.said_until_quiet();
      EXPECT_LE(std::count(rest.begin(), rest.end(), '\n'), size.rows) << rest;
      if (rest.find(prompt) != std::string::npos) break;
      ASSERT_THAT(rest, HasSubstr("Space turns the page"));
      reader.type(" ");
    }
  }
}

TEST_F(Keys, AnotherSizeWrapsTheStepAnew) {
  Terminal reader = open();
  reader.expect(prompt);
  reader.type("0.0");
  reader.resize({50, 24});
  reader.expect("\033[H\033[2J");
  std::istringstream lines(visible(reader.said_until(prompt)));
  std::string text;
  for (std::string line; std::getline(lines, line); text += line + "\n")
    EXPECT_LE(course::display_width(line), 50) << line;
  EXPECT_THAT(text, HasSubstr("After 5 steps?"));
  reader.enter("33");
  reader.expect("Yes.");
}

TEST_F(Keys, ATerminalMaySayAnythingOfItsSize) {
  for (const Size size : {Size{65535, 65535}, Size{1, 1}}) {
    std::filesystem::remove_all(folder_ / "state");
    Terminal reader = open({}, size);
    reader.expect("Your prediction in m");
    reader.enter("0.033");
    reader.expect("Yes.");
  }
}

TEST_F(Keys, NoLineIsWiderThanTheTerminal) {
  for (const Size size : {Size{80, 24}, Size{100, 40}, Size{50, 24}, Size{200, 60}})
    for (const char* terminal : {"xterm-256color", "dumb"}) {
      std::filesystem::remove_all(folder_ / "state");
      Terminal reader = open({}, size, {{"TERM", terminal}});
      reader.expect(prompt);
      reader.enter("show");
      reader.expect("Enter goes on");
      reader.expect(prompt);
      reader.enter("beta 0.5");
      reader.expect("beta: 0.2 → 0.5");
      reader.expect("Enter goes on");
      reader.expect(prompt);
      reader.enter("?");
      reader.expect("how many steps");
      reader.expect("Enter goes on");
      reader.expect(prompt);
      reader.enter("deeper");
      reader.expect("What a picture adds (deeper)");
      reader.expect(prompt);
      std::istringstream lines(visible(reader.transcript()));
      for (std::string line; std::getline(lines, line);) {
        const bool path = line.find(folder_.path().string()) != std::string::npos;  // stays in one piece
        EXPECT_TRUE(path || course::display_width(line) <= size.columns) << line;
      }
    }
}

TEST_F(Keys, NoEscapeSequencesOnADumbTerminalAndNoColoursIfUnwanted) {
  const std::regex escape(R"(\x1b)"), colour(R"(\x1b\[[0-9;]+m)");
  {
    Terminal dumb = open({"--step", "1a"}, {}, {{"TERM", "dumb"}});
    dumb.expect("is 0.03277 m off.");
    EXPECT_FALSE(std::regex_search(dumb.transcript(), escape));
  }
  Terminal grey = open({"--step", "1a"}, {}, {{"TERM", "xterm-256color"}, {"NO_COLOR", "1"}});
  grey.expect("is 0.03277 m off.");
  EXPECT_FALSE(std::regex_search(grey.transcript(), colour));
}

TEST_F(Keys, LettersAreWholeWhateverTheLanguage) {
  for (const char* language : {"C", "C.UTF-8", "de_DE"}) {
    Terminal reader = open({}, {}, {{"TERM", "xterm-256color"}, {"LANG", language}, {"LC_ALL", language}});
    reader.expect(prompt);
    reader.enter("−0,0328");
    reader.expect("think about the sign");
    EXPECT_THAT(reader.transcript(), AllOf(HasSubstr("JV = −βC"), Not(HasSubstr("\\U"))));
  }
}

TEST_F(Keys, AFilmSaysHowLongItIsAndKeepsWhatIsTypedMeanwhile) {
  Terminal reader = open({"--step", "2"});
  reader.expect("A film of 3 s: Space pauses, Enter skips.");
  reader.expect("⣀");
  reader.type(" ");     // pauses
  reader.type("ye\n");  // goes on and skips
  reader.expect("Does it settle?");
  reader.expect(prompt);
  reader.enter("s");
  reader.expect("Yes.");
}

TEST_F(Keys, RealPicturesWhereTheTerminalHasThem) {
  {
    Terminal kitty = open({"--step", "1a"}, {}, {{"TERM", "xterm-kitty"}, {"KITTY_PID", "1"}});
    kitty.expect("The bob where it ended.");
    EXPECT_THAT(kitty.transcript(), HasSubstr("\033_G"));
  }
  Terminal mlterm = open({"--step", "1a"}, {}, {{"TERM", "mlterm"}});
  mlterm.expect("The bob where it ended.");
  EXPECT_THAT(mlterm.transcript(), HasSubstr("\033P0;1;0q"));
}

TEST_F(Keys, PlainIsInWordsWithoutPicturesOrBoxes) {
  Terminal reader = open({"--plain"});
  reader.expect("> ");
  reader.enter("show");
  reader.expect("A chart of C (m) over step (1).");
  reader.expect("error: from (0, 0.1) to (5, 0.0328)");
  reader.expect("> ");
  reader.enter("d");
  reader.expect("is 0.03277 m off.");
  for (const char* sign : {"─", "│", "┤", "█", "⠁", "⣀", "▸", "✓"})
    EXPECT_THAT(reader.transcript(), Not(HasSubstr(sign)));
}

TEST_F(Keys, OpenShowsThePictureInTheDesktopsViewer) {
  const std::string viewer = (folder_ / "xdg-open").string(), seen = (folder_ / "seen").string();
  std::ofstream(viewer) << "#!/bin/sh\necho $1 >" << seen << ".part && mv " << seen << ".part " << seen << "\n";
  std::filesystem::permissions(viewer, std::filesystem::perms::owner_all);
  Terminal reader =
      open({}, {}, {{"TERM", "dumb"}, {"DISPLAY", ":0"}, {"PATH", folder_.path().string() + ":/usr/bin:/bin"}});
  reader.expect(prompt);
  reader.enter("open");
  reader.expect("There is no picture in this step so far.");
  reader.expect(prompt);
  reader.enter("show");
  reader.expect("Enter goes on");
  reader.expect(prompt);
  reader.enter("open nothing");
  reader.expect("There is no picture \"nothing\" in this step so far, only errors.");
  reader.expect(prompt);
  reader.enter("open");
  reader.expect(prompt);
  for (int i = 0; i < 100 && !std::filesystem::exists(seen); ++i) usleep(20'000);
  EXPECT_THAT(contents(seen), HasSubstr("99_fixture/figures/errors.png"));
}

TEST_F(Keys, ChangedParametersSurviveQuitting) {
  {
    Terminal reader = open();
    reader.expect(prompt);
    reader.enter("set beta 0.5");
    reader.expect("beta: 0.2 → 0.5");
    reader.expect(prompt);
    reader.enter("bob box");
    reader.expect("bob: disc → box");
    reader.expect(prompt);
    reader.enter("quit");
    EXPECT_EQ(reader.leave(), 0);
  }
  Terminal reader = open();
  reader.expect("As you left it: beta = 0.5, bob = box");
  reader.expect(prompt);
  reader.enter("reset");
  reader.expect("All parameters have their defaults again.");
  reader.expect(prompt);
  reader.enter("beta");
  reader.expect("beta = 0.2");
  reader.expect(prompt);
  reader.enter("q");
  EXPECT_EQ(reader.leave(), 0);
  Terminal again = open();
  again.expect(prompt);
  EXPECT_THAT(again.transcript(), Not(HasSubstr("As you left it")));
}

TEST_F(Keys, TwoSettingsStandSideBySideOrOneBelowTheOther) {
  for (const auto& [size, beside] : {std::pair{Size{80, 24}, true}, {Size{50, 24}, false}}) {
    Terminal reader = open({}, size);
    reader.expect(prompt);
    reader.enter("show");
    reader.expect("Enter goes on");
    reader.expect(prompt);
    reader.enter("beta 0.5");
    reader.expect("0.032768 m → 0.003125 m");
    const std::string said = visible(reader.said_until(prompt));
    EXPECT_EQ(std::regex_search(said, std::regex("before +now")), beside) << said;
    EXPECT_EQ(std::regex_search(said, std::regex("C \\(m\\) +C \\(m\\)")), beside);
    reader.enter("reset");
    reader.expect("again");
  }
}

TEST_F(Keys, TheTerminalIsLeftAsItWas) {
  for (const char* last : {"quit\n", "\x03", "\x04"}) {
    Terminal reader = open();
    reader.expect(prompt);
    EXPECT_FALSE(reader.echoes());
    reader.type(last);
    reader.expect("Until next time");
    while (!reader.echoes()) usleep(10'000);
    EXPECT_EQ(reader.leave(), 0);
  }
}

}  // namespace
}  // namespace byhand::tests
