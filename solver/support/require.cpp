#include "solver/support/require.hpp"

#include <charconv>
#include <stdexcept>

namespace byhand {
namespace {

/// " [m]" for the unit "m", nothing for a pure number.
std::string in_brackets(std::string_view unit) {
  return unit.empty() ? std::string() : " [" + std::string(unit) + "]";
}

}  // namespace

std::string text_of(double value) {
  char text[32];
  const double size = std::abs(value);
  const bool plain = size == 0 || (1e-4 <= size && size < 1e16);
  const auto format = plain ? std::chars_format::fixed : std::chars_format::scientific;
  return {text, std::to_chars(text, text + sizeof text, value, format).ptr};
}

void refuse(std::string_view name, double value, std::string_view allowed) {
  throw std::invalid_argument(std::string(name) + " is " + text_of(value) + ", but it must be " +
                              std::string(allowed));
}

namespace detail {

void refuse_not_finite(std::string_view name, double value, std::string_view unit) {
  refuse(name, value, "a finite number" + in_brackets(unit));
}

void refuse_not_positive(std::string_view name, double value, std::string_view unit) {
  refuse(name, value, "a positive finite number" + in_brackets(unit));
}

void refuse_outside(std::string_view name, double value, double low, double high, std::string_view unit) {
  refuse(name, value, "between " + text_of(low) + " and " + text_of(high) + in_brackets(unit));
}

void refuse_not_inside(std::string_view name, double value, double low, double high, std::string_view unit) {
  refuse(name, value, "above " + text_of(low) + " and below " + text_of(high) + in_brackets(unit));
}

}  // namespace detail
}  // namespace byhand
