#include "lessons/tutor/parameter.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <stdexcept>

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

std::string typed(double value) {
  std::string shortest = fmt::format("{}", value);
  const double reciprocal = std::round(1 / value);
  // 1/60 reads better than 0.016666666666666666; 0.2 better than 1/5.
  if (shortest.size() > 8 && std::abs(reciprocal) < 1e6 && 1 / reciprocal == value)
    return fmt::format("1/{:.0f}", reciprocal);
  return shortest;
}

void ParameterRecord::set(std::string_view text) {
  double read = 0;
  try {
    read = read_number(text);
  } catch (const std::invalid_argument& bad) {
    throw std::invalid_argument(fmt::format("{}: {} wants a number from {} to {} [{}]", bad.what(), name,
                                            typed(range.low), typed(range.high), unit));
  }
  if (!(read >= range.low && read <= range.high))
    throw std::invalid_argument(fmt::format("{} = {} is out of range: {} goes from {} to {} [{}]", name, text,
                                            name, typed(range.low), typed(range.high), unit));
  if (integer && read != std::round(read))
    throw std::invalid_argument(fmt::format("{} = {} is not a whole number, and {} counts", name, text, name));
  value = read;
}

}  // namespace byhand::tutor
