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

/// Refuses NaN and infinity.
void require_finite(std::string_view name, double value, std::string_view unit = "");

/// Refuses zero, negative numbers, NaN and infinity.
void require_positive(std::string_view name, double value, std::string_view unit = "");

/// Refuses everything but low <= value <= high.
void require_in(std::string_view name, double value, double low, double high, std::string_view unit = "");

/// Refuses everything but low < value < high.
void require_inside(std::string_view name, double value, double low, double high, std::string_view unit = "");

}  // namespace byhand
