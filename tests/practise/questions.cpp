// The predictions of all lessons as questions of a learning platform.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "tests/practise/learner.hpp"

namespace byhand::tests {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

const std::filesystem::path lessons = std::filesystem::path(BYHAND_PRACTISE).parent_path();

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

Json of_lesson(const std::string& slug) {
  return Json::parse(run((lessons / slug).string() + " --questions --quiet").said);
}

void expect_xml(const std::string& file) {
  if (run("xmllint --version").status != 0) GTEST_SKIP() << "xmllint is not installed";
  const Finished checked = run("xmllint --noout " + file);
  EXPECT_EQ(checked.status, 0) << checked.complained;
}

std::string exported(const char* kind, const Folder& folder) {
  const Finished finished =
      run(fmt::format("{} --export {} --to {}", BYHAND_PRACTISE, kind, folder.path().string()));
  EXPECT_EQ(finished.status, 0) << finished.complained;
  return folder.path().string();
}

TEST(Questions, OfALessonHaveAnswersUnitsAndReplies) {
  const Json all = of_lesson("02_single_constraint");
  ASSERT_FALSE(all.empty());
  for (const Json& question : all) {
    EXPECT_GT(question["tolerance"].get<double>(), 0);
    EXPECT_FALSE(question["ask"].get<std::string>().empty());
    for (const Json& wrong : question["wrong"]) EXPECT_FALSE(wrong["reply"].get<std::string>().empty());
  }
}

TEST(Questions, OfAllLessonsReachMoodleWithTheirReplies) {
  const Folder folder, again;
  const std::string file = exported("moodle", folder) + "/predictions.xml", text = contents(file);
  expect_xml(file);
  std::size_t asking = 0, questions = 0, wrong = 0;
  for (const auto& entry : std::filesystem::directory_iterator(lessons)) {
    const std::string slug = entry.path().filename();
    if (!std::regex_match(slug, std::regex("[0-9][0-9]_[a-z_]+")) || !entry.is_regular_file()) continue;
    const Json asked = of_lesson(slug);
    asking += !asked.empty();
    for (const Json& question : asked) {
      ++questions;
      wrong += question["wrong"].size();
    }
  }
  EXPECT_GT(questions, 20U);
  EXPECT_EQ(count(text, "<question type=\"numerical\">"), questions);
  EXPECT_EQ(count(text, "fraction=\"100\""), questions);
  EXPECT_EQ(count(text, "fraction=\"0\""), wrong);
  EXPECT_EQ(count(text, "<question type=\"category\">"), asking);
  exported("moodle", again);
  EXPECT_EQ(contents(again / "predictions.xml"), text) << "the same bytes each time";
}

TEST(Questions, OfAllLessonsReachQtiAsOneItemEach) {
  const Folder folder;
  const std::string manifest = exported("qti", folder) + "/imsmanifest.xml";
  const std::size_t items = count(contents(manifest), "<resource ");
  EXPECT_GT(items, 20U);
  for (std::size_t i = 1; i <= items; ++i) {
    const std::string file = (folder / fmt::format("prediction_{:03}.xml", i)).string(), text = contents(file);
    expect_xml(file);
    EXPECT_EQ(count(text, "<modalFeedback "), 1 + count(text, "<responseElseIf>")) << file;
  }
}

}  // namespace
}  // namespace byhand::tests
