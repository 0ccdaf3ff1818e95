// The course with scripts for lessons: what it starts, what it passes on, and what it says at the end.

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>

#include <chrono>
#include <thread>

#include "tests/lessons/terminal/process.hpp"
#include "tests/lessons/terminal/terminal.hpp"

namespace byhand::tests {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;
using namespace std::chrono_literals;

const std::vector<std::string> slugs = {"01_jacobian",
                                        "02_single_constraint",
                                        "03_iterations",
                                        "04_baumgarte",
                                        "05_contact",
                                        "06_joints",
                                        "07_space",
                                        "08_where_methods_fail",
                                        "09_what_accuracy_costs",
                                        "10_beside_the_engines"};

class Course : public testing::Test {
 protected:
  Course() {
    fs::copy(BYHAND_REAL_COURSE, folder_ / "course");
    for (const std::string& slug : slugs) lesson(slug, "exit 0");
  }

  /// Each lesson notes that it ran.
  void lesson(const std::string& slug, const std::string& commands) const {
    const fs::path script = folder_ / slug;
    std::ofstream(script) << "#!/bin/bash\necho " << slug << " >>'" << (folder_ / "ran").string() << "'\n"
                          << commands << "\n";
    fs::permissions(script, fs::perms::owner_all);
  }
  std::vector<std::string> ran() const {
    std::vector<std::string> all;
    std::ifstream file(folder_ / "ran");
    for (std::string slug; std::getline(file, slug);) all.push_back(slug);
    return all;
  }
  std::vector<std::string> command(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), (folder_ / "course").string());
    return arguments;
  }
  Finished course(const std::vector<std::string>& arguments) const { return Started(command(arguments)).finish(); }
  void wait_for(const std::string& file) const {
    for (int i = 0; i < 3000 && !fs::exists(folder_ / file); ++i) std::this_thread::sleep_for(10ms);
    ASSERT_TRUE(fs::exists(folder_ / file));
  }

  const Folder folder_;
};

using AllLessons = Course;
using PassedOn = Course;

TEST_F(AllLessons, SayWherePicturesAreOnlyIfAllWereDrawn) {
  EXPECT_EQ(course({"--all"}).status, 0);
  EXPECT_THAT(course({"--all", "--output", "x\ny"}).said, HasSubstr("All pictures are in x\\ny/LESSON/figures"));
  for (const char* option : {"--check", "--quiet", "--list-parameters"})
    EXPECT_THAT(course({"--all", option}).said, IsEmpty());
}

TEST_F(AllLessons, GoOnAfterAFailureOfALesson) {
  lesson("02_single_constraint", "exit 1");
  lesson("04_baumgarte", "kill -SEGV $$");
  const Finished finished = course({"--all"});
  EXPECT_EQ(ran(), slugs);
  EXPECT_EQ(finished.status, 139);
  EXPECT_THAT(finished.said, IsEmpty());
  EXPECT_EQ(finished.complained,
            "04_baumgarte was ended by signal 11 (Segmentation fault).\n"
            "8 of 10 lessons ended well; not 02_single_constraint (status 1), 04_baumgarte (status 139).\n");
}

TEST_F(AllLessons, StopAtAFailureOfTheEnvironment) {
  lesson("03_iterations", "echo 'The disk is full.' >&2; exit 3");
  const Finished finished = course({"--all"});
  EXPECT_EQ(ran().size(), 3u);
  EXPECT_EQ(finished.status, 3);
  EXPECT_THAT(finished.said, IsEmpty());
  EXPECT_EQ(finished.complained,
            "The disk is full.\n2 of 10 lessons ended well; not 03_iterations (status 3); 7 were not run.\n");
}

TEST_F(AllLessons, SayARefusedOptionOnce) {
  lesson("01_jacobian", "echo 'There is no option.' >&2; exit 2");
  const Finished finished = course({"--bogus"});
  EXPECT_EQ(ran().size(), 1u);
  EXPECT_EQ(finished.status, 2);
  EXPECT_EQ(finished.complained, "There is no option.\n");
}

TEST_F(AllLessons, EndWithOneControlC) {
  for (const std::string& slug : slugs)
    lesson(slug, "echo >'" + (folder_ / "begun").string() + "'; exec sleep 60");
  Terminal reader(command({"--all"}), {});
  wait_for("begun");
  reader.type("\x03");
  reader.expect("0 of 10 lessons ended well; not 01_jacobian (status 130); 9 were not run.");
  EXPECT_EQ(reader.leave(), -1) << "ended by the signal, so that a script around it ends too";
  EXPECT_EQ(ran().size(), 1u);
}

TEST_F(PassedOn, SignalsEndTheLessonToo) {
  // The lesson's lock ends with the lesson.
  const std::string lock = (folder_ / "lock").string();
  lesson("01_jacobian",
         "exec 9>'" + lock + "'; flock 9; echo >'" + (folder_ / "begun").string() + "'; exec sleep 60");
  for (const char* all : {"1", "--all"}) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGKILL}) {
      SCOPED_TRACE(signal);
      fs::remove(folder_ / "begun");
      Started run(command({all}));
      wait_for("begun");
      run.send(signal);
      EXPECT_EQ(run.finish().status, -signal);
      const int held = open(lock.c_str(), O_RDONLY);
      const auto deadline = std::chrono::steady_clock::now() + 10s;
      while (flock(held, LOCK_EX | LOCK_NB) != 0 && std::chrono::steady_clock::now() < deadline)
        std::this_thread::sleep_for(1ms);
      EXPECT_LT(std::chrono::steady_clock::now(), deadline) << "the lesson still runs";
      close(held);
    }
  }
}

TEST_F(PassedOn, SignalsEndABuildWithAllThatItStarted) {
  const fs::path builder = folder_ / "a b'uild";
  const std::string lock = (folder_ / "lock").string();
  std::ofstream(builder) << "#!/bin/bash\n(exec 9>'" << lock << "'; flock 9; echo >'"
                         << (folder_ / "begun").string() << "'; exec sleep 60) | cat\n";
  fs::permissions(builder, fs::perms::owner_all);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    fs::remove(folder_ / "begun");
    Started run(command({"1"}), {"BYHAND_BUILD=" + builder.string()});
    wait_for("begun");
    run.send(signal);
    EXPECT_EQ(run.finish().status, -signal);
    EXPECT_EQ(std::system(("flock -w 10 '" + lock + "' true").c_str()), 0) << "the build still runs";
  }
  EXPECT_THAT(ran(), IsEmpty());
}

TEST_F(PassedOn, ArgumentsAreNoWordsOfAShell) {
  const std::string evil = "'; touch '" + (folder_ / "evil").string() + "'; echo '";
  lesson("01_jacobian", "printf '%s' \"$1\"");
  EXPECT_EQ(course({"1", evil}).said, evil);
  EXPECT_FALSE(fs::exists(folder_ / "evil"));
}

TEST_F(PassedOn, AnUnknownLessonIsOnePrintableLine) {
  const Finished finished = course({"no\nsuch\033[31m"});
  EXPECT_EQ(finished.status, 2);
  EXPECT_THAT(finished.complained, HasSubstr("There is no lesson \"no\\nsuch\\x1b[31m\""));
  EXPECT_EQ(std::count(finished.complained.begin(), finished.complained.end(), '\n'), 1);
}

TEST_F(PassedOn, ALessonThatIsNotBuiltIsNamed) {
  fs::remove(folder_ / "01_jacobian");
  const Finished finished = course({"1", "--help"});
  EXPECT_EQ(finished.status, 3);
  EXPECT_EQ(finished.complained, "01_jacobian is not built yet: ./lessons/run 1 builds it.\n");
}

TEST_F(PassedOn, ALongNameIsShortened) {
  const Finished finished = course({std::string(100'000, 'x')});
  EXPECT_EQ(finished.status, 2);
  EXPECT_LT(finished.complained.size(), 500u);
}

TEST_F(PassedOn, AFullOrClosedOutputIsOneSentence) {
  const std::string program = "'" + (folder_ / "course").string() + "' ";
  fs::create_directories(folder_ / "output/01_jacobian/figures");
  std::ofstream(folder_ / "output/01_jacobian/manifest.json") << R"({"lesson":"01_jacobian","runs":[]})";
  for (const std::string& line :
       {"verify '" + (folder_ / "output").string() + "'", std::string("--all"), std::string("verify --help")})
    for (const char* output : {" >/dev/full", " >&-"}) {
      const Finished finished = run(program + line + output);
      EXPECT_EQ(finished.status, 3) << line << output;
      EXPECT_THAT(finished.complained, HasSubstr("standard output")) << line << output;
      EXPECT_EQ(std::count(finished.complained.begin(), finished.complained.end(), '\n'), 1)
          << finished.complained;
    }
}

class AtATerminal : public Course {
 protected:
  /// A shell with the course in it, which shows afterwards how the terminal is set.
  std::vector<std::string> in_a_shell(const std::string& program) const {
    return {"/bin/sh", "-c", "trap : INT QUIT; " + program + "; stty -a; echo shown"};
  }
  static void expect_as_before(Terminal& reader) {
    const std::string settings = reader.said_until("shown");
    for (const char* setting : {" icanon ", " echo ", " ixon "}) EXPECT_THAT(settings, HasSubstr(setting));
  }
  std::map<std::string, std::string> environment() const {
    return {{"TERM", "xterm"}, {"XDG_STATE_HOME", folder_.path().string()}};
  }
};

TEST_F(AtATerminal, IsAsBeforeWhateverEndsALesson) {
  for (const char* signal : {"SEGV", "ABRT", "KILL", "QUIT", "TERM", "HUP"}) {
    SCOPED_TRACE(signal);
    lesson("01_jacobian", std::string("stty -icanon -echo -ixon; kill -") + signal + " $$");
    Terminal reader(in_a_shell("'" + (folder_ / "course").string() + "' 1"), environment());
    expect_as_before(reader);
    EXPECT_EQ(reader.leave(), 0);
  }
}

TEST_F(AtATerminal, IsAsBeforeWhenALessonIsEndedByItsKeysOrFromOutside) {
  const std::string fixture = std::string(BYHAND_FIXTURE) + " --quality low --output " + (folder_ / "o").string();
  for (const char* signal : {"", "QUIT", "TERM", "HUP"}) {
    SCOPED_TRACE(signal);
    // The shell's own child, so there is no course to put things right.
    Terminal reader(in_a_shell("echo here $$; " + fixture), environment());
    reader.expect("here ");
    const std::string shell = reader.said_until("\n");
    reader.expect("▸");
    if (*signal)
      EXPECT_EQ(run("pkill -" + std::string(signal) + " -P " + shell).status, 0);
    else
      reader.type("\x1c");  // Ctrl-\ .
    expect_as_before(reader);
  }
}

TEST_F(AtATerminal, ControlSStopsNoLesson) {
  Terminal reader({BYHAND_FIXTURE, "--quality", "low", "--output", (folder_ / "o").string()}, environment());
  reader.expect("▸");
  EXPECT_FALSE(reader.can_be_stopped());
  reader.enter("q");
  reader.leave();
}

TEST_F(PassedOn, InputWithoutAnyLineEnds) {
  for (const char* input : {"/dev/zero", "/dev/null", "/"}) {
    const Finished finished =
        run(std::string("timeout 60 ") + BYHAND_FIXTURE + " --interactive --frames none --quality low --output '" +
            (folder_ / "o").string() + "' <" + input);
    EXPECT_EQ(finished.status, 0) << input << finished.complained;
  }
}

TEST_F(AtATerminal, OptionsSurviveTheMenu) {
  for (const std::string& slug : slugs) lesson(slug, "echo $0 got \"$@\"; exit 4");  // 4: back to the menu
  Terminal reader(command({"2", "--plain", "--set", "h=1/120", "--output", "elsewhere", "--step", "1"}),
                  environment());
  reader.expect("02_single_constraint got --plain --set h=1/120 --output elsewhere --step 1");
  reader.expect("> ");
  reader.enter("3");
  reader.expect("03_iterations got --plain --output elsewhere\n");
  reader.expect("> ");
  reader.enter("q");
  EXPECT_EQ(reader.leave(), 0);
}

TEST_F(AtATerminal, PlainWordsAndPlacesOpenTheCourse) {
  Terminal reader(command({"--plain", "--output=elsewhere"}), environment());
  reader.expect("Constraints by Hand");
  EXPECT_THAT(reader.said_until("> "), testing::Not(HasSubstr("▸")));
  lesson("04_baumgarte", "echo got \"$@\"; exit 4");
  reader.enter("4");
  reader.expect("got --plain --output=elsewhere\n");
  reader.enter("q");
  EXPECT_EQ(reader.leave(), 0);
  lesson("04_baumgarte", "exit 0");
  Terminal checks(command({"--check"}), environment());
  EXPECT_EQ(checks.leave(), 0);
  EXPECT_GT(ran().size(), slugs.size()) << "all lessons";
}

}  // namespace
}  // namespace byhand::tests
