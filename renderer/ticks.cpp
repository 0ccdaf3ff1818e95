#include "renderer/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace byhand::renderer {
namespace {

constexpr const char* minus = "−";

std::string raised(int exponent) {
  static constexpr std::array<const char*, 10> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "⁻" : "";
  for (const char c : fmt::format("{}", std::abs(exponent))) text += digits[std::size_t(c - '0')];
  return text;
}

// Formats `value` with a Unicode minus sign; never "−0".
std::string fixed(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", std::abs(value), decimals);
  const bool zero = text.find_first_not_of("0.") == std::string::npos;
  return value < 0 && !zero ? minus + text : text;
}

double power_of_ten(int exponent) { return std::pow(10.0, exponent); }

Ticks linear_ticks(double low, double high, int most) {
  Ticks result;
  // The smallest step 1, 2, 5 × 10^e with at most `most` ticks; the next smaller one if that leaves fewer than
  // two.
  int exponent = int(std::floor(std::log10((high - low) / std::max(most, 2)))) - 1, mantissa = 1;
  const auto step = [&] { return mantissa * power_of_ten(exponent); };
  const auto count = [&] { return std::floor(high / step() + 1e-9) - std::ceil(low / step() - 1e-9) + 1; };
  while (count() > std::max(most, 2)) {
    const int before = mantissa;
    if (mantissa == 5)
      mantissa = 1, ++exponent;
    else
      mantissa = mantissa == 1 ? 2 : 5;
    if (count() >= 2) continue;
    if (before == 5) --exponent;
    mantissa = before;
    break;
  }
  const double largest = std::max(std::abs(low), std::abs(high));
  const int magnitude = int(std::floor(std::log10(largest)));
  if (magnitude >= 5 || magnitude <= -4) result.exponent = magnitude;
  const int decimals = std::max(0, result.exponent - exponent);
  const double first = std::ceil(low / step() - 1e-9), last = std::floor(high / step() + 1e-9);
  for (double i = first; i <= last; ++i) {
    const double value = mantissa * i * power_of_ten(exponent);
    result.major.push_back({value, fixed(value / power_of_ten(result.exponent), decimals)});
  }
  const int parts = mantissa == 2 ? 4 : 5;
  const double fine = step() / parts;
  for (double i = std::ceil(low / fine - 1e-9); i <= std::floor(high / fine + 1e-9); ++i)
    if (std::fmod(std::abs(i), parts) != 0) result.minor.push_back(i * fine);
  return result;
}

Ticks logarithmic_ticks(double low, double high, int most) {
  Ticks result;
  constexpr double slack = 1e-9;
  const int first = int(std::ceil(std::log10(low) - slack)), last = int(std::floor(std::log10(high) + slack));
  const auto inside = [&](double v) { return v >= low * (1 - slack) && v <= high * (1 + slack); };
  const int decades = last - first + 1;

  // Labels at 1, 2, 5, 10, …, if the range is short, they fit, and they need no power of ten.
  const bool plain = low >= 1e-3 * (1 - slack) && high < 1e4;
  std::vector<Tick> fine;
  for (int e = first - 1; e <= last && decades <= 3; ++e)
    for (const int m : {1, 2, 5})
      if (const double v = m * power_of_ten(e); inside(v))
        fine.push_back({v, plain ? fixed(v, std::max(0, -e)) : number(v, 1)});
  if (fine.size() >= 2 && int(fine.size()) <= most && (plain || decades < 2)) {
    result.major = fine;
  } else if (decades >= 2) {
    const int stride = (decades + std::max(most, 2) - 1) / std::max(most, 2);
    // All decades of an axis have the same form: 10⁻³ with 10⁻², not with 0.01.
    const bool short_numbers = first >= -2 && last <= 3;
    for (int e = first; e <= last; ++e) {
      if ((e - first) % stride != 0)
        result.minor.push_back(power_of_ten(e));
      else
        result.major.push_back(
            {power_of_ten(e), short_numbers ? fixed(power_of_ten(e), std::max(0, -e)) : "10" + raised(e)});
    }
    if (stride > 1) return result;
  } else {
    // Within a decade, linear ticks are closer to the logarithm than decades are.
    result = linear_ticks(low, high, most);
    if (result.exponent != 0)
      for (Tick& tick : result.major) tick.label = number(tick.value);
    result.exponent = 0;
    return result;
  }
  for (int e = first - 1; e <= last; ++e)
    for (int m = 2; m <= 9; ++m) {
      const double v = m * power_of_ten(e);
      const bool major = std::any_of(result.major.begin(), result.major.end(),
                                     [&](const Tick& t) { return std::abs(t.value - v) < slack * v; });
      if (inside(v) && !major) result.minor.push_back(v);
    }
  return result;
}

}  // namespace

Ticks ticks(Scale scale, double low, double high, int most) {
  const bool logarithmic = scale == Scale::logarithmic;
  if (!(std::isfinite(low) && std::isfinite(high) && low < high && (!logarithmic || low > 0)))
    throw std::invalid_argument(fmt::format("An axis goes from a lower to a higher {} number; got {} to {}.",
                                            logarithmic ? "positive" : "finite", low, high));
  return logarithmic ? logarithmic_ticks(low, high, most) : linear_ticks(low, high, most);
}

std::string number(double value, int digits) {
  if (std::isnan(value)) return "–";
  if (std::isinf(value)) return value < 0 ? "−∞" : "∞";
  if (value == 0) return "0";
  // Rounds before it takes the exponent: 9.996 with three digits is 10.0.
  const std::string scientific = fmt::format("{:.{}e}", std::abs(value), std::max(digits, 1) - 1);
  const std::size_t e = scientific.find('e');
  const int exponent = std::stoi(scientific.substr(e + 1));
  if (exponent >= -4 && exponent <= 5) {
    std::string text = fixed(value, std::max(0, digits - 1 - exponent));
    if (text.find('.') != std::string::npos) text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
  }
  std::string mantissa = scientific.substr(0, e);
  if (mantissa.find('.') != std::string::npos) mantissa.erase(mantissa.find_last_not_of('0') + 1);
  if (mantissa.back() == '.') mantissa.pop_back();
  return fmt::format("{}{}10{}", value < 0 ? minus : "", mantissa == "1" ? "" : mantissa + "·", raised(exponent));
}

}  // namespace byhand::renderer
