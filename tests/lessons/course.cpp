// The course, with the fixture as its only lesson.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/lessons/terminal/process.hpp"
#include "tests/lessons/terminal/terminal.hpp"

namespace byhand::tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(Course, AnUnknownLessonIsRefusedWithThoseThatExist) {
  const Finished finished = run(std::string(BYHAND_COURSE) + " 7");
  EXPECT_EQ(finished.status, 2);
  EXPECT_EQ(finished.complained, "There is no lesson \"7\"; there are 99 fixture.\n");
}

TEST(Course, FindsALessonByNumberNameOrFolder) {
  for (const char* name : {"99", "fixture", "99_fixture", "fix"})
    EXPECT_EQ(run(std::string(BYHAND_COURSE) + " " + name + " --check").status, 0) << name;
}

TEST(Course, FindsALessonByAPartThatNoOtherNameHas) {
  const auto listed = [](const char* part) {
    return run(std::string(BYHAND_REAL_COURSE) + " " + part + " --list-parameters").status;
  };
  EXPECT_EQ(listed("where_methods"), 0);
  EXPECT_EQ(listed("contact"), 0) << "a whole name";
  EXPECT_EQ(listed("a"), 2) << "a part of several";
}

TEST(Course, HandsOptionsAndStatusThrough) {
  EXPECT_EQ(run(std::string(BYHAND_COURSE) + " fixture --set beta=7").status, 2);
  EXPECT_THAT(run(std::string(BYHAND_COURSE) + " fixture --list-parameters --set beta=0.5").said,
              HasSubstr("0.5"));
}

TEST(Course, WithoutATerminalRunsAllAndSaysWhereThePicturesAre) {
  const Folder folder;
  const Finished finished =
      run(std::string(BYHAND_COURSE) + " --all --quality low --output " + folder.path().string());
  EXPECT_EQ(finished.status, 0);
  EXPECT_THAT(finished.said,
              AllOf(HasSubstr("It settles"), HasSubstr("All pictures are in " + folder.path().string())));
  EXPECT_EQ(run(std::string(BYHAND_COURSE) + " --check").status, 0);
}

TEST(Course, BuildsALessonWhenItsReaderComesToIt) {
  const Folder folder;
  const std::string builder = (folder / "build").string();
  std::ofstream(builder) << "#!/bin/sh\necho built $1\nexit $status\n";
  std::filesystem::permissions(builder, std::filesystem::perms::owner_all);
  const auto course = [&](int status, const std::string& arguments) {
    return run(fmt::format("status={} BYHAND_BUILD={} {} {} --check", status, builder, BYHAND_COURSE, arguments));
  };
  EXPECT_THAT(course(0, "fixture").said, AllOf(StartsWith("built 99_fixture\n"), HasSubstr("2 hold")));
  EXPECT_THAT(course(0, "--all").said, AllOf(StartsWith("built lessons\n"), HasSubstr("2 hold")));
  for (const char* arguments : {"fixture", "--all"}) {
    const Finished finished = course(3, arguments);
    EXPECT_EQ(finished.status, 3);
    EXPECT_THAT(finished.said, Not(HasSubstr("2 hold")));
  }
}

TEST(Course, BuildsLessonsWhileAReaderReadsAndStopsWhenHeLeaves) {
  const Folder folder;
  const std::string builder = (folder / "build").string(), lock = (folder / "lock").string();
  std::ofstream(builder) << "#!/bin/sh\n[ $1 != --behind ] || exec flock " << lock << " sh -c 'echo $2 >"
                         << (folder / "behind").string() << "; sleep 60' sh $*\n";
  std::filesystem::permissions(builder, std::filesystem::perms::owner_all);
  Terminal reader({BYHAND_COURSE},
                  {{"TERM", "dumb"}, {"XDG_STATE_HOME", folder.path().string()}, {"BYHAND_BUILD", builder}});
  reader.expect("▸");
  const auto behind = [&] {
    std::string target;
    for (int i = 0; i < 1000 && !(std::ifstream(folder / "behind") >> target); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return target;
  };
  EXPECT_EQ(behind(), "99_fixture");
  reader.enter("q");
  EXPECT_EQ(reader.leave(), 0);
  EXPECT_EQ(std::system(("flock -w 10 " + lock + " true").c_str()), 0) << "the build still runs";
}

// cmake stands for a compiler that works on: another build does not wait for it.
TEST(Course, ABuildBehindTheReaderGivesWayToAnyOther) {
  const Folder folder;
  std::ofstream(folder / "cmake") << "#!/bin/sh\necho >" << (folder / "begun").string() << "\nexec sleep 60\n";
  std::filesystem::permissions(folder / "cmake", std::filesystem::perms::owner_all);
  const std::string shell =
      fmt::format("mkdir -p {0}/release; export PATH={0}:$PATH; source {1}/.ci/setup; builds={0}; ",
                  folder.path().string(), BYHAND_SOURCE);
  std::ofstream(folder / "behind.sh") << shell << "build_behind release 01_jacobian 02_single_constraint\n";
  std::ofstream(folder / "other.sh") << shell << "alone release echo built\n";
  Started behind({"/usr/bin/setsid", "bash", (folder / "behind.sh").string(), "--behind"});
  for (int i = 0; i < 1000 && !std::filesystem::exists(folder / "begun"); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  ASSERT_TRUE(std::filesystem::exists(folder / "begun"));
  EXPECT_EQ(run("bash " + (folder / "other.sh").string()).said, "built\n");
  EXPECT_EQ(behind.finish().status, -SIGTERM);
}

TEST(Course, TheMenuFitsOnAScreenAndStaysBelowItsError) {
  const Folder folder;
  for (const Size size : {Size{80, 24}, Size{50, 24}}) {
    Terminal reader({BYHAND_REAL_COURSE}, {{"TERM", "dumb"}, {"XDG_STATE_HOME", folder.path().string()}}, size);
    const std::string menu = reader.said_until("▸");
    EXPECT_LT(std::count(menu.begin(), menu.end(), '\n'), size.rows) << menu;
    for (const char* number : {"1  ", "9  "}) EXPECT_THAT(menu, HasSubstr(number));
    reader.enter("77");
    reader.expect("There is no lesson \"77\"");
    EXPECT_THAT(reader.said_until("▸"), Not(HasSubstr("Constraints by Hand")))
        << "the menu is not printed over it";
    reader.enter("q");
    EXPECT_EQ(reader.leave(), 0);
  }
}

TEST(Course, TheMenuIsAWordAwayFromALesson) {
  const Folder folder;
  Terminal reader({BYHAND_COURSE, "fixture", "--output", folder.path().string()},
                  {{"TERM", "dumb"}, {"XDG_STATE_HOME", folder.path().string()}});
  reader.expect("▸");
  reader.enter("menu");
  reader.expect("Enter goes on with lesson 99");
  reader.expect("▸");
  reader.enter("q");
  EXPECT_EQ(reader.leave(), 0);
}

TEST(Course, ShowsHowFarTheReaderGotAndGoesOnThere) {
  const Folder folder;
  const std::map<std::string, std::string> environment = {{"TERM", "dumb"},
                                                          {"XDG_STATE_HOME", folder.path().string()}};
  {
    Terminal reader({BYHAND_COURSE}, environment);
    reader.expect("99  Fixture");
    reader.expect("Enter goes on with lesson 99");
    reader.enter("5");
    reader.expect("There is no lesson \"5\"");
    reader.expect("▸");
    reader.enter("99");
    reader.expect("1/2  The error shrinks");
    reader.expect("▸");
    reader.type("\x03");
    reader.expect("Until next time");
    EXPECT_EQ(reader.leave(), 0);
  }
  Terminal reader({BYHAND_COURSE}, environment);
  reader.expect("at step 1");
  reader.expect("▸");
  reader.type("\x04");
  EXPECT_EQ(reader.leave(), 0);
  // The course has no options: its lessons write where their reader would look.
  std::filesystem::remove_all(std::filesystem::path(BYHAND_OUTPUT) / "99_fixture");
}

}  // namespace
}  // namespace byhand::tests
