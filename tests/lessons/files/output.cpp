// What a run leaves behind: the page, pictures, data and what made them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>

#include "tests/lessons/files/written.hpp"
#include "tests/lessons/terminal/process.hpp"

namespace byhand::tests {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

fs::path fixture(const Folder& folder, const std::string& options = "") {
  const Finished finished =
      run(std::string(BYHAND_FIXTURE) + " --quality low --output " + folder.path().string() + " " + options);
  EXPECT_EQ(finished.status, 0) << finished.complained;
  return folder / "99_fixture";
}

/// The same without what a clock measured, by the lesson's own word.
std::map<std::string, std::string> unclocked_files(const fs::path& folder) {
  auto files = all_files(folder);
  auto manifest = nlohmann::json::parse(files.at("manifest.json"));
  for (auto& made : manifest.at("runs")) {
    for (const auto& [name, sum] : made.at("clocked").items()) EXPECT_EQ(files.erase(name), 1u) << name;
    made.erase("clocked");
  }
  files.at("manifest.json") = manifest.dump();
  return files;
}

TEST(Output, SameOptionsGiveTheSameBytesButForWhatIsClocked) {
  const Folder one, two;
  const auto first = unclocked_files(fixture(one)), second = unclocked_files(fixture(two)),
             again = unclocked_files(fixture(one));
  EXPECT_THAT(first, testing::SizeIs(testing::Ge(11u)));
  EXPECT_THAT(first, testing::Not(testing::Contains(testing::Key("figures/clock.png"))));
  EXPECT_EQ(first, second);
  EXPECT_EQ(first, again);
}

TEST(Output, EveryLinkOfThePageLeadsSomewhere) {
  const Folder folder;
  const fs::path lesson = fixture(folder);
  const std::string page = contents(lesson / "lesson.md");
  const std::regex link(R"(\]\(([^)]+)\))");
  int links = 0;
  for (std::sregex_iterator at(page.begin(), page.end(), link), end; at != end; ++at, ++links)
    EXPECT_TRUE(fs::exists(lesson / (*at)[1].str())) << (*at)[1];
  EXPECT_EQ(links, 7);
}

TEST(Output, ThePageHoldsWhatTheLessonSays) {
  const Folder folder;
  const std::string page = contents(fixture(folder) / "lesson.md");
  for (const char* words :
       {"# 99. Fixture", "## 1 The error shrinks", "## 1a What a picture adds *(deeper)*",
        R"(JV = -\beta C \tag{22})", R"(JV = -0.2 \cdot 0.1\,\mathrm{m})",
        "const double corrected = error - beta * error;", "![The error, step by step.](figures/errors.png)",
        "<details><summary>Answer</summary>", "<details><summary>Hint 3</summary>",
        "| symbol | meaning | unit |\n|---|---|---|\n| β |", "<details><summary>Why (1 − β)ⁿ</summary>",
        "n steps, one after the other:\n\n$$\nC_n = (1 - \\beta)^n C_0\n$$",
        R"(| \|C\| at the end (for β < 2) | 0.032768 m |)", "./lessons/run 99 --set beta=2.1"})
    EXPECT_THAT(page, HasSubstr(words));
}

TEST(Output, PandocTurnsThePageIntoHtml) {
  if (run("command -v pandoc").status != 0) GTEST_SKIP() << "pandoc is not installed";
  const Folder folder;
  const Finished finished =
      run("cd " + fixture(folder).string() + " && pandoc --mathml lesson.md -o page.html && cat page.html");
  EXPECT_EQ(finished.status, 0) << finished.complained;
  EXPECT_THAT(finished.said, AllOf(HasSubstr("<math"), HasSubstr("<table>"), HasSubstr("<details>"),
                                   HasSubstr("figures/errors.png")));
  EXPECT_THAT(finished.said, testing::Not(HasSubstr("$$")));
}

TEST(Output, FilmsAreWrittenByFfmpegTheSameTwice) {
  if (run("command -v ffmpeg").status != 0) GTEST_SKIP() << "ffmpeg is not installed";
  const Folder one, two;
  const auto first = all_files(fixture(one, "--film webm")), second = all_files(fixture(two, "--film webm"));
  int films = 0;
  for (const auto& [name, bytes] : first)
    if (name.ends_with(".webm")) {
      ++films;
      EXPECT_TRUE(bytes.starts_with("\x1a\x45\xdf\xa3")) << name << " is no WebM file";
      EXPECT_EQ(bytes, second.at(name));
      EXPECT_THAT(first.at("manifest.json"), HasSubstr(name));
    }
  EXPECT_GE(films, 1);
  const auto without = all_files(fixture(one));
  for (const auto& [name, bytes] : without) EXPECT_FALSE(name.ends_with(".webm")) << "of an earlier run";
}

TEST(Output, AFilmWithoutFfmpegIsAFailureOfTheEnvironment) {
  const Folder folder;
  const Finished finished = run("PATH=/nonexistent " + std::string(BYHAND_FIXTURE) +
                                " --quality low --film mp4 --output " + folder.path().string());
  EXPECT_EQ(finished.status, 3);
  EXPECT_THAT(finished.complained, HasSubstr("Films need ffmpeg: apt install ffmpeg"));
  const Finished few =
      run(std::string(BYHAND_FIXTURE) + " --film mp4 --frames last --output " + folder.path().string());
  EXPECT_EQ(few.status, 2);
  EXPECT_THAT(few.complained, HasSubstr("--film needs all frames, not --frames last"));
}

TEST(Output, DataHaveAHeaderWithUnitsAndARowForEachPoint) {
  const Folder folder;
  std::istringstream data(contents(fixture(folder) / "data/errors.csv"));
  std::string header, first;
  std::getline(data, header);
  std::getline(data, first);
  EXPECT_EQ(header, "step (1),error: C (m)");
  EXPECT_EQ(first, "0,0.1");
  int rows = 1;
  for (std::string row; std::getline(data, row);) ++rows;
  EXPECT_EQ(rows, 6);
}

TEST(Output, TheManifestSaysWhatMadeIt) {
  const Folder folder;
  const auto manifest = nlohmann::json::parse(contents(fixture(folder, "--set h=1/120") / "manifest.json"));
  EXPECT_EQ(manifest.at("lesson"), "99_fixture");
  ASSERT_EQ(manifest.at("runs").size(), 1u);
  const auto& json = manifest.at("runs").front();
  EXPECT_TRUE(json.at("step").is_null());
  EXPECT_FALSE(json.at("processor").get<std::string>().empty());
  EXPECT_THAT(json.at("commit").get<std::string>(), testing::ContainsRegex("^([0-9a-f]{40}(-dirty)?|unknown)$"));
  EXPECT_THAT(json.at("compiler").get<std::string>(), testing::ContainsRegex("^(GNU|Clang) [0-9.]+$"));
  EXPECT_EQ(json.at("options").at("quality"), "low");
  EXPECT_EQ(json.at("options").at("parameters").at("beta").at("value"), 0.2);
  EXPECT_EQ(json.at("options").at("parameters").at("bob").at("value"), "disc");
  EXPECT_EQ(json.at("time_step").at("value"), 1.0 / 120);
  EXPECT_EQ(json.at("time_step").at("unit"), "s");
  EXPECT_EQ(json.at("method"), "correction");
  EXPECT_THAT(json.at("gl").get<std::string>(), HasSubstr("OpenGL"));
}

TEST(Output, TheManifestListsEveryFileWithItsSum) {
  const Folder folder;
  EXPECT_TRUE(manifest_holds(fixture(folder)));
}

TEST(Output, TheManifestKeepsTheOptionsOfEachPart) {
  const Folder folder;
  fixture(folder);
  const fs::path lesson = fixture(folder, "--step 2 --set beta=0.5 --frames last");
  EXPECT_TRUE(manifest_holds(lesson));
  const auto runs = nlohmann::json::parse(contents(lesson / "manifest.json")).at("runs");
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_TRUE(runs[0].at("step").is_null());
  EXPECT_EQ(runs[0].at("options").at("parameters").at("beta").at("value"), 0.2);
  EXPECT_TRUE(runs[0].at("files").contains("figures/errors.png"));
  EXPECT_FALSE(runs[0].at("files").contains("frames/settling/0004.png")) << "removed by the second run";
  EXPECT_EQ(runs[1].at("step"), "2");
  EXPECT_EQ(runs[1].at("options").at("parameters").at("beta").at("value"), 0.5);
  EXPECT_EQ(runs[1].at("files").size(), 2u);
  fixture(folder);
  EXPECT_TRUE(manifest_holds(lesson));
  EXPECT_EQ(nlohmann::json::parse(contents(lesson / "manifest.json")).at("runs").size(), 1u);
}

TEST(Output, AWholeRunRemovesWhatEarlierOnesListedAndNothingElse) {
  const Folder folder;
  const fs::path lesson = fixture(folder);
  auto manifest = nlohmann::json::parse(contents(lesson / "manifest.json"));
  for (const char* name : {"figures/of_old.png", "../../outside", "/etc/hostname", "mine.html"})
    manifest["runs"][0]["files"][name] = "";
  std::ofstream(lesson / "manifest.json") << manifest;
  std::ofstream(lesson / "figures/of_old.png") << "old";
  std::ofstream(lesson / "mine.html") << "mine";
  std::ofstream(folder / "outside") << "not a lesson's";
  fixture(folder);
  EXPECT_FALSE(fs::exists(lesson / "figures/of_old.png"));
  EXPECT_EQ(contents(lesson / "mine.html"), "mine");
  EXPECT_EQ(contents(folder / "outside"), "not a lesson's");
}

TEST(Output, AnUnreadableManifestIsNone) {
  const Folder folder;
  const fs::path lesson = fixture(folder);
  for (const char* text :
       {"", "{", "[]", "{\"lesson\":3}", R"({"lesson":"x","runs":[3]})", R"({"lesson":"x","runs":7})",
        R"({"lesson":"x","runs":[{"files":[1],"clocked":{"a":2}}]})"}) {
    std::ofstream(lesson / "manifest.json") << text;
    fixture(folder, "--step 1a");
    EXPECT_NO_THROW(nlohmann::json::parse(contents(lesson / "manifest.json"))) << text;
    fixture(folder);
    EXPECT_TRUE(manifest_holds(lesson)) << text;
  }
}

TEST(Output, VerifyNamesEveryFileThatDiffers) {
  const Folder folder;
  const fs::path lesson = fixture(folder);
  const auto verify = [&] { return run(std::string(BYHAND_COURSE) + " verify " + folder.path().string()); };
  EXPECT_EQ(verify().status, 0);
  EXPECT_THAT(verify().said, HasSubstr("99_fixture: 13 files as they were written"));
  std::ofstream(lesson / "page.html") << "a reader's own";
  EXPECT_EQ(verify().status, 0);
  std::string frame = contents(lesson / "frames/settling/0002.png");
  frame[100] ^= 1;
  std::ofstream(lesson / "frames/settling/0002.png") << frame;
  fs::remove(lesson / "data/errors.csv");
  std::ofstream(lesson / "figures/foreign.png") << "";
  const Finished differing = verify();
  EXPECT_EQ(differing.status, 1);
  EXPECT_THAT(differing.said, AllOf(HasSubstr("99_fixture/frames/settling/0002.png is not as it was written\n"),
                                    HasSubstr("99_fixture/data/errors.csv is missing\n"),
                                    HasSubstr("99_fixture/figures/foreign.png is not listed\n")));
  EXPECT_EQ(std::count(differing.said.begin(), differing.said.end(), '\n'), 3);
  fs::remove(lesson / "manifest.json");
  EXPECT_EQ(verify().status, 1);
  EXPECT_EQ(run(std::string(BYHAND_COURSE) + " verify " + (folder / "nowhere").string()).status, 2);
}

TEST(Output, FramesOfALongerRunAreRemoved) {
  const Folder folder;
  const fs::path frames = fixture(folder, "--set steps=9") / "frames/settling";
  EXPECT_TRUE(fs::exists(frames / "0009.png"));
  fixture(folder, "--set steps=3");
  EXPECT_TRUE(fs::exists(frames / "0003.png"));
  EXPECT_FALSE(fs::exists(frames / "0004.png"));
}

TEST(Output, FramesLastWritesTheLastFrameOfAllAndTheSameStrip) {
  const Folder folder;
  const auto all = all_files(fixture(folder)), last = all_files(fixture(folder, "--frames last"));
  EXPECT_EQ(last.at("frames/settling/0005.png"), all.at("frames/settling/0005.png"));
  EXPECT_EQ(last.at("frames/settling.png"), all.at("frames/settling.png"));
  EXPECT_FALSE(last.contains("frames/settling/0004.png"));
  const auto none = all_files(fixture(folder, "--frames none"));
  for (const auto& [name, bytes] : none) EXPECT_THAT(name, testing::Not(testing::StartsWith("frames/")));
}

TEST(Output, NothingButWholeFilesIsLeft) {
  const Folder folder;
  for (const auto& [name, bytes] : all_files(fixture(folder))) {
    EXPECT_THAT(name, testing::Not(HasSubstr(".part")));
    EXPECT_FALSE(bytes.empty()) << name;
  }
}

}  // namespace
}  // namespace byhand::tests
