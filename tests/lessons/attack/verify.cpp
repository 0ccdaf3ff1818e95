// `./lessons/run verify` and a lesson on folders and manifests that somebody made by hand.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <nlohmann/json.hpp>
#include <random>

#include "tests/lessons/files/written.hpp"
#include "tests/lessons/terminal/process.hpp"

namespace byhand::tests {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using Json = nlohmann::json;

Finished verify(const fs::path& folder) {
  return Started({BYHAND_REAL_COURSE, "verify", folder.string()}).finish();
}

void expect_one_line(const std::string& words) {
  EXPECT_EQ(std::count(words.begin(), words.end(), '\n'), 1) << words;
  EXPECT_THAT(words, Not(HasSubstr("filesystem error")));
}

class Verify : public testing::Test {
 protected:
  Verify() { fs::create_directory(folder_ / "output"); }
  fs::path output() const { return folder_ / "output"; }
  fs::path lesson() const { return output() / "99_fixture"; }
  Finished write_lesson() const {
    return Started({BYHAND_FIXTURE, "--quiet", "--quality", "low", "--output", output().string()}).finish();
  }
  void write_manifest(const std::string& text) const {
    fs::create_directories(lesson());
    std::ofstream(lesson() / "manifest.json") << text;
  }

  const Folder folder_;
};

std::string nested(const std::string& before, int levels, const std::string& open, const std::string& close,
                   const std::string& after) {
  std::string text = before;
  for (int i = 0; i < levels; ++i) text += open;
  for (int i = 0; i < levels; ++i) text += close;
  return text + after;
}

TEST_F(Verify, AManifestOfDeepBracketsIsNone) {
  for (const int levels : {20, 30'000, 1'000'000}) {
    for (const std::string& text : {nested(R"({"lesson":"x","runs":)", levels, "[", "]", "}"),
                                    nested(R"({"lesson":"x","runs":[{"step":)", levels, "[", "]", "}]}"),
                                    nested(R"({"lesson":"x","runs":[{"files":)", levels, "{\"a\":", "", "1") +
                                        std::string(levels, '}') + "}]}",
                                    nested(R"({"site":"x","files":)", levels, "[", "]", "}")}) {
      SCOPED_TRACE(text.substr(0, 50));
      write_manifest(text);
      const Finished finished = verify(output());
      EXPECT_EQ(finished.status, 1);
      EXPECT_THAT(finished.said, HasSubstr("is no manifest of a lesson"));
      expect_one_line(finished.said);
    }
  }
  EXPECT_EQ(write_lesson().status, 0);
  EXPECT_TRUE(manifest_holds(lesson())) << "the lesson writes anew";
}

TEST_F(Verify, TakesTimeInProportionToTheFiles) {
  const auto seconds = [&](int files) {
    std::string text = R"({"lesson":"99_fixture","runs":[{"step":null,"clocked":{},"files":{)";
    for (int i = 0; i < files; ++i) text += fmt::format("{}\"frames/x/{:06}.png\":\"\"", i ? "," : "", i);
    write_manifest(text + "}}]}");
    rusage before{}, after{};
    getrusage(RUSAGE_CHILDREN, &before);
    EXPECT_EQ(verify(output()).status, 1);
    getrusage(RUSAGE_CHILDREN, &after);
    const auto used = [](const rusage& usage) {
      return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
    };
    return used(after) - used(before);
  };
  EXPECT_LT(seconds(160'000), 8 * (seconds(40'000) + 0.05)) << "four times the files: four times, not sixteen";
}

TEST_F(Verify, JudgesEveryLessonBesideALinkInACircle) {
  ASSERT_EQ(write_lesson().status, 0);
  fs::create_symlink("loop", output() / "loop");
  fs::create_directory(output() / "01_jacobian");
  fs::create_symlink("manifest.json", output() / "01_jacobian/manifest.json");
  fs::create_symlink("lesson.md", lesson() / "figures/circle.png");
  fs::remove(lesson() / "lesson.md");
  fs::create_symlink("lesson.md", lesson() / "lesson.md");
  const Finished finished = verify(output());
  EXPECT_EQ(finished.status, 1);
  EXPECT_THAT(finished.said, AllOf(HasSubstr("01_jacobian/manifest.json"), HasSubstr("99_fixture/lesson.md"),
                                   Not(HasSubstr("filesystem error"))));
  EXPECT_THAT(finished.complained, IsEmpty());
}

TEST_F(Verify, AFolderThatIsALinkInACircleIsOneSentence) {
  fs::create_symlink("loop", folder_ / "loop");
  for (const fs::path& folder : {folder_ / "loop", folder_ / "loop/below", folder_ / "none"}) {
    const Finished finished = verify(folder);
    EXPECT_EQ(finished.status, 2);
    expect_one_line(finished.complained);
  }
}

TEST_F(Verify, KnowsItsOptionsFromFolders) {
  const auto course = [](const std::string& words) { return run(std::string(BYHAND_REAL_COURSE) + " " + words); };
  const Finished help = course("verify --help");
  EXPECT_EQ(help.status, 0);
  EXPECT_THAT(help.said, HasSubstr("verify [FOLDER]"));
  for (const char* words : {"verify --bogus", "verify --", "verify -x", "verify ''", "verify a b"}) {
    const Finished finished = course(words);
    EXPECT_EQ(finished.status, 2) << words;
    expect_one_line(finished.complained);
    EXPECT_THAT(finished.complained, Not(HasSubstr("there is no such folder"))) << words;
  }
}

TEST_F(Verify, HoldsASiteAgainstItsOwnList) {
  fs::create_directories(output() / "site/assets");
  std::ofstream(output() / "site/index.html") << "page";
  std::ofstream(output() / "site/assets/a.css") << "style";
  std::ofstream(output() / "site/CNAME") << "a person's";
  const auto sum = [&](const char* name) {
    return run("sha256sum <" + (output() / "site" / name).string()).said.substr(0, 64);
  };
  const Json manifest = {{"site", "Constraints by Hand"},
                         {"commit", "x"},
                         {"files", {{"index.html", sum("index.html")}, {"assets/a.css", sum("assets/a.css")}}}};
  std::ofstream(output() / "site/manifest.json") << manifest;
  ASSERT_EQ(write_lesson().status, 0);
  const Finished whole = verify(output());
  EXPECT_EQ(whole.status, 0) << whole.said;
  EXPECT_THAT(whole.said, HasSubstr("site: 2 files as they were written"));
  EXPECT_EQ(verify(output() / "site").status, 0);
  std::ofstream(output() / "site/index.html") << "changed";
  fs::remove(output() / "site/assets/a.css");
  const Finished changed = verify(output());
  EXPECT_EQ(changed.status, 1);
  EXPECT_THAT(changed.said, AllOf(HasSubstr("site/index.html is not as it was written"),
                                  HasSubstr("site/assets/a.css is missing")));
}

TEST_F(Verify, ADamagedManifestIsNamedAndNothingElseHappens) {
  ASSERT_EQ(write_lesson().status, 0);
  const std::string whole = contents(lesson() / "manifest.json");
  std::mt19937 random(seeded(30112026));
  const auto below = [&](size_t end) { return random() % end; };
  for (int i = 0; i < attempts(60); ++i) {
    std::string text = whole;
    for (size_t times = 1 + below(3); times > 0; --times) {
      const size_t at = below(text.size());
      switch (below(4)) {
        case 0: text[at] = static_cast<char>(below(256)); break;
        case 1: text.erase(at, below(200)); break;
        case 2: text.insert(at, text.substr(below(text.size()), below(200))); break;
        default: text.resize(at + 1);
      }
    }
    std::ofstream(lesson() / "manifest.json") << text;
    const Finished finished = verify(output());
    EXPECT_THAT(finished.status, testing::AnyOf(0, 1)) << text;
    EXPECT_THAT(finished.complained, IsEmpty()) << text;
    if (text == whole) {
      EXPECT_EQ(finished.status, 0);
    }
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace byhand::tests
