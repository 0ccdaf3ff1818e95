#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace byhand::tests {

/// A number in a text, without its sign: 0.5, 1e-05, 1.2·10⁻⁵, 10⁻¹².
struct Number {
  double magnitude;   // its logarithm to base ten, so that 4.8·10⁻¹⁴⁰⁰ has one, too; −∞ for zero
  std::string typed;  // as it stands there
  std::size_t begin, end;  // where
};

/// All numbers of a text; digits in a name, such as those of r1, are none.
std::vector<Number> numbers(const std::string& words);

/// The text with # for each number: equal for two sentences that differ in their numbers only.
std::string without_numbers(const std::string& words);

}  // namespace byhand::tests
