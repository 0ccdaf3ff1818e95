#include "tests/lessons/settings/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace byhand::tests {
namespace {

double uniform(double low, double high, std::mt19937& random) {
  return low + (high - low) * (static_cast<double>(random()) / static_cast<double>(std::mt19937::max()));
}

double log_uniform(double low, double high, std::mt19937& random) {
  return std::exp(uniform(std::log(low), std::log(high), random));
}

double any_number(const course::Range& range, std::mt19937& random) {
  if (range.low == 0) {
    switch (random() % 4) {
      case 0: return 0;
      case 1: return log_uniform(1e-6 * range.high, range.high, random);
      default: return uniform(0, range.high, random);
    }
  }
  if (range.low > 0 && range.high >= 10 * range.low) return log_uniform(range.low, range.high, random);
  return uniform(range.low, range.high, random);
}

double with_three_digits(double value) { return std::stod(fmt::format("{:.3g}", value)); }

}  // namespace

Suggestion suggestion(const std::string& command) {
  Suggestion suggestion;
  std::istringstream words(command);
  for (std::string word; words >> word;) {
    if (word == "--step") words >> suggestion.step;
    if (word != "--set" || !(words >> word)) continue;
    const auto equals = std::min(word.find('='), word.size());
    suggestion.setting.emplace_back(word.substr(0, equals), word.substr(std::min(equals + 1, word.size())));
  }
  return suggestion;
}

std::vector<Suggestion> suggestions(const course::Closing& closing) {
  std::vector<Suggestion> all;
  for (const course::Try& attempt : closing.tries) all.push_back(suggestion(attempt.command));
  return all;
}

std::vector<std::string> ends(const course::ParameterRecord& parameter) {
  if (!parameter.choices.empty()) return parameter.choices;
  return {course::typed(parameter.range.low), course::typed(parameter.range.high)};
}

std::string any_value(const course::ParameterRecord& parameter, std::mt19937& random) {
  if (!parameter.choices.empty()) return parameter.choices[random() % parameter.choices.size()];
  const double value = any_number(parameter.range, random);
  return course::typed(parameter.integer
                           ? std::round(value)
                           : std::clamp(with_three_digits(value), parameter.range.low, parameter.range.high));
}

std::string options(const Setting& setting) {
  std::string all;
  for (const auto& [name, value] : setting) all += fmt::format(" --set {}={}", name, value);
  return all;
}

}  // namespace byhand::tests
