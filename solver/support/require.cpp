#include "solver/support/require.hpp"

#include <charconv>
#include <stdexcept>

namespace byhand {

std::string text_of(double value) {
  char text[32];
  const double size = std::abs(value);
  const bool plain = size == 0 || (1e-4 <= size && size < 1e16);
  const auto format = plain ? std::chars_format::fixed : std::chars_format::scientific;
  return {text, std::to_chars(text, text + sizeof text, value, format).ptr};
}

void refuse(std::string_view name, double value, std::string_view allowed, std::string_view unit) {
  std::string sentence = std::string(name) + " is " + text_of(value) + ", but it must be " + std::string(allowed);
  if (!unit.empty()) sentence += " [" + std::string(unit) + "]";
  throw std::invalid_argument(sentence);
}

void detail::refuse_range(std::string_view name, double value, const char* from, double low, const char* to,
                          double high, std::string_view unit) {
  refuse(name, value, from + text_of(low) + to + text_of(high), unit);
}

}  // namespace byhand
