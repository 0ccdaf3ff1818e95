#pragma once

#include <cmath>
#include <string>
#include <string_view>

// Bad input is refused where it enters, in one sentence that names the value and what is allowed.
namespace byhand {

/// A number as short as it can be written and read back exactly.
std::string text_of(double value);

/// Throws std::invalid_argument "`name` is `value`, but it must be `allowed`".
[[noreturn]] void refuse(std::string_view name, double value, std::string_view allowed);

/// Refuses `value` unless `holds`.
inline void require(bool holds, std::string_view name, double value, std::string_view allowed) {
  if (!holds) refuse(name, value, allowed);
}

namespace detail {
[[noreturn]] void refuse_not_finite(std::string_view name, double value, std::string_view unit);
[[noreturn]] void refuse_not_positive(std::string_view name, double value, std::string_view unit);
[[noreturn]] void refuse_outside(std::string_view name, double value, double low, double high,
                                 std::string_view unit);
[[noreturn]] void refuse_not_inside(std::string_view name, double value, double low, double high,
                                    std::string_view unit);
}  // namespace detail

// The checks are inline, for every step makes them; the sentences are not.

/// Refuses NaN and infinity.
inline void require_finite(std::string_view name, double value, std::string_view unit = "") {
  if (!std::isfinite(value)) detail::refuse_not_finite(name, value, unit);
}

/// Refuses zero, negative numbers, NaN and infinity.
inline void require_positive(std::string_view name, double value, std::string_view unit = "") {
  if (!(std::isfinite(value) && value > 0)) detail::refuse_not_positive(name, value, unit);
}

/// Refuses everything but low <= value <= high.
inline void require_in(std::string_view name, double value, double low, double high, std::string_view unit = "") {
  if (!(low <= value && value <= high)) detail::refuse_outside(name, value, low, high, unit);
}

/// Refuses everything but low < value < high.
inline void require_inside(std::string_view name, double value, double low, double high,
                           std::string_view unit = "") {
  if (!(low < value && value < high)) detail::refuse_not_inside(name, value, low, high, unit);
}

}  // namespace byhand
