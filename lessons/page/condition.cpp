#include "lessons/page/condition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "lessons/page/words.hpp"

namespace byhand::course {
namespace {

constexpr std::array<std::string_view, 5> signs{" = ", " < ", " ≤ ", " > ", " ≥ "};

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

/// "β = 0.2", unlike a part of a symbol such as "time stood, cold".
bool compares(const std::string& words) {
  return std::any_of(signs.begin(), signs.end(),
                     [&](std::string_view sign) { return words.find(sign) != std::string::npos; });
}

/// Both, each once: without what `other` begins with if that is in `one`.
std::string joined(const std::string& one, const std::string& between, std::string other) {
  const std::string all = between + one + between;
  std::size_t again = 0;
  for (auto end = other.find(between); end != std::string::npos; end = other.find(between, end + 1)) {
    const std::string begins = other.substr(0, end);
    if (compares(begins) && all.find(between + begins + between) != std::string::npos)
      again = end + between.size();
  }
  other.erase(0, again);
  if (one.empty()) return other;
  return other.empty() || all.find(between + other + between) != std::string::npos ? one : one + between + other;
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
