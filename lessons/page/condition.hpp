#pragma once

#include <concepts>
#include <string>
#include <utility>

namespace byhand::course {

/// A number under the symbol that a reader knows it by: `Quantity("β", beta) <= 1.5` is the condition "β ≤ 1.5".
struct Quantity {
  Quantity(std::string symbol_, double value_, std::string unit_ = {})
      : symbol(std::move(symbol_)), value(value_), unit(std::move(unit_)) {}
  std::string symbol;
  double value;
  std::string unit;  // none if dimensionless
};

/// A condition that prints itself. Where its words need no number, write them: `Condition{thrown.rests, "a book at
/// rest"}`.
struct Condition {
  bool met = true;
  std::string words = {};  // "β ≤ 1.5"
  std::string found = {};  // "β = 0.2"

  explicit operator bool() const { return met; }
};

/// A limit that has a name of its own: `Quantity("β", beta) < Quantity("(1 − q)/q", limit)`.
Condition operator<(const Quantity& a, const Quantity& limit);
Condition operator<=(const Quantity& a, const Quantity& limit);
Condition operator>(const Quantity& a, const Quantity& limit);
Condition operator>=(const Quantity& a, const Quantity& limit);

Condition operator<(const Quantity& a, double limit);
Condition operator<=(const Quantity& a, double limit);
Condition operator>(const Quantity& a, double limit);
Condition operator>=(const Quantity& a, double limit);

/// Exactly: a clamped or rounded value.
Condition operator==(const Quantity& a, double limit);

/// low ≤ a ≤ high
Condition within(double low, const Quantity& a, double high);

/// Both; "β ≤ 1.5, N ≤ 12".
Condition both(const Condition& one, const Condition& other);
/// All of them.
Condition where(Condition first, const std::same_as<Condition> auto&... more) {
  ((first = both(first, more)), ...);
  return first;
}
/// One of them at least; "β ≤ 1.5, or N ≤ 12".
Condition either(const Condition& one, const Condition& other);

}  // namespace byhand::course
