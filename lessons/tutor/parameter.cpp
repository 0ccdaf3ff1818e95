#include "lessons/tutor/parameter.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace byhand::tutor {
namespace {

double read_decimal(std::string_view text) {
  double value = 0;
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
    throw std::invalid_argument(fmt::format("\"{}\" is not a number", text));
  return value;
}

std::string with_ascii_minus(std::string_view text) {
  const std::string_view minus = "−";
  std::string ascii(text);
  for (auto at = ascii.find(minus); at != std::string::npos; at = ascii.find(minus))
    ascii.replace(at, minus.size(), "-");
  return ascii;
}

/// Smaller units of a unit, and how many of each make one.
struct UnitFamily {
  std::string_view unit;
  std::vector<std::pair<std::string_view, double>> members;
};
const std::array<UnitFamily, 3> families = {
    {{"s", {{"ms", 1e3}, {"us", 1e6}, {"µs", 1e6}, {"μs", 1e6}, {"ns", 1e9}}},
     {"m", {{"cm", 1e2}, {"mm", 1e3}, {"um", 1e6}, {"µm", 1e6}, {"μm", 1e6}}},
     {"kg", {{"g", 1e3}}}}};

std::string_view without_space_behind(std::string_view text) {
  return text.substr(0, text.find_last_not_of(' ') + 1);
}

}  // namespace

double read_number(std::string_view text) {
  const std::string ascii = with_ascii_minus(text);
  const auto slash = ascii.find('/');
  if (slash == std::string::npos) return read_decimal(ascii);
  const double value = read_decimal(std::string_view(ascii).substr(0, slash)) /
                       read_decimal(std::string_view(ascii).substr(slash + 1));
  if (!std::isfinite(value)) throw std::invalid_argument(fmt::format("\"{}\" divides by zero", text));
  return value;
}

double read_quantity(std::string_view text, const std::string& unit) {
  // The longest suffix wins, else "5 ms" would parse as "5 m" with the unit s.
  std::string_view behind;
  double parts = 1;
  const auto try_unit = [&](std::string_view name, double of_them) {
    if (name.size() > behind.size() && text.size() > name.size() && text.ends_with(name))
      behind = name, parts = of_them;
  };
  try_unit(unit, 1);
  for (const UnitFamily& family : families)
    if (family.unit == unit)
      for (const auto& [name, of_them] : family.members) try_unit(name, of_them);
  if (unit == "1" || behind.empty()) return read_number(text);
  try {
    return read_number(without_space_behind(text.substr(0, text.size() - behind.size()))) / parts;
  } catch (const std::invalid_argument&) {
    throw std::invalid_argument(fmt::format("\"{}\" is not a number", text));
  }
}

std::string typed(double value) {
  std::string shortest = fmt::format("{}", value);
  const double reciprocal = std::round(1 / value);
  // 1/60 reads better than 0.016666666666666666; 0.2 better than 1/5.
  if (shortest.size() > 8 && std::abs(reciprocal) < 1e6 && 1 / reciprocal == value)
    return fmt::format("1/{:.0f}", reciprocal);
  return shortest;
}

std::string ParameterRecord::typed(double any) const {
  return choices.empty() ? tutor::typed(any) : choices[static_cast<size_t>(any)];
}

std::string ParameterRecord::allowed() const {
  if (!choices.empty()) return fmt::format("{}", fmt::join(choices, ", "));
  return fmt::format("{} … {}{}", tutor::typed(range.low), tutor::typed(range.high), integer ? ", whole" : "");
}

std::string ParameterRecord::described(double any) const {
  if (!choices.empty()) return fmt::format("{} = {}, one of {}: {}", name, typed(any), allowed(), meaning);
  return fmt::format("{} = {} [{}], from {} to {}: {}", name, typed(any), unit, tutor::typed(range.low),
                     tutor::typed(range.high), meaning);
}

void ParameterRecord::set(std::string_view text) {
  if (!choices.empty()) {
    const auto chosen = std::find(choices.begin(), choices.end(), text);
    if (chosen == choices.end())
      throw std::invalid_argument(fmt::format("{} = {} is none of its choices: {}", name, text, allowed()));
    value = static_cast<double>(chosen - choices.begin());
    return;
  }
  double read = 0;
  try {
    read = read_quantity(text, unit);
  } catch (const std::invalid_argument& bad) {
    throw std::invalid_argument(fmt::format("{}: {} wants a number from {} to {} [{}]", bad.what(), name,
                                            tutor::typed(range.low), tutor::typed(range.high), unit));
  }
  if (!(read >= range.low && read <= range.high))
    throw std::invalid_argument(fmt::format("{} = {} is out of range: {} goes from {} to {} [{}]", name, text,
                                            name, tutor::typed(range.low), tutor::typed(range.high), unit));
  if (integer && read != std::round(read))
    throw std::invalid_argument(fmt::format("{} = {} is not a whole number, and {} counts", name, text, name));
  value = read;
}

}  // namespace byhand::tutor
