// A learner goes through every lesson, deeper steps included, and answers each question wrong, nearly right and
// right.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "lessons/terminal/typeset.hpp"
#include "tests/lessons/terminal/process.hpp"
#include "tests/lessons/terminal/terminal.hpp"
#include "tests/long_run.hpp"

namespace byhand::tests {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr auto prompt = "▸ ";

std::vector<std::string> slugs() {
  std::vector<std::string> all;
  std::istringstream listed(BYHAND_LISTED);
  for (std::string slug; std::getline(listed, slug, ',');)
    if (!takes_too_long(slug)) all.push_back(slug);
  return all;
}

/// The right answers as the lesson's page prints them: "0.205 m²"; of a choice, the option's number.
std::vector<std::string> answers(const std::string& page) {
  static const std::regex summary(R"(<summary>Answer</summary>\n\n([^]*?)\n</details>)");
  static const std::regex choice(R"(\*\*(\d+)\. )"), number(R"(^\*\*([^*]*)\*\*\.)");
  std::vector<std::string> all;
  for (std::sregex_iterator at(page.begin(), page.end(), summary), end; at != end; ++at) {
    const std::string words = (*at)[1];
    std::smatch found;
    if (std::regex_search(words, found, choice) || std::regex_search(words, found, number))
      all.push_back(found[1]);
  }
  return all;
}

class Learner : public testing::TestWithParam<std::string> {};

TEST_P(Learner, GetsToTheEndWithWrongNearlyRightAndRightAnswers) {
  const Folder folder;
  const std::string program = std::string(BYHAND_LESSON_FOLDER) + "/" + GetParam();
  const std::string output = (folder / "output").string();
  ASSERT_EQ(run(program + " --no-interactive --quality low --frames none --output " + output).status, 0);
  const std::vector<std::string> right = answers(contents(folder / "output" / GetParam() / "lesson.md"));
  ASSERT_FALSE(right.empty());

  Terminal reader({program, "--quality", "low", "--frames", "none", "--output", output},
                  {{"TERM", "dumb"}, {"XDG_STATE_HOME", (folder / "state").string()}}, {100, 40});
  size_t next = 0;
  while (true) {
    const std::string said = reader.said_until_one_of({"What you now know", prompt});
    if (said.ends_with("What you now know")) break;
    if (said.find("Enter goes on") != std::string::npos) {
      reader.enter(said.find("`deeper` shows") != std::string::npos ? "deeper" : "");
      continue;
    }
    ASSERT_LT(next, right.size()) << said;
    const std::string& answer = right[next++];
    const bool choice = said.find("Your choice") != std::string::npos;
    reader.enter("nonsense");
    reader.expect(choice ? "is not one of them" : "is not a number");
    reader.expect(prompt);
    if (choice) {
      reader.enter(answer == "1" ? "2" : "1");
      reader.expect("No.");
    } else {
      // Ten times as much and five more is wrong even if the answer is zero.
      reader.enter("987654321");
      reader.expect("No.");
      reader.expect(prompt);
      // The sign is wrong, unless it has none or nobody can tell.
      const bool negative = answer.starts_with("−");
      reader.enter(negative ? answer.substr(std::string("−").size()) : "-" + answer);
      const std::string reply = reader.said_until_one_of({"Yes.", "No."});
      if (reply.ends_with("Yes.")) continue;
    }
    reader.expect(prompt);
    reader.enter("hint");
    reader.expect(prompt);
    reader.enter(answer);
    EXPECT_TRUE(reader.said_until_one_of({"Yes.", "No.", "is not"}).ends_with("Yes."))
        << answer << " was refused after: " << said;
  }
  EXPECT_EQ(next, right.size());
  EXPECT_EQ(reader.leave(), 0);
  std::istringstream lines(reader.transcript());
  for (std::string line; std::getline(lines, line);)
    EXPECT_TRUE(line.find(output) != std::string::npos || line.find("./lessons/run") != std::string::npos ||
                course::display_width(line) <= 100)
        << line;
}

INSTANTIATE_TEST_SUITE_P(Lessons, Learner, testing::ValuesIn(slugs()),
                         [](const auto& slug) { return slug.param; });

}  // namespace
}  // namespace byhand::tests
