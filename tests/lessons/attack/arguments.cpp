// Command lines from a grammar, and with mutations: status 0 and no complaint, or status 2 and one printable line.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/lessons/terminal/process.hpp"

namespace byhand::tests {
namespace {

using testing::IsEmpty;
using Words = std::vector<std::string>;

class Grammar {
 public:
  explicit Grammar(unsigned seed) : random_(seed) {}

  bool chance(int of_hundred) { return below(100) < of_hundred; }
  int below(int end) { return static_cast<int>(random_() % static_cast<unsigned>(end)); }
  const std::string& any(const Words& words) {
    return words[static_cast<size_t>(below(static_cast<int>(words.size())))];
  }

  /// A line that the help allows. It only checks claims or lists parameters, so it writes nothing.
  Words good() {
    Words line = {any({"--check", "--list-parameters"})};
    if (chance(30)) line.push_back("--quiet");
    if (chance(20)) line.push_back("--no-interactive");
    for (const auto& [option, values] : valued())
      if (chance(30)) add(line, option, any(values));
    for (const auto& [name, values] : parameters())
      if (chance(40)) add(line, "--set", name + "=" + any(values));
    return line;
  }

  /// A word, or two, that no line may hold.
  Words bad() {
    const auto& [option, values] = valued()[static_cast<size_t>(below(static_cast<int>(valued().size())))];
    switch (below(7)) {
      case 0:
        return {
            any({"--chec", "--Check", "-c", "check", "--", "-", "", "--interactive", "---quiet", "--set-", "é"})};
      case 1: return {option, any({"", "-", "--check"})};
      case 2:
        return {"--set", any({"", "=", "beta", "gamma=1", "=1", "beta==1", "[beta=1]", " beta=1", "BETA=1"})};
      case 3:
        return {"--set",
                "beta=" + any({"", "x", "nan", "inf", "-1", "3.0001", "1/0", "1e999", "0x1", "1 2", "1,5,2"})};
      case 4:
        return {any({"--check", "--quiet", "--list-parameters", "--no-interactive"}) + "=" +
                any({"", "1", "false"})};
      case 5: return {"--set", any({"steps=1.5", "steps=0", "bob=sphere", "h=1kg", "bob=", "h=5"})};
      default: return {option + "=x", option, any(values)};
    }
  }

  /// A byte of a word changed, left out or doubled; a word left out, doubled, cut or exchanged.
  void mutate(Words& line) {
    const auto at = [&] { return static_cast<std::ptrdiff_t>(below(static_cast<int>(line.size()))); };
    std::string& word = line[static_cast<size_t>(at())];
    const auto byte = word.empty() ? 0 : static_cast<size_t>(below(static_cast<int>(word.size())));
    switch (below(7)) {
      case 0: word.insert(byte, 1, static_cast<char>(1 + below(255))); break;
      case 1: word.erase(byte, 1); break;
      case 2: word.resize(byte); break;
      case 3: line.insert(line.begin() + at(), line[static_cast<size_t>(at())]); break;
      case 4: std::swap(line[static_cast<size_t>(at())], line[static_cast<size_t>(at())]); break;
      case 5: word.append(static_cast<size_t>(below(5000)), 'x'); break;
      default:
        if (line.size() > 1) line.erase(line.begin() + at());
    }
  }

 private:
  using Values = std::vector<std::pair<std::string, Words>>;
  static const Values& valued() {
    static const Values all = {{"--quality", {"low", "medium", "high"}},
                               {"--frames", {"none", "last", "all"}},
                               {"--step", {"1", "1a", "2"}},
                               {"--output", {"/dev/null/nowhere", "o p", "[o]", "ö"}}};
    return all;
  }
  static const Values& parameters() {
    static const Values all = {{"beta", {"0", "0.2", "1/3", "3", "+1", "1e-3"}},
                               {"h", {"1/60", "5ms", "0.1", "100 us"}},
                               {"steps", {"1", "20", "4/2"}},
                               {"bob", {"disc", "box"}}};
    return all;
  }
  void add(Words& line, const std::string& option, const std::string& value) {
    if (chance(50) && !value.empty())
      line.push_back(option + "=" + value);
    else
      line.insert(line.end(), {option, value});
  }

  std::mt19937 random_;
};

Finished fixture(Words line) {
  line.insert(line.begin(), BYHAND_FIXTURE);
  return Started(line).finish();
}

std::string shown(const Words& line) {
  std::string all;
  for (const std::string& word : line) all += "[" + word.substr(0, 200) + "] ";
  return all;
}

bool one_printable_line(const std::string& words) {
  return std::count(words.begin(), words.end(), '\n') == 1 && words.back() == '\n' &&
         std::none_of(words.begin(), words.end() - 1,
                      [](unsigned char byte) { return byte < 0x20 || byte == 0x7f; });
}

void expect_refused(const Finished& finished, const Words& line) {
  EXPECT_EQ(finished.status, 2) << shown(line);
  EXPECT_TRUE(one_printable_line(finished.complained)) << shown(line) << finished.complained;
  EXPECT_THAT(finished.said, IsEmpty()) << shown(line);
}

TEST(Arguments, ALineOfTheGrammarIsAcceptedAndOneWithABadWordRefused) {
  Grammar grammar(seeded(1));
  for (int i = 0; i < attempts(300) && !testing::Test::HasFailure(); ++i) {
    Words line = grammar.good();
    const Finished accepted = fixture(line);
    EXPECT_EQ(accepted.status, 0) << shown(line) << accepted.complained;
    EXPECT_THAT(accepted.complained, IsEmpty());
    // In front, where it cannot become another option's value.
    const Words bad = grammar.bad();
    line.insert(line.begin(), bad.begin(), bad.end());
    expect_refused(fixture(line), line);
  }
}

TEST(Arguments, AMutatedLineIsAcceptedOrRefusedInOnePrintableLine) {
  Grammar grammar(seeded(2));
  int refused = 0;
  for (int i = 0; i < attempts(400) && !testing::Test::HasFailure(); ++i) {
    Words line = grammar.good();
    std::erase(line, "--list-parameters");
    line.push_back("--quiet");
    for (int times = 1 + grammar.below(4); times > 0; --times) grammar.mutate(line);
    // What is no longer a check would draw; that is for other tests.
    line.insert(line.begin(), "--check");
    const Finished finished = fixture(line);
    if (finished.status == 0) {
      EXPECT_THAT(finished.complained, IsEmpty()) << shown(line);
    } else {
      ++refused;
      expect_refused(finished, line);
    }
  }
  EXPECT_GT(refused, attempts(100));
}

TEST(Arguments, ASuggestionIsTheOptionThatWasMeant) {
  for (const std::string option : {"--quality", "--frames", "--output", "--check", "--quiet"}) {
    for (size_t left_out = 2; left_out < option.size(); ++left_out) {
      std::string typed = option;
      typed.erase(left_out, 1);
      const Finished finished = fixture({typed});
      expect_refused(finished, {typed});
      EXPECT_THAT(finished.complained, testing::HasSubstr("(do you mean " + option + "?)")) << typed;
    }
  }
}

}  // namespace
}  // namespace byhand::tests
