// Derivations of constraints that the course does not have, two of them from engines: right lines are accepted to
// the end, each wrong one is named, and what was derived runs.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "lessons/desk/scenes.hpp"

namespace byhand::desk {
namespace {

namespace fs = std::filesystem;
using Outcome = Check::Outcome;

struct Line {
  std::string text, wrong;  // the name of the error, if it is wrong
};

std::vector<Line> transcript(const fs::path& path) {
  std::vector<Line> lines;
  std::ifstream file(path);
  const std::string begin = "wrong (";
  for (std::string line; std::getline(file, line);) {
    const std::size_t end = line.find("): ");
    if (line.starts_with(begin))
      lines.push_back({line.substr(end + 3), line.substr(begin.size(), end - begin.size())});
    else if (!line.starts_with("#"))
      lines.push_back({line, ""});
  }
  return lines;
}

TEST(DeskTranscripts, EachWrongLineIsNamedAndTheRestDerivesAConstraintThatRuns) {
  int derivations = 0, wrong = 0;
  for (const auto& entry : fs::directory_iterator(BYHAND_DESK_TRANSCRIPTS)) {
    const std::vector<Line> lines = transcript(entry.path());
    std::vector<std::string> right;
    for (const Line& line : lines) {
      Sheet sheet;
      for (const std::string& before : right) sheet.add(before);
      const std::vector<Check> checks = sheet.add(line.text);
      if (line.wrong.empty()) {
        for (const Check& check : checks)
          EXPECT_TRUE(check.outcome == Outcome::right || check.outcome == Outcome::told) << entry.path() << "\n"
                                                                                         << line.text << "\n"
                                                                                         << check.sentence;
        right.push_back(line.text);
        continue;
      }
      ++wrong;
      ASSERT_FALSE(checks.empty()) << line.text;
      EXPECT_EQ(checks.back().outcome, Outcome::wrong) << line.text;
      EXPECT_EQ(checks.back().finding.name, line.wrong) << entry.path() << "\n" << checks.back().sentence;
    }
    Sheet sheet;
    for (const std::string& line : right) sheet.add(line);
    ASSERT_TRUE(sheet.complete()) << entry.path();
    for (const char* scene : {"pendulum", "box"}) {
      const Ran ran = run_in(sheet, scene);
      EXPECT_LT(ran.largest_C, 0.02) << entry.path() << " " << scene;
    }
    ++derivations;
  }
  EXPECT_EQ(derivations, 5);
  EXPECT_GE(wrong, derivations);
}

}  // namespace
}  // namespace byhand::desk
