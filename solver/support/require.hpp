#pragma once

#include <cmath>
#include <string>
#include <string_view>

// Checks of input. Each throws std::invalid_argument with one sentence: "`name` is `value`, but it must be
// `allowed`".
namespace byhand {

/// A number in as few digits as read back exactly.
std::string text_of(double value);

/// Throws that sentence, with " [`unit`]" after `allowed` unless the unit is empty.
[[noreturn]] void refuse(std::string_view name, double value, std::string_view allowed,
                         std::string_view unit = "");

namespace detail {
[[noreturn]] void refuse_range(std::string_view name, double value, const char* from, double low, const char* to,
                               double high, std::string_view unit);
}  // namespace detail

// The checks run every step and are inline; the sentences are not.

inline void require(bool holds, std::string_view name, double value, std::string_view allowed) {
  if (!holds) refuse(name, value, allowed);
}
inline void require_finite(std::string_view name, double value, std::string_view unit = "") {
  if (!std::isfinite(value)) refuse(name, value, "a finite number", unit);
}
inline void require_positive(std::string_view name, double value, std::string_view unit = "") {
  if (!(std::isfinite(value) && value > 0)) refuse(name, value, "a positive finite number", unit);
}
/// low <= value <= high.
inline void require_in(std::string_view name, double value, double low, double high, std::string_view unit = "") {
  if (!(low <= value && value <= high)) detail::refuse_range(name, value, "between ", low, " and ", high, unit);
}
/// value = 1, to 1e-9.
inline void require_unit(std::string_view name, double value) { require_in(name, value, 1 - 1e-9, 1 + 1e-9); }
/// low < value < high.
inline void require_inside(std::string_view name, double value, double low, double high,
                           std::string_view unit = "") {
  if (!(low < value && value < high)) detail::refuse_range(name, value, "above ", low, " and below ", high, unit);
}

}  // namespace byhand
