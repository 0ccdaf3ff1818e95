#include "lessons/page/grading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "lessons/page/claim_words.hpp"
#include "lessons/page/lesson.hpp"
#include "lessons/page/lower_case.hpp"
#include "lessons/page/typed_quantity.hpp"

namespace byhand::course {
namespace {

/// "a length" for metres; empty if it has no everyday name.
std::string_view kind_of(const Dimension& dimension) {
  struct Kind {
    Dimension dimension;
    std::string_view name;
  };
  static constexpr std::array<Kind, 14> kinds = {{{{0, 0, 0}, "a plain number"},
                                                  {{1, 0, 0}, "a length"},
                                                  {{2, 0, 0}, "an area"},
                                                  {{0, 0, 1}, "a time"},
                                                  {{0, 1, 0}, "a mass"},
                                                  {{0, 0, -1}, "a rate"},
                                                  {{1, 0, -1}, "a speed"},
                                                  {{1, 0, -2}, "an acceleration"},
                                                  {{1, 1, -2}, "a force"},
                                                  {{1, 1, -1}, "an impulse"},
                                                  {{2, 1, -1}, "an angular momentum"},
                                                  {{2, 1, 0}, "a moment of inertia"},
                                                  {{2, 1, -2}, "an energy or a moment"},
                                                  {{2, 1, -3}, "a power"}}};
  const auto found =
      std::find_if(kinds.begin(), kinds.end(), [&](const Kind& kind) { return kind.dimension == dimension; });
  return found == kinds.end() ? "" : found->name;
}

/// "in m², an area"; "a plain number, without a unit".
std::string asked_for(const std::string& unit) {
  if (unit.empty() || unit == "1") return "a plain number, without a unit";
  const std::string_view kind = is_unit(unit) ? kind_of(read_typed(unit).dimension) : "";
  return fmt::format("in {}{}{}", unit, kind.empty() ? "" : ", ", kind);
}

std::string trimmed(std::string words) {
  words.erase(words.find_last_not_of(' ') + 1);
  return words.erase(0, words.find_first_not_of(' '));
}

/// What the reader typed, in the unit of the question.
struct Answer {
  double value = 0;
  std::optional<Dimension> wrong_dimension = {};
  bool bare = true;   // without a unit
  double number = 0;  // without regard to its unit
};

/// Throws std::invalid_argument for text that is not a number.
Answer read_answer(const Prediction& question, std::string typed) {
  // A unit of the lesson ("boxes", "gh") is compared letter by letter.
  const bool known = question.unit.empty() || is_unit(question.unit);
  if (!known && typed.size() > question.unit.size() && typed.ends_with(question.unit))
    typed = trimmed(typed.substr(0, typed.size() - question.unit.size()));
  const TypedQuantity read = read_typed(typed);
  if (!read.has_number) throw std::invalid_argument(fmt::format("\"{}\" is not a number", typed));
  const TypedQuantity unit =
      known && !question.unit.empty() ? read_typed(question.unit) : TypedQuantity{.value = 1};
  if (!read.has_unit) {
    // π says radians.
    const bool radians = read.has_pi && unit.dimension == Dimension{} && unit.has_unit;
    return {radians ? read.value / unit.value : read.value, {}, !radians, read.number};
  }
  if (!known || !(read.dimension == unit.dimension)) return {0, read.dimension, false, read.number};
  return {read.value / unit.value, {}, false, read.number};
}

bool near(const Prediction& question, double value) {
  return std::abs(value - question.answer) <= question.tolerance ||
         std::abs(value - question.hinted) <= question.tolerance;
}

/// The unit in which this bare number would be right.
std::optional<std::string> unit_that_fits(const Prediction& question, double number) {
  if (!question.unit.empty() && !is_unit(question.unit)) return std::nullopt;
  const TypedQuantity asked = question.unit.empty() ? TypedQuantity{.value = 1} : read_typed(question.unit);
  const auto is_angle = [](std::string_view unit) { return unit == "rad" || unit == "°"; };
  for (const char* unit : {"m", "cm", "mm", "m²", "cm²", "mm²", "m/s", "cm/s", "mm/s", "s",     "ms", "kg",
                           "g", "J",  "kJ", "N",  "kN",  "rad", "°",   "%",    "1",    "rad/s", "°/s"}) {
    if (is_angle(unit) && !is_angle(question.unit)) continue;  // an angle too is a plain number
    const TypedQuantity other = read_typed(unit);
    if (other.dimension == asked.dimension && other.value != asked.value &&
        near(question, number * other.value / asked.value))
      return unit;
  }
  return std::nullopt;
}

/// Only an answer that is well away from zero, and known to better than a fifth, betrays a missing sign or factor.
bool betrays(const Prediction& question) { return question.tolerance < 0.2 * std::abs(question.answer); }

/// What turns the typed value into the answer, in a sentence; empty if nothing known does.
std::string what_is_missing(const Prediction& question, double value, const std::vector<Factor>& forgettable) {
  if (near(question, -value) && question.answer != 0) return "The size is right; think about the sign.";
  if (!betrays(question)) return "";
  std::string sentence;
  double best = question.tolerance;
  const auto consider = [&](double corrected, const std::string& words) {
    for (const double sign : {1.0, -1.0}) {
      const double off = std::abs(sign * corrected - question.answer);
      if (off >= best) continue;
      best = off;
      sentence = words + (sign < 0 ? " The sign is wrong too." : "");
    }
  };
  for (const Factor& factor : forgettable)
    consider(value * factor.value, fmt::format("A factor {} is missing.", factor.name));
  for (const Factor& factor : forgettable)
    consider(value / factor.value, fmt::format("There is a factor {} too many.", factor.name));
  return sentence;
}

}  // namespace

std::vector<Factor> forgettable_factors(const Lesson& lesson) {
  std::vector<Factor> factors = {{"½", 0.5}, {"2", 2}, {"2π", 2 * std::numbers::pi}, {"g", 9.81}};
  for (const ParameterRecord& p : lesson.parameters()) {
    if (p.name == "h") factors.push_back({"h", p.value});
    if (p.name == "length") factors.push_back({"L", p.value});
  }
  // A factor of about one could not be told from a good answer.
  std::erase_if(factors, [](const Factor& f) { return !(std::abs(std::log(f.value)) > 0.2); });
  return factors;
}

Grade grade(const Prediction& question, const std::string& typed, const std::vector<Factor>& forgettable) {
  Answer answer;
  try {
    answer = read_answer(question, trimmed(typed));
  } catch (const std::invalid_argument& bad) {
    return {false, false,
            fmt::format("{}: type your prediction, {}, or `?` for what else can be typed.", bad.what(),
                        asked_for(question.unit))};
  }
  if (answer.wrong_dimension) {
    const std::string_view kind = kind_of(*answer.wrong_dimension);
    const std::string asked = fmt::format("the answer is {}.", asked_for(question.unit));
    return {false, true,
            fmt::format("{}{} {}", near(question, answer.number) ? "The number is right, the unit is not. " : "",
                        kind.empty() ? "That unit is another one;" : fmt::format("That is {};", kind), asked)};
  }
  if (near(question, answer.value)) return {true, true, question.right};
  for (const WrongAnswer& wrong : question.wrong)
    if (std::abs(answer.value - wrong.value) <= question.tolerance) return {false, true, wrong.reply};
  if (answer.bare && betrays(question))
    if (const auto unit = unit_that_fits(question, answer.value))
      return {false, true,
              fmt::format("The number is right in {}; without a unit it counts as {}.",
                          *unit == "1" ? "parts of one" : *unit,
                          question.unit.empty() || question.unit == "1" ? "a plain number" : question.unit)};
  const std::string missing = what_is_missing(question, answer.value, forgettable);
  if (!missing.empty()) return {false, true, missing};
  const bool close =
      betrays(question) && std::abs(answer.value - question.answer) < 0.1 * std::abs(question.answer);
  return {false, true,
          fmt::format("{} is {}{} than that.", close ? "Close: it" : "It", close ? "a little " : "",
                      answer.value < question.answer ? "more" : "less")};
}

Grade grade(const Choice& question, const std::string& typed) {
  const std::string words = trimmed(in_lower_case(typed));
  for (size_t i = 0; i < question.options.size(); ++i)
    if (words == std::to_string(i + 1) || words == trimmed(in_lower_case(question.options[i].words)))
      return {static_cast<int>(i) == question.answer, true, question.options[i].reply};
  return {false, false,
          fmt::format("\"{}\" is not one of them: type a number from 1 to {}, or `?` for what else can be typed.",
                      typed, question.options.size())};
}

std::string printed_answer(const Prediction& question) {
  std::string printed;
  for (int digits = 4; digits <= 15; ++digits) {
    printed = quantity(question.answer, question.unit, digits);
    if (grade(question, printed).right) break;
  }
  return printed;
}

}  // namespace byhand::course
