#include "lessons/page/condition.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lessons/page/words.hpp"

namespace byhand::course {
namespace {

/// "0.5 m"; "120°", "5 %".
std::string with_unit(double value, const std::string& unit) {
  return number(value) + (unit.empty() || unit == "1" ? "" : unit == "°" ? unit : " " + unit);
}

std::string found(const Quantity& a) {
  const bool rounding = a.value != 0 && std::abs(a.value) < 1e-11;
  return fmt::format("{} = {}{}", a.symbol, with_unit(a.value, a.unit), rounding ? " (rounding)" : "");
}

Condition compared(bool met, const Quantity& a, const char* sign, double limit) {
  return {met, fmt::format("{} {} {}", a.symbol, sign, with_unit(limit, a.unit)), found(a)};
}

Condition compared(bool met, const Quantity& a, const char* sign, const Quantity& limit) {
  return {met, fmt::format("{} {} {}", a.symbol, sign, limit.symbol), found(a) + ", " + found(limit)};
}

/// Both, each once.
std::string joined(const std::string& one, const std::string& between, const std::string& other) {
  const bool repeats = (between + one + between).find(between + other + between) != std::string::npos;
  if (one.empty()) return other;
  return other.empty() || repeats ? one : one + between + other;
}

}  // namespace

Condition operator<(const Quantity& a, const Quantity& limit) {
  return compared(a.value < limit.value, a, "<", limit);
}
Condition operator<=(const Quantity& a, const Quantity& limit) {
  return compared(a.value <= limit.value, a, "≤", limit);
}
Condition operator>(const Quantity& a, const Quantity& limit) {
  return compared(a.value > limit.value, a, ">", limit);
}
Condition operator>=(const Quantity& a, const Quantity& limit) {
  return compared(a.value >= limit.value, a, "≥", limit);
}

Condition operator<(const Quantity& a, double limit) { return compared(a.value < limit, a, "<", limit); }
Condition operator<=(const Quantity& a, double limit) { return compared(a.value <= limit, a, "≤", limit); }
Condition operator>(const Quantity& a, double limit) { return compared(a.value > limit, a, ">", limit); }
Condition operator>=(const Quantity& a, double limit) { return compared(a.value >= limit, a, "≥", limit); }

Condition operator==(const Quantity& a, double limit) { return compared(a.value == limit, a, "=", limit); }

Condition within(double low, const Quantity& a, double high) {
  return {low <= a.value && a.value <= high,
          fmt::format("{} ≤ {} ≤ {}", with_unit(low, a.unit), a.symbol, with_unit(high, a.unit)), found(a)};
}

Condition both(const Condition& one, const Condition& other) {
  return {one.met && other.met, joined(one.words, ", ", other.words), joined(one.found, ", ", other.found)};
}

Condition either(const Condition& one, const Condition& other) {
  return {one.met || other.met, joined(one.words, ", or ", other.words), joined(one.found, ", ", other.found)};
}

}  // namespace byhand::course
