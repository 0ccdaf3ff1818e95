#pragma once

#include <string>

#include "lessons/page/items.hpp"

namespace byhand::course {

/// A claim in words, the same on the terminal, in Markdown, on the web page and in the table. "–" for a number
/// without a meaning where nothing is claimed: not finite, above 10⁹, or below 10⁻¹¹.
std::string verdict(const Claim& claim);      // "holds", "false", "not claimed"
std::string expectation(const Claim& claim);  // "2.006 s ± 0.1 %", "2 s to 12 digits", "≤ 10⁻⁹ m"
std::string measurement(const Claim& claim);  // "2.007 s"
std::string quantity(double value, const std::string& unit, int digits = 6);

}  // namespace byhand::course
