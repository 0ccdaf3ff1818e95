// `./lessons/run practise` without a terminal.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

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
  for (const char* usage : {"8 --check /nowhere.cpp", "13", "0", "x", "8 --hint 4", "--check x", "8 --no-such"}) {
    const Finished finished = practise_run(usage, state);
    EXPECT_EQ(finished.status, 2) << usage;
    EXPECT_EQ(std::count(finished.complained.begin(), finished.complained.end(), '\n'), 1) << finished.complained;
  }
  EXPECT_THAT(practise_run("13", state).complained, HasSubstr("There is no exercise 13; there are 1 to 12"));
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

void expect_refused(const Finished& finished, const std::string& line, const std::string& sentence = "") {
  EXPECT_EQ(finished.status, 2) << line;
  EXPECT_THAT(finished.said, testing::IsEmpty()) << line;
  EXPECT_THAT(finished.complained, AllOf(HasSubstr(sentence), testing::Not(HasSubstr("\033")))) << line;
  EXPECT_EQ(std::count(finished.complained.begin(), finished.complained.end(), '\n'), 1) << finished.complained;
}

TEST(CommandLine, OptionsThatExcludeEachOtherAreRefused) {
  const Folder state;
  const std::string file = (exercise(8).folder() / "stub.cpp").string(), folder = exercise(8).folder().string();
  for (const std::string& line :
       {"8 --check " + file + " --hint 1", "8 --check " + file + " --solution",
        std::string("8 --solution --check missing"), std::string("8 --hint 1 --solution"),
        "8 --unmask --check " + file, "8 --grade " + folder + " --hint 1",
        "--grade " + folder + " --export junit --to " + (state / "new").string(),
        "8 --hint 1 --folder " + state.path().string()})
    expect_refused(practise_run(line, state), line, "choose one of them");
  for (const std::string& line :
       {"8 --film " + (state / "film").string(), std::string("8 --report junit=-"),
        "8 --solution --to " + (state / "new").string(), "8 --solution --questions " + (state / "new").string()})
    expect_refused(practise_run(line, state), line, "needs");
  expect_refused(practise_run("3 --export moodle --to " + (state / "new").string(), state), "3 moodle");
}

TEST(CommandLine, AHandoutIsATaskAndAStubWithoutHintsAndSolution) {
  const Folder state;
  const std::filesystem::path to = state / "handouts";
  ASSERT_EQ(practise_run("--export handouts --to " + to.string(), state).status, 0);
  int tasks = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(to)) {
    const std::string name = entry.path().filename();
    EXPECT_NE(name, "solution.cpp");
    if (name != "task.md") continue;
    ++tasks;
    EXPECT_EQ(contents(entry.path()).find("## Hint"), std::string::npos) << entry.path();
  }
  EXPECT_EQ(tasks, 12);
}

TEST(CommandLine, NumbersThatAreNoneAreRefused) {
  const Folder state;
  EXPECT_THAT(practise_run("0", state).complained, HasSubstr("There is no exercise 0; there are 1 to 12"));
  const std::string file = " --check " + (exercise(8).folder() / "solution.cpp").string();
  for (const std::string& line :
       std::vector<std::string>{"8 --seed 99999999999999999999", "8 --seed -1", "8 --seed x", "8 --seed 1.5",
                                "8 --hint 0", "8 --check ''", "8 --grade ''", "--export ''"})
    expect_refused(practise_run(line + (line.find("--seed") == std::string::npos ? "" : file), state), line);
  EXPECT_EQ(practise_run("8 --seed 18446744073709551615" + file, state).status, 0);
}

TEST(CommandLine, WordsAreRepeatedAsATerminalMayPrintThem) {
  const Folder state;
  for (const char* words : {"\\033[31m", "a\\nb", "--\\033", "1\\n2", "\\377\\376"})
    expect_refused(practise_run(fmt::format("\"$(printf -- '{}')\"", words), state), words);
  expect_refused(practise_run("8 --check \"$(printf 'x\\033[31m')\"", state), "--check");
}

TEST(CommandLine, AFullOrClosedOutputIsOneSentence) {
  const Folder state;
  for (const std::string& line : {std::string(""), std::string("--help"), check(8, "solution.cpp"),
                                  std::string("8 --hint 1"), "--grade " + exercise(8).folder().string()})
    for (const char* output : {" >/dev/full", " >&-"}) {
      const Finished finished = practise_run(line + output, state);
      EXPECT_EQ(finished.status, 4) << line << output;
      EXPECT_THAT(finished.complained, HasSubstr("standard output")) << line << output;
      EXPECT_EQ(std::count(finished.complained.begin(), finished.complained.end(), '\n'), 1)
          << finished.complained;
    }
}

TEST(CommandLine, AFileMayHaveAnyName) {
  const Folder state;
  for (const char* name :
       {"answer.txt", "noext", "a.h", "a.c", "a.o", "a b;$(x).cpp", "-o", "@file", "übung.cc"}) {
    std::ofstream(state / name) << text_of(8, "solution.cpp");
    const Finished finished = run(fmt::format("cd {} && XDG_STATE_HOME=. {} 8 --check=./'{}'",
                                              state.path().string(), BYHAND_PRACTISE, name));
    EXPECT_EQ(finished.status, 0) << name << finished.said << finished.complained;
  }
}

TEST(CommandLine, AFolderThatIsNotThereIsNotGraded) {
  const Folder state;
  std::ofstream(state / "file") << "no folder";
  std::filesystem::create_symlink("circle", state / "circle");
  for (const std::string& folder :
       {std::string("/nonexistent"), (state / "file").string(), (state / "circle").string()}) {
    const std::string report = (state / "report").string();
    expect_refused(practise_run("--grade " + folder + " --report junit=" + report, state), folder, folder);
    EXPECT_FALSE(std::filesystem::exists(report)) << folder;
    expect_refused(run(fmt::format("{} --keys / --submission {}", BYHAND_GRADE, folder)), folder);
    expect_refused(run(fmt::format("{} --keys {} --submission /", BYHAND_GRADE, folder)), folder, folder);
  }
  for (const char* option : {"--check ", "--folder "}) {
    const Finished finished = practise_run("8 " + (option + (state / "circle").string()), state);
    EXPECT_THAT(finished.status, testing::AnyOf(2, 4));
    EXPECT_THAT(finished.complained, testing::Not(HasSubstr("filesystem error")));
    EXPECT_EQ(std::count(finished.complained.begin(), finished.complained.end(), '\n'), 1) << finished.complained;
  }
  for (const char* to : {"/dev/full", "/dev/null"})
    for (const char* kind : {"junit", "moodle"})
      expect_refused(practise_run(fmt::format("--export {} --to {}", kind, to), state), to, "no folder");
}

/// A report of JUnit apart from how long each exercise took, which no two runs share.
std::string without_times(const std::string& report) {
  return std::regex_replace(report, std::regex("time=\"[0-9]+\\.[0-9]{3}\""), "time");
}

TEST(CommandLine, AReportGoesThroughDevicesAndPipesAndReplacesNone) {
  namespace fs = std::filesystem;
  const Folder state;
  const std::string grade = "8 --grade " + exercise(8).folder().string() + " --report junit=";
  const auto path = [&](const char* name) { return (state / name).string(); };
  ASSERT_EQ(run("mkfifo " + path("pipe")).status, 0);
  const Finished piped =
      run(fmt::format("cat {} >{} & XDG_STATE_HOME={} timeout 20 {} {}{}; s=$?; wait; exit $s", path("pipe"),
                      path("read"), path("s"), BYHAND_PRACTISE, grade, path("pipe")));
  EXPECT_EQ(piped.status, 1) << piped.complained;
  EXPECT_TRUE(fs::is_fifo(path("pipe")));
  const std::string report = without_times(contents(path("read")));
  EXPECT_THAT(report, StartsWith("<?xml"));
  EXPECT_EQ(report.find("<?xml", 1), std::string::npos) << "one report, and none that nothing is finished";

  EXPECT_EQ(without_times(practise_run(grade + "/dev/stdout", state).said), report);
  EXPECT_EQ(
      without_times(
          run(fmt::format("XDG_STATE_HOME={} {} {}/dev/stdout | cat", path("s"), BYHAND_PRACTISE, grade)).said),
      report);
  EXPECT_EQ(practise_run(grade + "/dev/null", state).status, 1);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  const Finished full = practise_run(grade + "/dev/full", state);
  EXPECT_EQ(full.status, 4);
  EXPECT_THAT(full.complained, HasSubstr("/dev/full"));
  EXPECT_TRUE(fs::is_character_file("/dev/full"));

  std::ofstream(path("report.xml")) << "old";
  fs::create_symlink("report.xml", state / "link");
  EXPECT_EQ(practise_run(grade + path("link"), state).status, 1);
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(without_times(contents(path("report.xml"))), report);
}

TEST(CommandLine, AReportMakesNoFolders) {
  const Folder state;
  const std::string grade = "8 --grade " + exercise(8).folder().string() + " --report junit=";
  std::filesystem::create_symlink("nowhere", state / "dangling");
  std::filesystem::create_symlink("circle", state / "circle");
  for (const std::string& file : {(state / "mistyped/report.xml").string(), (state / "dangling").string(),
                                  (state / "circle").string(), state.path().string(), std::string("")})
    expect_refused(practise_run(grade + file, state), file, file);
  EXPECT_FALSE(std::filesystem::exists(state / "mistyped"));
}

TEST(CommandLine, TheCourseKnowsIt) {
  EXPECT_THAT(run(std::string(BYHAND_REAL_COURSE) + " practise 8 --hint 1").said, StartsWith("Hint 1 of 3"));
}

}  // namespace
}  // namespace byhand::tests
