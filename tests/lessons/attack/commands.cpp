// ./lessons/run in checkouts whose course is a program of three lines: everything but the compiling is as in the
// real one.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "tests/lessons/files/written.hpp"
#include "tests/lessons/terminal/process.hpp"

namespace byhand::tests {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// In single quotes for a shell.
std::string quoted(const std::string& words) {
  std::string all = "'";
  for (const char letter : words) all += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return all + "'";
}

void write(const fs::path& path, const std::string& words) {
  fs::create_directories(path.parent_path());
  std::ofstream(path) << words;
}

void write_course(const fs::path& checkout, const std::string& version) {
  write(checkout / "lessons/course.c", "#include <stdio.h>\nint main(int n, char** a) { printf(\"version " +
                                           version +
                                           "%s%s\\n\", n > 1 ? \", \" : \"\", n > 1 ? a[1] : \"\"); }\n");
}

void make_checkout(const fs::path& checkout) {
  const fs::path source = BYHAND_SOURCE;
  for (const char* name : {".ci/setup", ".ci/build", "lessons/run", "lessons/contents.cpp", "CMakePresets.json"}) {
    fs::create_directories((checkout / name).parent_path());
    fs::copy(source / name, checkout / name);
  }
  write(checkout / "CMakeLists.txt",
        "cmake_minimum_required(VERSION 3.22)\nproject(fake LANGUAGES C)\nadd_subdirectory(lessons)\n");
  write(checkout / "lessons/CMakeLists.txt", "add_executable(course course.c)\n");
  write_course(checkout, "1");
}

class Commands : public testing::Test {
 protected:
  Commands() { make_checkout(checkout_); }

  static Finished start(const fs::path& checkout, const std::string& arguments = "",
                        const std::string& before = "") {
    return run(before + " " + quoted((checkout / "lessons/run").string()) + " " + arguments);
  }
  static void expect_version(const fs::path& checkout, const std::string& version) {
    const Finished finished = start(checkout, "hello");
    EXPECT_EQ(finished.status, 0) << finished.complained;
    EXPECT_EQ(finished.said, "version " + version + ", hello\n");
  }

  /// A command of the test's own, found before the machine's.
  void command(const std::string& name, const std::string& script) const {
    write(folder_ / "bin" / name, "#!/bin/sh\n" + script + "\n");
    fs::permissions(folder_ / "bin" / name, fs::perms::owner_all);
  }
  void only_installed(const std::string& package) const { command("dpkg-query", "echo installed " + package); }
  std::string first_in_path() const { return "PATH=" + (folder_ / "bin").string() + ":$PATH"; }

  const Folder folder_;
  const fs::path checkout_ = folder_ / "checkout";
};

TEST_F(Commands, HelpAndNoInstallHaveNoSideEffect) {
  const auto before = all_files(folder_.path());
  for (const char* arguments : {"--help", "--all --help", "3 --help", "--no-install", "3 --no-install"}) {
    // An apt-get or a cmake that is called says so.
    write(folder_ / "bin/cmake", "#!/bin/sh\ntouch " + (folder_ / "called").string() + "\n");
    fs::permissions(folder_ / "bin/cmake", fs::perms::owner_all);
    fs::copy(folder_ / "bin/cmake", folder_ / "bin/apt-get", fs::copy_options::overwrite_existing);
    const Finished finished = start(checkout_, arguments, "PATH=" + (folder_ / "bin").string() + ":$PATH");
    EXPECT_EQ(finished.status, 0) << arguments << finished.complained;
    fs::remove_all(folder_ / "bin");
    EXPECT_EQ(all_files(folder_.path()), before) << arguments;
  }
  EXPECT_THAT(start(checkout_, "--help").said, testing::AllOf(HasSubstr("verify FOLDER"), HasSubstr("07_space")));
}

TEST_F(Commands, NoInstallListsWhatIsMissingAndStops) {
  only_installed("cmake");
  const Finished finished = start(checkout_, "--no-install", first_in_path());
  EXPECT_EQ(finished.status, 3);
  EXPECT_THAT(finished.complained, testing::AllOf(HasSubstr("ninja-build"), HasSubstr("Nothing was installed")));
  EXPECT_FALSE(fs::exists(checkout_ / "build"));
}

TEST_F(Commands, NoInstallListsWhatThatCommandWouldInstall) {
  only_installed("cmake");
  for (const char* plain : {"2", "baumgarte", "practise", "verify", ""}) {
    const Finished finished = start(checkout_, std::string(plain) + " --no-install", first_in_path());
    EXPECT_EQ(finished.status, 3) << plain;
    EXPECT_THAT(finished.complained, testing::AllOf(HasSubstr("libosmesa6-dev"), Not(HasSubstr("clang-19")),
                                                    Not(HasSubstr("libode-dev"))))
        << plain;
  }
  EXPECT_THAT(start(checkout_, "site --no-install", first_in_path()).complained,
              testing::AllOf(HasSubstr("clang-19"), HasSubstr("wasi-libc"), HasSubstr("libosmesa6-dev")));
  for (const char* engines : {"10", "beside_the_engines", "engine", "--all", "site"})
    EXPECT_THAT(start(checkout_, std::string(engines) + " --no-install", first_in_path()).complained,
                HasSubstr("libode-dev"))
        << engines;
}

TEST_F(Commands, NoInstallRefusesALineThatCouldNotRun) {
  for (const char* line : {"nosuch --no-install", "--no-install --bogus", "2 --set --no-install",
                           "11 --no-install", "--no-install 2 3", "e --no-install", "2 --check --no-install"}) {
    const Finished finished = start(checkout_, line);
    EXPECT_EQ(finished.status, 2) << line;
    EXPECT_EQ(std::count(finished.complained.begin(), finished.complained.end(), '\n'), 1) << finished.complained;
    EXPECT_THAT(finished.said, testing::IsEmpty());
  }
  const Finished hostile = start(checkout_, "$'a\\nb\\e[31m' --no-install");
  EXPECT_THAT(hostile.complained, Not(testing::AnyOf(HasSubstr("\033"), HasSubstr("a\nb"))));
}

TEST_F(Commands, HelpByItsOtherNamesIsHelp) {
  for (const char* help : {"-h", "help"}) {
    const Finished finished = start(checkout_, help);
    EXPECT_EQ(finished.status, 0) << help;
    EXPECT_THAT(finished.said, HasSubstr("verify FOLDER"));
  }
}

TEST_F(Commands, HelpThatCannotBePrintedIsAFailureOfTheEnvironment) {
  for (const char* line : {"--help >/dev/full", "--help >&-"}) {
    const Finished finished = start(checkout_, line);
    EXPECT_EQ(finished.status, 3) << line;
    EXPECT_THAT(finished.complained, HasSubstr("standard output")) << line;
    EXPECT_EQ(std::count(finished.complained.begin(), finished.complained.end(), '\n'), 1) << finished.complained;
  }
}

TEST_F(Commands, AreFoundThroughLinksAndFromAnywhere) {
  expect_version(checkout_, "1");
  fs::create_symlink(checkout_ / "lessons/run", folder_ / "course");
  fs::create_symlink("course", folder_ / "once more");
  const std::string folder = quoted(folder_.path().string());
  for (const std::string line :
       {"CDPATH=. checkout/lessons/run hello", "CDPATH=.. checkout/lessons/run hello",
        "export CDPATH=..; cd checkout; lessons/run hello", "./course hello", "'./once more' hello",
        "cd checkout/lessons && CDPATH=.. bash run hello", "PATH=$PWD:$PATH course hello"}) {
    const Finished finished = run("cd " + folder + " && " + line);
    EXPECT_EQ(finished.status, 0) << line << "\n" << finished.complained;
    EXPECT_EQ(finished.said, "version 1, hello\n") << line;
  }
}

TEST_F(Commands, APathThatLacksCommandsIsTheEnvironments) {
  const auto expect_named = [&](const std::string& path) {
    const Finished finished = start(checkout_, "hello", "PATH=" + path);
    EXPECT_EQ(finished.status, 3) << path;
    EXPECT_THAT(finished.complained, HasSubstr("PATH")) << path;
    EXPECT_EQ(std::count(finished.complained.begin(), finished.complained.end(), '\n'), 1) << finished.complained;
  };
  expect_named("");
  expect_named("/nonexistent");
  fs::create_directory(folder_ / "bin");
  for (const char* command : {"readlink", "dirname", "sed"})
    fs::create_symlink(fs::path("/usr/bin") / command, folder_ / "bin" / command);
  expect_named((folder_ / "bin").string());
}

TEST_F(Commands, WithoutRootOrNetworkSayWhatIsMissing) {
  only_installed("cmake");
  command("apt-get", "echo 'E: no network' >&2; exit 100");
  command("sudo", "exec \"$@\"");
  const Finished finished = start(checkout_, "", first_in_path());
  EXPECT_EQ(finished.status, 3);
  EXPECT_THAT(finished.complained,
              testing::AllOf(HasSubstr("E: no network"), HasSubstr("apt-get could not install")));
}

TEST_F(Commands, WorkUnderOddPaths) {
  for (const std::string name : {"a b", "it's", "ünï ∂", "$HOME `x`", "a&b", "(1)", "-dash", "#hash", "per%cent",
                                 "{b}", "a+b=c", "~", "at@x:y"}) {
    SCOPED_TRACE(name);
    const fs::path odd = folder_ / name;
    make_checkout(odd);
    expect_version(odd, "1");
  }
}

TEST_F(Commands, RefusePathsThatCMakeCannotBuild) {
  for (const std::string name :
       {"line\nbreak", "semi;colon", "back\\slash", "pi|pe", "quo\"te", "[x]", "*", "?"}) {
    make_checkout(folder_ / name);
    const Finished finished = start(folder_ / name);
    EXPECT_EQ(finished.status, 3);
    EXPECT_THAT(finished.complained, HasSubstr("move the checkout"));
    EXPECT_EQ(std::count(finished.complained.begin(), finished.complained.end(), '\n'), 1);
    EXPECT_FALSE(fs::exists(folder_ / name / "build"));
  }
}

TEST_F(Commands, ACopiedOrMovedCheckoutBuildsItsOwnSources) {
  expect_version(checkout_, "1");
  fs::copy(checkout_, folder_ / "copy", fs::copy_options::recursive);
  write_course(folder_ / "copy", "2");
  expect_version(folder_ / "copy", "2");
  expect_version(checkout_, "1");
  fs::rename(checkout_, folder_ / "moved");
  write_course(folder_ / "moved", "3");
  expect_version(folder_ / "moved", "3");
  expect_version(folder_ / "copy", "2");
}

TEST_F(Commands, ALinkToACheckoutIsTheCheckout) {
  expect_version(checkout_, "1");
  fs::create_symlink(checkout_, folder_ / "link");
  EXPECT_THAT(start(folder_ / "link", "hello").complained, Not(HasSubstr("configuring")));
}

TEST_F(Commands, TwoAtOnceBothWork) {
  for (int i = 0; i < attempts(3); ++i) {
    fs::remove_all(checkout_ / "build");
    Finished other;
    std::thread beside([&] { other = start(checkout_, "hello"); });
    const Finished one = start(checkout_, "hello");
    beside.join();
    for (const Finished& finished : {one, other}) {
      EXPECT_EQ(finished.status, 0) << finished.complained;
      EXPECT_EQ(finished.said, "version 1, hello\n");
    }
  }
}

TEST_F(Commands, ACheckoutThatCannotBeWrittenIsBuiltInTheCache) {
  const auto read_only = [&](const std::string& command) {
    return "unshare --user --map-root-user --mount sh -c 'mount --bind \"$0\" \"$0\" && mount -o remount,ro,bind "
           "\"$0\" && " +
           command + "' " + quoted(checkout_.string());
  };
  if (run(read_only("true")).status != 0) GTEST_SKIP() << "this machine mounts nothing for users";
  const std::string cache = "XDG_CACHE_HOME=" + (folder_ / "cache").string() + " ";
  const Finished finished = run(cache + read_only("exec \"$0/lessons/run\" hello"));
  EXPECT_EQ(finished.status, 0) << finished.complained;
  EXPECT_EQ(finished.said, "version 1, hello\n");
  EXPECT_THAT(finished.complained, HasSubstr(checkout_.string() + " cannot be written, so it is built in"));
  EXPECT_FALSE(fs::exists(checkout_ / "build"));
  EXPECT_EQ(run(cache + read_only("exec \"$0/lessons/run\" hello")).complained, "") << "once is enough";
}

TEST_F(Commands, WhatTheOwnerOfACheckoutBuiltServesWhoeverCannotWriteIt) {
  ASSERT_EQ(start(checkout_, "verify").status, 0);
  const std::string read_only =
      "env -u HOME XDG_CACHE_HOME=" + quoted((folder_ / "cache").string()) +
      " unshare --user --map-root-user --mount sh -c 'mount --bind \"$0\" \"$0\" && mount -o "
      "remount,ro,bind \"$0\" && exec \"$0/lessons/run\" verify' " +
      quoted(checkout_.string());
  if (run("unshare --user --map-root-user --mount true").status != 0) GTEST_SKIP() << "mounts nothing for users";
  const Finished served = run(read_only);
  EXPECT_EQ(served.said, "version 1, verify\n");
  EXPECT_EQ(served.complained, "");
  EXPECT_FALSE(fs::exists(folder_ / "cache"));
  write_course(checkout_, "2");
  const Finished changed = run(read_only);
  EXPECT_EQ(changed.said, "version 2, verify\n") << "an older program serves nobody";
  EXPECT_THAT(changed.complained, HasSubstr("cannot be written, so it is built in"));
}

TEST_F(Commands, ACheckoutThatCannotBeWrittenIsNotBuiltWhereAnotherUserMayComeFirst) {
  fs::create_directory(checkout_ / "build");
  const std::string locked =
      "unshare --user --map-root-user --mount sh -c 'mount --bind \"$0\" \"$0\" && mount -o "
      "remount,ro,bind \"$0\" && exec \"$0/lessons/run\" hello' " +
      quoted(checkout_.string());
  if (run("unshare --user --map-root-user --mount true").status != 0) GTEST_SKIP() << "mounts nothing for users";
  for (const char* environment :
       {"env -u HOME -u XDG_CACHE_HOME ", "HOME= XDG_CACHE_HOME= ", "HOME=relative XDG_CACHE_HOME=cache "}) {
    const Finished finished = run(environment + locked);
    EXPECT_EQ(finished.status, 3) << environment;
    EXPECT_THAT(finished.complained, HasSubstr("HOME")) << environment;
    EXPECT_EQ(std::count(finished.complained.begin(), finished.complained.end(), '\n'), 1) << finished.complained;
  }
}

TEST_F(Commands, WaitingIsSaidOnlyWhenItLasts) {
  expect_version(checkout_, "1");
  const std::string held = quoted((checkout_ / "build/release").string());
  const auto while_held = [&](const std::string& seconds) {
    return run("flock " + held + " sleep " + seconds + " & sleep 0.1; " +
               quoted((checkout_ / "lessons/run").string()) + " hello; wait");
  };
  EXPECT_EQ(while_held("0.4").complained, "");
  const Finished longer = while_held("3");
  EXPECT_EQ(longer.status, 0);
  EXPECT_THAT(longer.complained, HasSubstr("Waiting for another build"));
}

TEST_F(Commands, ABuildSaysWhatItBuildsAndHowLongItTakes) {
  EXPECT_THAT(start(checkout_, "hello").complained, HasSubstr("building course: 2 steps"));
  const Finished finished = run("source=" + quoted(BYHAND_SOURCE) +
                                "; bash -c '. \"$0/.ci/setup\"; { echo \"[1/90] a\"; sleep 6; echo \"[9/90] b\"; "
                                "sleep 9; echo \"[89/90] c\"; } | count \"building lessons\"' \"$source\"");
  EXPECT_THAT(finished.complained,
              testing::MatchesRegex("building lessons: 90 steps …\nbuilding lessons: 9 of 90 steps, about [12] "
                                    "minutes? left\nbuilding lessons: 89 of 90 steps, less than a minute left\n"));
}

TEST_F(Commands, TestsRefuseASeedThatIsNoNumber) {
  for (const char* seed : {"x", "'1;touch evil'", "-1", "99999999999999999999", "1e3"}) {
    const Finished finished = run("cd " + quoted(folder_.path().string()) + " && " +
                                  quoted(BYHAND_SOURCE "/tests/run") + " --no-install --seed=" + seed);
    EXPECT_EQ(finished.status, 2) << seed;
    EXPECT_THAT(finished.complained, HasSubstr("--seed")) << seed;
  }
}

TEST_F(Commands, APackerThatIsInterruptedPrintsNoTraceback) {
  for (const char* program : {"seven_bits", "letter_boxes"}) {
    const std::string fifo = (folder_ / program).string();
    ASSERT_EQ(run("mkfifo " + fifo).status, 0);
    Started packing({"/bin/sh", "-c",
                     std::string("exec ") + BYHAND_SOURCE + "/lessons/site/live/" + program + " " +
                         (folder_ / "fonts").string() + " <" + fifo});
    const std::ofstream held(fifo);
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
    packing.send(SIGINT);
    const Finished finished = packing.finish();
    EXPECT_EQ(finished.complained, "") << program;
  }
}

TEST_F(Commands, ABuildThatFailsSaysWhereItsWordsAre) {
  write(checkout_ / "lessons/course.c", "int main( { nonsense }\n");
  const Finished finished = start(checkout_);
  EXPECT_EQ(finished.status, 3);
  EXPECT_THAT(finished.complained, testing::AllOf(HasSubstr("error:"), HasSubstr("build/release.build.log")));
}

}  // namespace
}  // namespace byhand::tests
