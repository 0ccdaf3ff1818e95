// What a run leaves behind: the page, pictures, data and what made them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>

#include "tests/lessons/tutor/process.hpp"

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

/// Every file below the folder with its bytes.
std::map<std::string, std::string> all_files(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files[fs::relative(entry.path(), folder).string()] = contents(entry.path());
  return files;
}

/// The same without what a clock measured, by the lesson's own word.
std::map<std::string, std::string> unclocked_files(const fs::path& folder) {
  auto files = all_files(folder);
  const auto manifest = nlohmann::json::parse(files.at("manifest.json"));
  for (const std::string name : manifest.at("clocked")) EXPECT_EQ(files.erase(name), 1u) << name;
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
  const auto json = nlohmann::json::parse(contents(fixture(folder, "--set h=1/120") / "manifest.json"));
  EXPECT_EQ(json.at("options").at("quality"), "low");
  EXPECT_EQ(json.at("options").at("parameters").at("beta").at("value"), 0.2);
  EXPECT_EQ(json.at("options").at("parameters").at("bob").at("value"), "disc");
  EXPECT_EQ(json.at("time_step").at("value"), 1.0 / 120);
  EXPECT_EQ(json.at("time_step").at("unit"), "s");
  EXPECT_EQ(json.at("method"), "correction");
  EXPECT_THAT(json.at("gl").get<std::string>(), HasSubstr("OpenGL"));
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
