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
  write(folder_ / "bin/dpkg-query", "#!/bin/sh\necho installed cmake\n");
  fs::permissions(folder_ / "bin/dpkg-query", fs::perms::owner_all);
  const Finished finished = start(checkout_, "--no-install", "PATH=" + (folder_ / "bin").string() + ":$PATH");
  EXPECT_EQ(finished.status, 3);
  EXPECT_THAT(finished.complained, testing::AllOf(HasSubstr("ninja-build"), HasSubstr("Nothing was installed")));
  EXPECT_FALSE(fs::exists(checkout_ / "build"));
}

TEST_F(Commands, WithoutRootOrNetworkSayWhatIsMissing) {
  write(folder_ / "bin/dpkg-query", "#!/bin/sh\necho installed cmake\n");
  write(folder_ / "bin/apt-get", "#!/bin/sh\necho 'E: no network' >&2; exit 100\n");
  write(folder_ / "bin/sudo", "#!/bin/sh\nexec \"$@\"\n");
  for (const auto& entry : fs::directory_iterator(folder_ / "bin"))
    fs::permissions(entry.path(), fs::perms::owner_all);
  const Finished finished = start(checkout_, "", "PATH=" + (folder_ / "bin").string() + ":$PATH");
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

TEST_F(Commands, ABuildThatFailsSaysWhereItsWordsAre) {
  write(checkout_ / "lessons/course.c", "int main( { nonsense }\n");
  const Finished finished = start(checkout_);
  EXPECT_EQ(finished.status, 3);
  EXPECT_THAT(finished.complained, testing::AllOf(HasSubstr("error:"), HasSubstr("build/release.build.log")));
}

}  // namespace
}  // namespace byhand::tests
