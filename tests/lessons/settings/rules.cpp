#include "tests/lessons/settings/rules.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string_view>

#include "lessons/page/grading.hpp"
#include "lessons/terminal/terminal_text.hpp"
#include "tests/lessons/settings/numbers.hpp"

namespace byhand::tests {
namespace {

using namespace course;
using std::string;
using std::string_view;

/// Powers of ten.
constexpr double largest = 9, smallest = -11, smallest_rounding = -30;

/// "rounding", but not "surrounding".
bool speaks_of_rounding(const string& words) {
  static const std::regex word(R"(\b[Rr]ounding\b)");
  return std::regex_search(words, word);
}

/// The sentence around a position, in one line.
string sentence_around(const string& words, size_t at) {
  const auto ends_at = [&](size_t i) {
    return words[i] == '\n' || (std::strchr(".?!", words[i]) && i + 1 < words.size() && words[i + 1] == ' ');
  };
  size_t begin = std::min(at, words.size()), end = begin;
  while (begin > 0 && !ends_at(begin - 1)) --begin;
  while (end < words.size() && !ends_at(end)) ++end;
  const string sentence = words.substr(begin, end - begin + (end < words.size() && words[end] != '\n'));
  return sentence.substr(std::min(sentence.find_first_not_of(' '), sentence.size()));
}

/// Places of `part` in `words`.
std::vector<size_t> places(const string& words, string_view part) {
  std::vector<size_t> all;
  for (size_t at = words.find(part); at != string::npos; at = words.find(part, at + 1)) all.push_back(at);
  return all;
}

void add(std::vector<Finding>& all, std::vector<Finding> more) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

/// "from 0 to ∞", "from −∞ to ∞": the interval of a λ.
bool is_bound(const string& words, size_t at) {
  const string before = words.substr(0, at);
  return before.ends_with("from 0 to ") || before.ends_with("from −∞ to ") ||
         (before.ends_with("from −") && words.compare(at, string("∞ to").size(), "∞ to") == 0);
}

std::vector<Finding> meaningless_numbers(const string& words, const std::vector<string>& given) {
  std::vector<Finding> found;
  for (const string_view bad : {"not a number", "∞", "nan ", "-inf", "infty"})
    for (const size_t at : places(words, bad))
      if (!is_bound(words, at)) found.push_back({"not a finite number", sentence_around(words, at)});
  const bool rounding = speaks_of_rounding(words);
  // "1e-14" comes back as 10⁻¹⁴.
  const auto is_given = [&](const Number& number) {
    return std::any_of(given.begin(), given.end(), [&](const string& value) {
      const std::vector<Number> set = numbers(value);
      return set.size() == 1 && std::abs(set[0].magnitude - number.magnitude) < 1e-4;
    });
  };
  for (const Number& number : numbers(words)) {
    if (is_given(number)) continue;
    if (number.magnitude > largest) found.push_back({"a number above 10⁹", sentence_around(words, number.begin)});
    if (std::isfinite(number.magnitude) && number.magnitude < (rounding ? smallest_rounding : smallest))
      found.push_back({rounding ? "a number below 10⁻³⁰, too small for rounding"
                                : "a number below 10⁻¹¹ that is not said to be rounding",
                       sentence_around(words, number.begin)});
  }
  return found;
}

bool is_plural(const string& word) {
  static const std::set<string> nouns = {
      "balls",      "bars",    "bobs",        "bodies",    "bounces", "boxes",    "cells",      "columns",
      "contacts",   "cycles",  "degrees",     "digits",    "entries", "frames",   "hinges",     "impulses",
      "iterations", "joints",  "kinds",       "knobs",     "laws",    "links",    "masses",     "methods",
      "metres",     "minutes", "numbers",     "periods",   "pins",    "planks",   "points",     "poses",
      "pucks",      "radians", "revolutions", "rods",      "ropes",   "rounds",   "row-solves", "rows",
      "runs",       "seconds", "settings",    "solves",    "springs", "stacks",   "steps",      "substeps",
      "sweeps",     "swings",  "times",       "triangles", "turns",   "unknowns", "values",     "weights",
      "words",      "parts",   "places",      "options",   "orders",  "pieces",   "rotations",  "shares",
      "sides",      "spheres", "stones",      "discs",     "arms",    "bytes",    "kilograms",  "milliseconds"};
  return nouns.contains(word);
}

/// The next words behind a position, lower case, without marks of emphasis.
std::vector<string> words_behind(const string& words, size_t at, int count) {
  std::vector<string> all;
  if (at >= words.size() || words[at] != ' ') return all;
  std::istringstream rest(words.substr(at, 80));
  for (string word; count-- > 0 && rest >> word; all.push_back(word)) {
    const bool ends = std::strchr(".,;:?!)", word.back());
    while (!word.empty() && std::strchr(".,;:?!)", word.back())) word.pop_back();
    if (ends) count = 0;
  }
  return all;
}

/// "1 boxes", "1 warm sweeps". A name before it makes it a label: "body 1 weighs".
std::vector<Finding> one_of_many(const string& marked) {
  static const std::set<string> no_adjectives = {"and",   "or",  "of",    "in",     "to",   "for",     "with",
                                                 "from",  "at",  "is",    "on",     "the",  "two",     "than",
                                                 "more",  "all", "as",    "has",    "are",  "both",    "by",
                                                 "these", "its", "their", "bounds", "ties", "carries", "×"};
  string words;
  std::copy_if(marked.begin(), marked.end(), std::back_inserter(words),
               [](char c) { return c != '*' && c != '`'; });
  std::vector<Finding> found;
  for (const Number& number : numbers(words)) {
    const string before = words.substr(0, number.begin);
    const bool part_of_another =
        number.begin > 0 && (std::strchr("./,-^=", before.back()) || before.ends_with("−") ||
                             before.ends_with("·") || before.ends_with("×"));
    if (number.typed != "1" || part_of_another) continue;
    const std::vector<string> behind = words_behind(words, number.end, 2);
    const bool next = !behind.empty() && is_plural(behind[0]);
    const bool after_adjective = behind.size() > 1 && !no_adjectives.contains(behind[0]) && is_plural(behind[1]) &&
                                 !before.ends_with("= ") && std::isalpha(static_cast<unsigned char>(behind[0][0]));
    if (next || after_adjective) found.push_back({"one of many", sentence_around(words, number.begin)});
  }
  return found;
}

/// The values that a curve draws: those with a place on both axes. An infinite one is drawn as a cross.
std::vector<double> drawn(const renderer::Curve& curve, const renderer::Chart& chart) {
  const auto has_place = [](double value, const renderer::Axis& axis) {
    return !std::isnan(value) && (axis.scale == renderer::Scale::linear || value > 0);
  };
  std::vector<double> values;
  for (size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i)
    if (has_place(curve.x[i], chart.x) && has_place(curve.y[i], chart.y)) values.push_back(curve.y[i]);
  using enum renderer::CurveStyle;
  const bool needs_two = curve.style == line || curve.style == theory || curve.style == front;
  if (values.size() < 2 && needs_two &&
      std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }))
    values.clear();
  return values;
}

std::vector<double> drawn(const renderer::Chart& chart) {
  std::vector<double> values;
  const auto include = [&](const std::vector<double>& more) {
    std::copy_if(more.begin(), more.end(), std::back_inserter(values), [](double v) { return !std::isnan(v); });
  };
  for (const renderer::Curve& curve : chart.curves) include(drawn(curve, chart));
  for (const renderer::Bars& bars : chart.bars) include(bars.values);
  if (chart.heat_map) include(chart.heat_map->values);
  return values;
}

bool shows_only_rounding(const renderer::Chart& chart, std::vector<double> values) {
  std::erase_if(values, [](double v) { return std::isinf(v); });
  if (values.empty() || (chart.heat_map && !chart.heat_map->classes.empty())) return false;
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const double size = std::max(std::abs(*least), std::abs(*most)), spread = *most - *least;
  if (size == 0) return false;
  const bool tiny = std::log10(size) < smallest;
  // An axis that grows to fit the values would blow their last digits up to a curve.
  const bool fitted = chart.bars.empty() && !chart.y.range && chart.y.scale == renderer::Scale::linear;
  return tiny || (fitted && spread > 0 && spread < 1e-12 * size);
}

/// The calculation at the end of a hint, as a reader would type it: "½(2.1² − 2²) = …" of "(2): ½(2.1² − 2²) = …".
string calculation(const string& hint) {
  const string_view asks = " = …";
  if (!hint.ends_with(asks)) return {};
  const string all = hint.substr(0, hint.size() - asks.size());
  const size_t colon = all.rfind(": ");
  return colon == string::npos ? all : all.substr(colon + 2);
}

/// Whoever follows the hints is right.
std::vector<Finding> hints_that_lead_astray(const Prediction& question) {
  if (question.hints.empty()) return {};
  const string& last = question.hints.back();
  const auto found = [&](const char* rule) {
    return std::vector<Finding>{{rule, fmt::format("{} {}: {}", question.ask, last, printed_answer(question))}};
  };
  const string typed = calculation(last);
  const Grade graded = grade(question, typed);
  if (!typed.empty() && graded.understood)
    return graded.right ? std::vector<Finding>{} : found("what the last hint gives is refused");
  if (!std::isfinite(question.hinted)) return found("nothing says what the last hint gives");
  const double off = std::abs(question.hinted - question.answer);
  if (off > std::max(0.3 * std::abs(question.answer), 1.01 * question.tolerance))
    return found("what the last hint gives is not the answer");
  return {};
}

/// A reader who chose another option learns why.
std::vector<Finding> replies_alike(const Choice& question) {
  std::vector<Finding> found;
  std::set<string> replies;
  for (const Option& option : question.options)
    if (!replies.insert(option.reply).second)
      found.push_back({"two options have one reply", fmt::format("{} {}", question.ask, option.reply)});
  return found;
}

std::vector<Finding> answers_that_meet(const Prediction& question) {
  std::vector<Finding> found;
  const auto add_with = [&](const char* rule, const string& answer) {
    found.push_back({rule, fmt::format("{} {} ± {}", question.ask, answer, number(question.tolerance))});
  };
  std::set<string> answers = {printed_answer(question)};
  if (!grade(question, *answers.begin()).right)
    add_with("the answer is refused as it is printed", *answers.begin());
  for (const WrongAnswer& wrong : question.wrong) {
    const string printed = quantity(wrong.value, question.unit, 4);
    if (!answers.insert(printed).second || grade(question, printed).right)
      add_with("two answers are the same", printed);
  }
  if (question.answer != 0 && std::abs(question.answer) <= question.tolerance)
    add_with("zero is taken for the answer", printed_answer(question));
  return found;
}

std::vector<Finding> answers_that_meet(const Choice& question) {
  std::vector<Finding> found;
  std::set<string> options;
  for (const Option& option : question.options)
    if (!options.insert(option.words).second)
      found.push_back({"two answers are the same", fmt::format("{} {}", question.ask, option.words)});
  return found;
}

string in_words(const Claim& claim) {
  return fmt::format("{}: measured {}, expected {} ({}){}", claim.quantity, measurement(claim), expectation(claim),
                     claim.source, claim.range.words.empty() ? "" : "; for " + claim.range.words);
}

/// The logarithm of a question's answer, if it has three digits, by which a reader recognises it: not 0.5, 2
/// or 10.
std::optional<double> telling_answer(const Item& item) {
  const auto* question = std::get_if<Prediction>(&item);
  if (!question) return {};
  const string printed = number(question->answer);
  const size_t first = std::min(printed.find_first_of("123456789"), printed.size());
  if (std::ranges::count_if(printed.substr(first), [](char c) { return '0' <= c && c <= '9'; }) < 3) return {};
  return std::log10(std::abs(question->answer));
}

/// A question comes before the formula, figure, film or claim that holds its answer, and the item right below it
/// does not give it away.
std::vector<Finding> answers_beside_questions(const Page& page, const std::vector<string>& given) {
  std::vector<Finding> found;
  const auto& items = page.items();
  for (size_t at = 0; at < items.size(); ++at) {
    const std::optional<double> answer = telling_answer(items[at]);
    if (!answer) continue;
    const auto shows_it = [&](const Item& item) {
      constexpr double same = 1e-3;  // of the logarithm: three digits
      const auto says_it = [&](const string& words) {
        return std::ranges::any_of(numbers(words), [&](const Number& number) {
          const bool set = std::ranges::any_of(given, [&](const string& value) {
            const auto typed = numbers(value);
            return typed.size() == 1 && std::abs(typed[0].magnitude - number.magnitude) < same;
          });
          return !set && std::abs(number.magnitude - *answer) < same;
        });
      };
      return std::ranges::any_of(passages(item), says_it);
    };
    for (size_t other = 0; other < items.size() && other <= at + 1; ++other) {
      const Item& item = items[other];
      const bool a_question = std::holds_alternative<Prediction>(item) || std::holds_alternative<Choice>(item);
      if (!a_question && shows_it(item))
        found.push_back(
            {other < at ? "the answer is above its question" : "the answer is right below its question",
             std::get<Prediction>(items[at]).ask + " " + passages(item).front()});
    }
  }
  return found;
}

std::vector<Finding> broken_rules(const Claim& claim) {
  if (claim.is_false()) return {{"a claim is false", in_words(claim)}};
  if (!claim.claimed()) return {};
  if (claim.tolerance.kind == Tolerance::Kind::relative && claim.tolerance.size >= 1)
    return {{"a claim allows as much as it claims", in_words(claim)}};
  return {};
}

}  // namespace

std::vector<string> passages(const Item& item) {
  std::vector<string> all;
  const auto paragraphs = [&](const string& words) {
    std::istringstream lines(words);
    for (string line; std::getline(lines, line);)
      if (!line.empty()) all.push_back(line);
  };
  const auto each = [&](const std::vector<string>& list) { std::for_each(list.begin(), list.end(), paragraphs); };
  if (const auto* text = std::get_if<Text>(&item)) paragraphs(text->words);
  if (const auto* equation = std::get_if<Equation>(&item)) {
    all.push_back(equation->numbers.plain);
  }
  if (const auto* table = std::get_if<course::Table>(&item))
    for (const auto& row : table->rows) all.push_back(fmt::format("{}", fmt::join(row, " | ")));
  if (const auto* derivation = std::get_if<Derivation>(&item))
    for (const DerivationLine& line : derivation->lines) each({line.why, line.plain});
  if (const auto* measure = std::get_if<Measure>(&item))
    all.push_back(measure->quantity + " = " + quantity(measure->value, measure->unit));
  if (const auto* claim = std::get_if<Claim>(&item)) all.push_back(in_words(*claim));
  if (const auto* sequence = std::get_if<Sequence>(&item)) paragraphs(sequence->caption);
  if (const auto* figure = std::get_if<Figure>(&item)) {
    paragraphs(figure->caption);
    if (const auto* chart = std::get_if<renderer::Chart>(&figure->picture)) {
      each({chart->title, chart->x.label, chart->y.label});
      each(chart->bar_names);
      for (const auto& curve : chart->curves) {
        paragraphs(curve.label);
        each(curve.point_labels);
      }
      for (const auto& annotation : chart->annotations) paragraphs(annotation.text);
      for (const auto& reference : chart->references) paragraphs(reference.label);
    }
  }
  if (const auto* question = std::get_if<Prediction>(&item)) {
    paragraphs(question->ask);
    each(question->hints);
    all.push_back("Answer: " + printed_answer(*question) + ". " + question->right);
    for (const WrongAnswer& wrong : question->wrong)
      all.push_back("Not " + quantity(wrong.value, question->unit, 4) + ": " + wrong.reply);
  }
  if (const auto* question = std::get_if<Choice>(&item)) {
    paragraphs(question->ask);
    each(question->hints);
    for (const Option& option : question->options) all.push_back(option.words + ": " + option.reply);
  }
  return all;
}

std::vector<Finding> broken_rules(const string& words, const std::vector<string>& given) {
  std::vector<Finding> found = meaningless_numbers(words, given);
  add(found, one_of_many(words));
  return found;
}

std::vector<Finding> broken_rules(const renderer::Chart& chart, const string& caption) {
  try {
    renderer::ranges(chart);
  } catch (const std::exception& error) {
    return {{"a chart cannot be drawn", fmt::format("{} ({})", caption, error.what())}};
  }
  const std::vector<double> values = drawn(chart);
  if (std::all_of(values.begin(), values.end(), [](double v) { return v == 0; }))
    return {{"an empty figure", caption}};
  if (shows_only_rounding(chart, values) && !speaks_of_rounding(caption + chart.title + chart.y.label))
    return {{"a figure of rounding alone", caption}};
  return {};
}

std::vector<Finding> broken_rules(const Page& page, const std::vector<string>& given) {
  std::vector<Finding> found = answers_beside_questions(page, given);
  for (const Item& item : page.items()) {
    for (const string& words : passages(item)) add(found, broken_rules(words, given));
    if (const auto* claim = std::get_if<Claim>(&item)) add(found, broken_rules(*claim));
    if (const auto* question = std::get_if<Prediction>(&item)) {
      add(found, answers_that_meet(*question));
      add(found, hints_that_lead_astray(*question));
    }
    if (const auto* question = std::get_if<Choice>(&item)) {
      add(found, answers_that_meet(*question));
      add(found, replies_alike(*question));
    }
    if (const auto* figure = std::get_if<Figure>(&item))
      if (const auto* chart = std::get_if<renderer::Chart>(&figure->picture))
        add(found, broken_rules(*chart, figure->caption));
  }
  return found;
}

}  // namespace byhand::tests
