#include "tests/lessons/settings/numbers.hpp"

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace byhand::tests {
namespace {

using std::string;
using std::string_view;

bool is_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// Reads `prefix` and moves behind it.
bool take(string_view& words, string_view prefix) {
  if (!words.starts_with(prefix)) return false;
  words.remove_prefix(prefix.size());
  return true;
}

std::optional<int> take_superscript(string_view& words) {
  static constexpr std::array<string_view, 10> digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  string_view rest = words;
  const bool negative = take(rest, "⁻");
  const auto next = [&]() -> std::optional<int> {
    for (int digit = 0; digit < 10; ++digit)
      if (take(rest, digits[static_cast<size_t>(digit)])) return digit;
    return {};
  };
  std::optional<int> value;
  while (const auto digit = next()) value = 10 * value.value_or(0) + *digit;
  if (value) words = rest;
  return negative && value ? -*value : value;
}

/// The number at the beginning of the words: 0.5, 1e-05, 1.2·10⁻⁵, 10⁻¹².
std::optional<Number> take_number(string_view& words) {
  const string_view all = words;
  double mantissa = 0;
  const auto [end, error] = std::from_chars(words.data(), words.data() + words.size(), mantissa);
  if (error == std::errc::invalid_argument) return {};
  words.remove_prefix(static_cast<size_t>(end - words.data()));
  double exponent = 0;
  const string_view digits = all.substr(0, all.size() - words.size());
  if (digits == "10") {
    if (const auto power = take_superscript(words)) exponent = *power - 1;
  } else if (string_view rest = words; take(rest, "·10")) {
    if (const auto power = take_superscript(rest)) {
      exponent = *power;
      words = rest;
    }
  }
  return Number{std::log10(mantissa) + exponent, string(all.substr(0, all.size() - words.size())), 0, 0};
}

}  // namespace

std::vector<Number> numbers(const string& words) {
  std::vector<Number> all;
  for (size_t at = 0; at < words.size();) {
    if (!std::isdigit(static_cast<unsigned char>(words[at]))) {
      ++at;
      continue;
    }
    if (at > 0 && is_letter(words[at - 1])) {
      while (at < words.size() && is_letter(words[at])) ++at;
      continue;
    }
    string_view rest = string_view(words).substr(at);
    std::optional<Number> number = take_number(rest);
    number->begin = at;
    at = number->end = words.size() - rest.size();
    all.push_back(*number);
  }
  return all;
}

string without_numbers(const string& words) {
  string all;
  size_t at = 0;
  for (const Number& number : numbers(words)) {
    all += words.substr(at, number.begin - at) + "#";
    at = number.end;
  }
  return all + words.substr(at);
}

}  // namespace byhand::tests
