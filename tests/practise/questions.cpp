// The predictions of all lessons as questions of a learning platform.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/long_run.hpp"
#include "tests/practise/learner.hpp"

namespace byhand::tests {
namespace {

using Json = nlohmann::json;

namespace fs = std::filesystem;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// What the lessons beside the practise program ask, each told once; nothing of those that take too long.
std::map<std::string, std::string> questions_of_all_lessons() {
  std::map<std::string, std::string> asked;
  for (const auto& entry : fs::directory_iterator(fs::path(BYHAND_PRACTISE).parent_path()))
    if (const std::string slug = entry.path().filename();
        entry.is_regular_file() && std::regex_match(slug, std::regex("[0-9][0-9]_[a-z_]+")))
      asked[slug] = takes_too_long(slug) ? "[]" : run(entry.path().string() + " --questions --quiet").said;
  return asked;
}

/// The practise program beside lessons that say `asked` at once.
class Course {
 public:
  explicit Course(const std::map<std::string, std::string>& asked) {
    fs::copy_file(BYHAND_PRACTISE, folder_ / "practise");
    for (const auto& [slug, questions] : asked) {
      std::ofstream(folder_ / (slug + ".json")) << questions;
      std::ofstream(folder_ / slug) << "#!/bin/sh\nexec cat \"$0.json\"\n";
      fs::permissions(folder_ / slug, fs::perms::owner_all);
    }
  }

  void export_as(const std::string& kind, const Folder& folder) const {
    const Finished finished =
        run(fmt::format("{} --export {} --to {}", (folder_ / "practise").string(), kind, folder.path().string()));
    EXPECT_EQ(finished.status, 0) << finished.complained;
  }
  /// Where what the lessons say stands in files.
  std::string files() const { return folder_.path().string(); }

 private:
  Folder folder_;
};

void expect_xml(const std::string& file) {
  if (run("xmllint --version").status != 0) GTEST_SKIP() << "xmllint is not installed";
  const Finished checked = run("xmllint --noout " + file);
  EXPECT_EQ(checked.status, 0) << checked.complained;
}

TEST(Questions, OfAllLessonsReachMoodleAndQtiWithTheirRepliesAndTheSameBytesEachTime) {
  const auto asked = questions_of_all_lessons();
  std::size_t asking = 0, questions = 0, wrong = 0;
  for (const auto& [slug, text] : asked) {
    const Json all = Json::parse(text);
    asking += !all.empty();
    for (const Json& question : all) {
      ++questions;
      wrong += question["wrong"].size();
      EXPECT_GT(question["tolerance"].get<double>(), 0);
      EXPECT_FALSE(question["ask"].get<std::string>().empty());
      for (const Json& one : question["wrong"]) EXPECT_FALSE(one["reply"].get<std::string>().empty());
    }
  }
  EXPECT_GT(questions, 20U);

  const Course course(asked);
  const Folder first, again, from_files, items;
  course.export_as("moodle", first);
  const fs::path file = first / "predictions.xml";
  const std::string text = contents(file);
  expect_xml(file);
  EXPECT_EQ(count(text, "<question type=\"numerical\">"), questions);
  EXPECT_EQ(count(text, "fraction=\"100\""), questions);
  EXPECT_EQ(count(text, "fraction=\"0\""), wrong);
  EXPECT_EQ(count(text, "<question type=\"category\">"), asking);
  course.export_as("moodle", again);
  EXPECT_EQ(contents(again / "predictions.xml"), text);

  course.export_as("moodle --questions " + course.files(), from_files);
  EXPECT_EQ(contents(from_files / "predictions.xml"), text);

  course.export_as("qti", items);
  EXPECT_EQ(count(contents(items / "imsmanifest.xml"), "<resource "), questions);
  for (std::size_t i = 1; i <= questions; ++i) {
    const fs::path item = items / fmt::format("prediction_{:03}.xml", i);
    expect_xml(item);
    EXPECT_EQ(count(contents(item), "<modalFeedback "), 1 + count(contents(item), "<responseElseIf>")) << item;
  }
}

}  // namespace
}  // namespace byhand::tests
