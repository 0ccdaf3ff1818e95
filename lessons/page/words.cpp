#include "lessons/page/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lessons/page/error.hpp"

namespace byhand::course {
namespace {

struct Decimal {
  bool negative;
  std::string digits;  // "1.2", trailing zeros gone
  int exponent;        // of ten; 0 when the digits say it all
};

std::string without_trailing_zeros(std::string digits) {
  if (digits.find('.') == std::string::npos) return digits;
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.') digits.pop_back();
  return digits;
}

Decimal decimal(double value, int digits) {
  const double size = std::abs(value);
  if (size == 0) return {false, "0", 0};
  const std::string scientific = fmt::format("{:.{}e}", size, digits - 1);
  const auto e = scientific.find('e');
  const int exponent = std::stoi(scientific.substr(e + 1));
  if (exponent < -4 || exponent >= std::max(6, digits))
    return {value < 0, without_trailing_zeros(scientific.substr(0, e)), exponent};
  return {value < 0, without_trailing_zeros(fmt::format("{:.{}f}", size, std::max(0, digits - 1 - exponent))), 0};
}

std::string superscript(int exponent) {
  static const char* const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string raised;
  for (const char c : std::to_string(exponent)) raised += c == '-' ? "⁻" : digits[c - '0'];
  return raised;
}

template <class Write>
std::string list_of(const std::vector<double>& list, Write write) {
  std::string all;
  for (const double value : list) all += (all.empty() ? "" : ", ") + write(value, 4);
  return "(" + all + ")";
}

/// Replaces each `@` by what `next` returns.
template <class Next>
std::string replace_marks(std::string_view words, const Next& next) {
  std::string filled;
  for (const char c : words) {
    if (c == '@')
      filled += next();
    else
      filled += c;
  }
  return filled;
}

void require_as_many(std::string_view words, size_t values) {
  const auto marks = static_cast<size_t>(std::count(words.begin(), words.end(), '@'));
  if (marks != values) throw LessonError(fmt::format("\"{}\" has {} places for {} values", words, marks, values));
}

}  // namespace

std::string number(double value, int digits) {
  if (std::isnan(value)) return "not a number";
  if (std::isinf(value)) return value < 0 ? "−∞" : "∞";
  const Decimal d = decimal(value, digits);
  const std::string sign = d.negative ? "−" : "";
  if (d.exponent == 0) return sign + d.digits;
  return sign + (d.digits == "1" ? "" : d.digits + "·") + "10" + superscript(d.exponent);
}

std::string latex_number(double value, int digits) {
  if (std::isnan(value)) return "\\text{not a number}";
  if (std::isinf(value)) return value < 0 ? "-\\infty" : "\\infty";
  const Decimal d = decimal(value, digits);
  const std::string sign = d.negative ? "-" : "";
  if (d.exponent == 0) return sign + d.digits;
  return sign + (d.digits == "1" ? "" : d.digits + "\\cdot ") + fmt::format("10^{{{}}}", d.exponent);
}

Value::Value(double value, int digits) : plain_(number(value, digits)), latex_(latex_number(value, digits)) {}

Value::Value(const std::vector<double>& list)
    : plain_(list_of(list, number)), latex_(list_of(list, latex_number)) {}

std::string several(long n, std::string_view one, std::string_view many) {
  const std::string words = n == 1 ? std::string(one) : many.empty() ? std::string(one) + "s" : std::string(many);
  return Value(n).plain() + " " + words;
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

std::string unwrapped(std::string_view source) {
  std::string words;
  bool new_paragraph = false;
  for (std::string_view line : lines_of(source)) {
    const auto first = line.find_first_not_of(' ');
    if (first == std::string::npos) {
      new_paragraph = true;
      continue;
    }
    line = line.substr(first, line.find_last_not_of(' ') + 1 - first);
    if (!words.empty()) words += new_paragraph ? "\n\n" : line.starts_with("- ") ? "\n" : " ";
    words += line;
    new_paragraph = false;
  }
  return words;
}

std::string fill(std::string_view words, const std::vector<Value>& values) {
  require_as_many(words, values.size());
  auto value = values.begin();
  return replace_marks(words, [&] { return (value++)->plain(); });
}

Formula fill(std::string_view plain, std::string_view latex, const std::vector<Value>& values) {
  require_as_many(latex, values.size());
  auto value = values.begin();
  return {fill(plain, values), replace_marks(latex, [&] { return (value++)->latex(); })};
}

}  // namespace byhand::course
