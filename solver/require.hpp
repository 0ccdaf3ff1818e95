#pragma once

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

// Bad input is refused where it enters, in one sentence that names the value and what is allowed.
namespace byhand {

/// Throws std::invalid_argument "`name` is `value`, but it must be `allowed`" unless `holds`.
template <class T>
void require(bool holds, std::string_view name, const T& value, std::string_view allowed) {
  if (!holds) throw std::invalid_argument(fmt::format("{} is {}, but it must be {}", name, value, allowed));
}

/// " [m]" for the unit "m", nothing for a pure number.
inline std::string in_brackets(std::string_view unit) { return unit.empty() ? "" : fmt::format(" [{}]", unit); }

/// Refuses NaN and infinity.
inline void require_finite(std::string_view name, double value, std::string_view unit = "") {
  if (!std::isfinite(value)) require(false, name, value, "a finite number" + in_brackets(unit));
}

/// Refuses zero, negative numbers, NaN and infinity.
inline void require_positive(std::string_view name, double value, std::string_view unit = "") {
  if (!(std::isfinite(value) && value > 0))
    require(false, name, value, "a positive finite number" + in_brackets(unit));
}

/// Refuses everything but low <= value <= high.
inline void require_in(std::string_view name, double value, double low, double high, std::string_view unit = "") {
  if (!(low <= value && value <= high))
    require(false, name, value, fmt::format("between {} and {}{}", low, high, in_brackets(unit)));
}

/// Refuses everything but low < value < high.
inline void require_inside(std::string_view name, double value, double low, double high,
                           std::string_view unit = "") {
  if (!(low < value && value < high))
    require(false, name, value, fmt::format("above {} and below {}{}", low, high, in_brackets(unit)));
}

}  // namespace byhand
