// The options of a lesson and its exit status, as a script meets them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <string>

#include "tests/lessons/terminal/process.hpp"

namespace byhand::tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

Finished fixture(const std::string& options) { return run(std::string(BYHAND_FIXTURE) + " " + options); }

TEST(Options, HelpNamesAllOfThemAndTeaches) {
  const Finished finished = fixture("--help");
  EXPECT_EQ(finished.status, 0);
  for (const char* option :
       {"--interactive", "--no-interactive", "--output", "--quality", "--frames", "--set", "--list-parameters",
        "--check", "--step", "--quiet", "beta = 0.2 [1], from 0 to 3", "--set beta=", "Exit status"})
    EXPECT_THAT(finished.said, HasSubstr(option));
}

TEST(Options, CheckShowsTheClaimsAndWritesNothing) {
  const Folder folder;
  const Finished finished = fixture("--check --output " + (folder / "output").string());
  EXPECT_EQ(finished.status, 0);
  EXPECT_THAT(finished.said, AllOf(HasSubstr("|C| at the end"), HasSubstr("2 hold, 0 false")));
  EXPECT_FALSE(std::filesystem::exists(folder / "output"));
}

TEST(Options, OutsideItsRangeAClaimIsNotClaimedAndNoFailure) {
  const Finished finished = fixture("--check --set beta=2.1");
  EXPECT_EQ(finished.status, 0);
  EXPECT_THAT(finished.said, HasSubstr("1 hold, 0 false, 1 not claimed"));
}

TEST(Options, ListParametersGivesUnitRangeAndMeaning) {
  const Finished finished = fixture("--list-parameters --set h=1/30");
  EXPECT_EQ(finished.status, 0);
  EXPECT_THAT(finished.said,
              AllOf(HasSubstr("1/30"), HasSubstr("1/60"), HasSubstr("0.0001 … 0.1"), HasSubstr("time step")));
}

TEST(Options, AChoiceIsTypedByItsName) {
  const Finished listed = fixture("--list-parameters --set bob=box");
  EXPECT_EQ(listed.status, 0);
  EXPECT_THAT(listed.said, testing::ContainsRegex("bob +box +disc +disc, box +how it is drawn"));
  const Folder folder;
  const Finished told = fixture("--step 1a --set bob=box --quality low --output " + folder.path().string());
  EXPECT_EQ(told.status, 0);
  EXPECT_THAT(told.said, HasSubstr("The bob, a box, is"));
}

TEST(Options, ANumberMayCarryItsUnitOrASmallerOneOfItsFamily) {
  for (const char* typed : {"0.005", "1/200", "5ms", "5e3us", "5000µs", "5e6ns", "0.005s", "'5 ms'"})
    EXPECT_THAT(fixture(std::string("--list-parameters --set h=") + typed).said,
                testing::ContainsRegex("h +0.005 +1/60 +s "))
        << typed;
}

TEST(Options, QuietSaysNothingWhenAllIsWell) {
  const Folder folder;
  const Finished finished = fixture("--quiet --quality low --output " + folder.path().string());
  EXPECT_EQ(finished.status, 0);
  EXPECT_THAT(finished.said + finished.complained, IsEmpty());
  EXPECT_TRUE(std::filesystem::exists(folder / "99_fixture/lesson.md"));
}

TEST(Options, OneStepRunsAloneAndLeavesThePageAlone) {
  const Folder folder;
  const Finished finished = fixture("--step 1a --quality low --output " + folder.path().string());
  EXPECT_EQ(finished.status, 0);
  EXPECT_THAT(finished.said, AllOf(HasSubstr("What a picture adds"), Not(HasSubstr("It settles"))));
  EXPECT_TRUE(std::filesystem::exists(folder / "99_fixture/figures/bob.png"));
  EXPECT_FALSE(std::filesystem::exists(folder / "99_fixture/lesson.md"));
}

TEST(Options, WithoutATerminalNothingWaits) {
  const Folder folder;
  const Finished finished = fixture("--quality low --frames none --output " + folder.path().string());
  EXPECT_EQ(finished.status, 0);
  EXPECT_THAT(finished.said, AllOf(HasSubstr("What a picture adds"), HasSubstr("Answer"), Not(HasSubstr("▸")),
                                   Not(HasSubstr("\033["))));
}

struct Refusal {
  const char *options, *sentence;
};

class RefusedOption : public testing::TestWithParam<Refusal> {};

TEST_P(RefusedOption, InOneSentenceWithStatusTwo) {
  const Finished finished = fixture(GetParam().options);
  EXPECT_EQ(finished.status, 2);
  EXPECT_THAT(finished.complained, HasSubstr(GetParam().sentence));
  EXPECT_EQ(std::count(finished.complained.begin(), finished.complained.end(), '\n'), 1);
  EXPECT_THAT(finished.said, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(
    Options, RefusedOption,
    testing::Values(
        Refusal{"--quality huge", "huge"}, Refusal{"--frames some", "some"}, Refusal{"--set beta", "NAME=VALUE"},
        Refusal{"--set beta=x", "\"x\" is not a number"}, Refusal{"--set beta=0.2.1", "not a number"},
        Refusal{"--set gamma=1", "only beta, h, steps"}, Refusal{"--set beta=3.5", "from 0 to 3"},
        Refusal{"--set beta=inf", "not a number"}, Refusal{"--set steps=2.5", "not a whole number"},
        Refusal{"--set h=1/0", "divides by zero"}, Refusal{"--set h=5kg", "\"5kg\" is not a number"},
        Refusal{"--set h=ms", "\"ms\" is not a number"}, Refusal{"--set h=5s", "h = 5s is out of range"},
        Refusal{"--set beta=5ms", "\"5ms\" is not"},
        Refusal{"--set bob=sphere", "bob = sphere is none of its choices: disc, box"},
        Refusal{"--step 9", "1, 1a, 2"}, Refusal{"--output", "--output"},
        Refusal{"--interactive --no-interactive", "choose one"}, Refusal{"--surprise", "--surprise"},
        Refusal{"--output ''", "names no folder"},
        Refusal{"--output --check", "a folder of that name is ./--check"}, Refusal{"--step ''", "no label"},
        Refusal{"--set '[beta=1]'", "no parameter \"[beta\""}, Refusal{"--set ''", "NAME=VALUE"},
        Refusal{"--interactive --check", "choose one"}, Refusal{"--interactive --quiet", "choose one"},
        Refusal{"--interactive --list-parameters", "choose one"},
        Refusal{"--interactive --questions", "choose one"}, Refusal{"--check --questions", "choose one"},
        Refusal{"--questions --list-parameters", "choose one"}, Refusal{"--check --list-parameters", "choose one"},
        Refusal{"--check=2", "--check takes no value, but \"2\""},
        Refusal{"--check=true", "--check takes no value, but \"true\""},
        Refusal{"--set beta=1 --set beta=1", "beta is set twice"},
        Refusal{"--quality low --quality low", "--quality is given twice"},
        Refusal{"--quality", "--quality needs a value: low|medium|high"},
        Refusal{"--quality higj", "do you mean high?"}, Refusal{"--chek", "do you mean --check?"},
        Refusal{"check", "do you mean --check?"}, Refusal{"-h", "There is no option \"-h\""},
        Refusal{"--", "There is no option \"--\""},
        Refusal{"\"$(printf -- '--bo\\ngus\\033[31m\\302\\233')\"", "\"--bo\\ngus\\x1b[31m\\xc2\\x9b\""},
        Refusal{"\"$(printf -- '--set=b\\377=1')\"", "\"b\\xff\""}));

TEST(Environment, AnUnusableOutputFolderIsStatusThree) {
  const Folder folder;
  const Finished finished = run("touch " + (folder / "file").string() + "; " + BYHAND_FIXTURE + " --output " +
                                (folder / "file").string());
  EXPECT_EQ(finished.status, 3);
  EXPECT_THAT(finished.complained, HasSubstr((folder / "file").string()));
  EXPECT_THAT(finished.said, IsEmpty());
}

TEST(Options, AMissingWorkingFolderIsNoneOfHelpsBusiness) {
  const Folder folder;
  const std::string gone = (folder / "gone").string();
  const Finished help =
      run("mkdir " + gone + " && cd " + gone + " && rmdir " + gone + " && " + BYHAND_FIXTURE + " --help");
  EXPECT_EQ(help.status, 0) << help.complained;
  EXPECT_THAT(help.said, HasSubstr("--quality"));
}

TEST(Environment, ALineOfTwentyMegabytesIsReadInASecond) {
  const Folder folder;
  const auto begin = std::chrono::steady_clock::now();
  const Finished finished =
      run("head -c 20000000 /dev/zero | tr '\\0' x | XDG_STATE_HOME=" + folder.path().string() + " timeout 60 " +
          BYHAND_FIXTURE + " --interactive --frames none --output " + folder.path().string());
  EXPECT_EQ(finished.status, 0) << finished.complained;
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
}

TEST(Environment, APlaceThatIsNoFileIsALessonNotBegun) {
  for (const char* make : {"mkdir -p", "mkfifo"}) {
    const Folder folder;
    const std::string place = (folder / "constraints-by-hand/99_fixture.json").string();
    const Finished finished = run("mkdir -p $(dirname " + place + ") && " + make + " " + place +
                                  " && XDG_STATE_HOME=" + folder.path().string() + " timeout 20 " +
                                  BYHAND_FIXTURE + " --interactive --output " + (folder / "output").string());
    EXPECT_EQ(finished.status, 0) << make << finished.complained;
    EXPECT_THAT(finished.said, HasSubstr("1/2  The error shrinks")) << make;
  }
}

TEST(Environment, AFullDiskIsStatusThree) {
  const Finished finished = run(std::string(BYHAND_FIXTURE) + " --check >/dev/full");
  EXPECT_EQ(finished.status, 3);
  EXPECT_THAT(finished.complained, HasSubstr("No space left"));
}

}  // namespace
}  // namespace byhand::tests
