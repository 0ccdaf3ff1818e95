// Every lesson of the course, found by its folder.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "lessons/page/about.hpp"
#include "lessons/page/equation_places.hpp"
#include "tests/lessons/terminal/process.hpp"

namespace byhand::tests {
namespace {

namespace fs = std::filesystem;

/// The last lessons first, which run longest: ctest begins them in this order.
std::vector<std::string> slugs() {
  std::vector<std::string> all;
  std::istringstream listed(BYHAND_LISTED);
  for (std::string slug; std::getline(listed, slug, ',');) all.insert(all.begin(), slug);
  return all;
}

/// The label of the first step of a page that displays each equation of the article.
std::map<int, std::string> first_places(const std::string& page) {
  std::map<int, std::string> places;
  const std::regex heading(R"(## (\d+[a-z]*) .*)"), tag(R"(.*\\tag\{(\d+)\}.*)");
  std::istringstream lines(page);
  std::string step;
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_match(line, match, heading)) step = match[1];
    if (std::regex_match(line, match, tag)) places.emplace(std::stoi(match[1]), step);
  }
  return places;
}

class EveryLesson : public testing::TestWithParam<std::string> {
 protected:
  static std::string program() { return std::string(BYHAND_LESSON_FOLDER) + "/" + GetParam(); }
  static Finished lesson(const std::string& options) { return run(program() + " " + options); }
};

TEST_P(EveryLesson, IsCalledAsItsFolder) {
  const auto& course = course::contents();
  const auto listed = std::find_if(course.begin(), course.end(),
                                   [](const course::About& about) { return about.slug == GetParam(); });
  ASSERT_NE(listed, course.end());
  EXPECT_FALSE(listed->title.empty());
  EXPECT_FALSE(listed->summary.empty());
  const Finished help = lesson("--help");
  EXPECT_EQ(help.status, 0) << "more than 7 core steps would be refused: " << help.complained;
  EXPECT_NE(help.said.find("output/" + GetParam()), std::string::npos);
}

TEST_P(EveryLesson, HoldsItsClaimsAndLeavesAPageWhoseLinksLeadSomewhereAndWhoseCommandsWork) {
  const Folder folder;
  const Finished finished = lesson("--quality low --frames last --output " + folder.path().string());
  ASSERT_EQ(finished.status, 0) << "1 is a false claim: " << finished.said << finished.complained;
  const fs::path output = folder / GetParam();
  const std::string page = contents(output / "lesson.md");
  const std::regex link(R"(\]\(([^)\s]+)\))"), command(R"(\n\./lessons/run (\S+)([^\n]*)\n)");
  for (std::sregex_iterator at(page.begin(), page.end(), link), end; at != end; ++at)
    EXPECT_TRUE(fs::exists(output / (*at)[1].str())) << (*at)[1];

  // Its settings are allowed; the test Settings.* of the lesson runs the steps that they change.
  int commands = 0;
  for (std::sregex_iterator at(page.begin(), page.end(), command), end; at != end; ++at, ++commands) {
    const Finished tried =
        run(std::string(BYHAND_REAL_COURSE) + " " + (*at)[1].str() + (*at)[2].str() + " --list-parameters");
    EXPECT_EQ(tried.status, 0) << (*at)[0] << tried.complained;
  }
  EXPECT_GE(commands, 2);

  const int lesson_number = std::stoi(GetParam());
  const std::map<int, std::string> found = first_places(page);
  for (int i = 0; i < 23; ++i) {
    const auto& [first_lesson, step, says] = course::equation_places[static_cast<std::size_t>(i)];
    const auto here = found.find(i + 1);
    const std::string stands = here == found.end() ? "nowhere" : here->second;
    if (first_lesson < lesson_number) continue;
    EXPECT_EQ(stands, first_lesson == lesson_number ? step : "nowhere") << "(" << i + 1 << ")";
  }
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(EveryLesson);
INSTANTIATE_TEST_SUITE_P(Lessons, EveryLesson, testing::ValuesIn(slugs()),
                         [](const auto& slug) { return slug.param; });

}  // namespace
}  // namespace byhand::tests
