#include "lessons/page/claim_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace byhand::course {
namespace {

/// Says of a size that numbers of double precision leave by themselves what it is.
std::string if_rounding(double size) { return size > 0 && size < 1e-11 ? " (rounding)" : ""; }

/// Outside its range a claim may measure, or expect, what nobody can imagine.
bool is_beyond_words(const Claim& claim, double value) {
  const double size = std::abs(value);
  return !claim.claimed() && !(size == 0 || (1e-11 <= size && size <= 1e9));
}

/// Whether the claim expects nothing but rounding: zero, or what its tolerance cannot tell from zero.
bool expects_nothing(const Claim& claim) {
  const double size = std::abs(claim.expected);
  return size == 0 || claim.tolerance.kind == Tolerance::Kind::at_most ||
         (claim.tolerance.kind == Tolerance::Kind::absolute && size < std::min(claim.tolerance.size, 1e-11));
}

/// " ± 0.1 %"; " to 12 digits" where a percentage would have no meaning.
std::string within_relative(double size) {
  if (size > 0 && size <= 1e-6) return fmt::format(" to {:.0f} digits", std::floor(-std::log10(size) + 1e-9));
  return " ± " + number(100 * size, 2) + " %";
}

}  // namespace

std::string quantity(double value, const std::string& unit, int digits) {
  return number(value, digits) + (unit.empty() || unit == "1" ? "" : " " + unit);
}

std::string in_plain_words(std::string words) {
  constexpr std::string_view mark = " (rounding)", equals = " = ", between = " ± ";
  for (auto end = words.find(mark); end != std::string::npos; end = words.find(mark, end)) {
    const auto sign = words.rfind(equals, end);
    const auto begin = sign == std::string::npos ? 0 : sign + equals.size();
    const std::string number = words.substr(begin, end - begin);
    std::string plain = "0";
    if (const auto tolerance = number.find(between); tolerance != std::string::npos && !number.starts_with("0 ")) {
      const auto unit = std::min(number.find(' ', tolerance + between.size()), number.size());
      plain = number.substr(0, tolerance) + number.substr(unit);
    }
    plain += ", but for rounding";
    words.replace(begin, end + mark.size() - begin, plain);
    end = begin + plain.size();
  }
  return words;
}

std::string verdict(const Claim& claim) {
  if (!claim.claimed()) return "not claimed";
  return claim.holds() ? "holds" : "false";
}

std::string expectation(const Claim& claim) {
  if (claim.judged) return claim.judged->words;
  if (is_beyond_words(claim, claim.expected)) return "–";
  const std::string unit = claim.unit.empty() || claim.unit == "1" ? "" : " " + claim.unit;
  const auto& [kind, size] = claim.tolerance;
  const bool two_sided = kind == Tolerance::Kind::relative || kind == Tolerance::Kind::absolute;
  if (!claim.claimed() && two_sided) return quantity(claim.expected, claim.unit);  // no tolerance is meant here
  switch (kind) {
    case Tolerance::Kind::relative: return quantity(claim.expected, claim.unit) + within_relative(size);
    case Tolerance::Kind::absolute:
      return number(expects_nothing(claim) ? 0 : claim.expected, 6) + " ± " + number(size, 2) + unit +
             if_rounding(size);
    case Tolerance::Kind::at_most:
      return "≤ " + quantity(claim.expected, claim.unit) + if_rounding(claim.expected);
    case Tolerance::Kind::at_least: return "≥ " + quantity(claim.expected, claim.unit);
  }
  return "";
}

std::string measurement(const Claim& claim) {
  if (claim.judged) return claim.judged->found;
  if (is_beyond_words(claim, claim.measured)) return "–";
  const double size = std::abs(claim.measured);
  if (!expects_nothing(claim)) return quantity(claim.measured, claim.unit);
  return (size > 0 && size < 1e-30 ? "below " + quantity(1e-30, claim.unit)
                                   : quantity(claim.measured, claim.unit)) +
         if_rounding(size);
}

}  // namespace byhand::course
