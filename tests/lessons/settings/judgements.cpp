#include "tests/lessons/settings/judgements.hpp"

#include <algorithm>
#include <cmath>
#include <regex>
#include <string_view>

#include "tests/lessons/settings/numbers.hpp"

namespace byhand::tests {
namespace {

using std::string;

/// Words that judge.
const std::regex& judging() {
  static const std::regex words(
      R"(\b(sticks|stuck|stands (for [0-9]+|still|until|after|there)|still stands|stood|falls? (over|apart|after)|fell|)"
      R"(is down after|settles?|settled|hardly|nearly|almost|barely|scarcely|better|worse|)"
      R"((less|more|fewer|smaller|larger|greater|faster|slower) than|about (twice|half|\S+ times)|)"
      R"(as the next step shows|at the same (time|speed)|enough|too (little|few|many|large|small|far)|agrees?)\b)");
  return words;
}

std::vector<string> sentences(const string& passage) {
  std::vector<string> all;
  size_t begin = 0;
  for (size_t i = 0; i < passage.size(); ++i) {
    const bool ends = string(".?!:;").find(passage[i]) != string::npos &&
                      (i + 1 == passage.size() || string(" )").find(passage[i + 1]) != string::npos);
    if (!ends && passage[i] != '\n') continue;
    all.push_back(passage.substr(begin, i + 1 - begin));
    begin = i + 1;
  }
  all.push_back(passage.substr(begin));
  return all;
}

/// Sentences that judge without being a verdict, and why they may.
struct MayJudge {
  const char* part;
  const char* because;
};
constexpr MayJudge sentences_that_may_judge[] = {
    {"is drawn", "it tells how the picture is drawn"},
    {"starts from the same", "it tells how the film is made"},
    {"less than 10⁻", "how a number is printed that rounding hides"},
    {"agree to rounding", "the claim below holds it to 10⁻¹⁵"},
    {"settles for every β below 2", "lesson 3's law, with its number"},
    {"changes by more than that share", "what the tolerance of conjugate sweeps means"},
    {"a step a kicked stack needs to stand", "what the chart counts"},
    {"more than 64)", "where the chart's count ends"},
    {"the errors of", "made by the film's own run, curve by curve"},
    {"the stack falls after", "made by the film's own run, stack by stack"},
    {"more than it needs", "law 18, which step 1 of lesson 8 claims"},
    {"if it is pulled with more than", "the scene's own rule"},
    {"lets heavier boxes settle", "law 9, in numbers"},
    {"too little to see", "the caption counts the points of its picture"},
    {"With each change clamped", "made by the film's own run, box by box"},
};

/// Whether a sentence says a number that the run computed.
bool says_a_result(const string& sentence, const std::vector<string>& given) {
  static const std::regex names(
      R"((steps?|lessons?|laws?|exercises?|figures?|equations?|row|rows|Step|Lesson|Row|Body|body) $)");
  for (const Number& number : numbers(sentence)) {
    const string before = sentence.substr(0, number.begin), after = sentence.substr(number.end);
    const bool equation = before.ends_with("(") && after.starts_with(")");
    const bool whole = number.typed.size() == 1 || (number.typed.size() == 2 && number.typed.ends_with('.'));
    const bool set = std::any_of(given.begin(), given.end(), [&](const string& value) {
      const auto typed = numbers(value);
      return typed.size() == 1 && std::abs(typed[0].magnitude - number.magnitude) < 1e-3;
    });
    if (!equation && !whole && !set && !std::regex_search(before, names)) return true;
  }
  return false;
}

}  // namespace

std::vector<Finding> unclaimed_judgements(const course::Page& page, const std::vector<string>& given) {
  string verdicts;
  for (const course::Item& item : page.items())
    if (const auto* claim = std::get_if<course::Claim>(&item); claim && claim->judged)
      verdicts += claim->quantity + "\n";
  std::vector<Finding> found;
  const auto read = [&](const string& words) {
    for (const string& sentence : sentences(words)) {
      const size_t first = sentence.find_first_not_of(" -()");
      if (first == string::npos) continue;
      const string said = sentence.substr(first);
      const bool excepted = std::any_of(std::begin(sentences_that_may_judge), std::end(sentences_that_may_judge),
                                        [&](const MayJudge& e) { return said.find(e.part) != string::npos; });
      if (!excepted && std::regex_search(said, judging()) && says_a_result(said, given) &&
          verdicts.find(said.substr(0, said.size() - 1)) == string::npos)
        found.push_back({"a judgement that is no verdict", said});
    }
  };
  for (const course::Item& item : page.items()) {
    if (const auto* text = std::get_if<course::Text>(&item)) read(text->words);
    if (const auto* figure = std::get_if<course::Figure>(&item)) read(figure->caption);
    if (const auto* film = std::get_if<course::Sequence>(&item)) read(film->caption);
  }
  return found;
}

}  // namespace byhand::tests
