#pragma once

#include <string>

#include "lessons/page/items.hpp"

namespace byhand::course {

/// A claim in words, the same on the terminal, in Markdown, on the web page and in the table. "–" for a number
/// without a meaning where nothing is claimed: not finite, above 10⁹, or below 10⁻¹¹.
std::string verdict(const Claim& claim);      // "holds", "false", "not claimed"
std::string expectation(const Claim& claim);  // "2.006 s ± 0.1 %", "2 s to 12 digits", "≤ 10⁻⁹ m"
std::string measurement(const Claim& claim);  // "2.007 s"
/// The same for who reads and does not test: "0, but for rounding" for "2·10⁻¹⁶ m (rounding)", "≤ 10⁻¹⁵ m
/// (rounding)" and "0 ± 10⁻¹⁵ m (rounding)".
std::string in_plain_words(std::string words);
std::string quantity(double value, const std::string& unit, int digits = 6);

}  // namespace byhand::course
