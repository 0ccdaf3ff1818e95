#pragma once

#include <string>
#include <utility>
#include <vector>

namespace byhand::renderer {

enum class Scale { linear, logarithmic };

/// A value on an axis; minor ones have no label.
struct Tick {
  double value = 0;
  std::string label{};  ///< UTF-8, with a true minus sign and raised digits: "−0.5", "10⁻³"
};

/// The ticks of an axis and the power of ten that was taken out of their labels (0: none).
struct Ticks {
  std::vector<Tick> major;
  std::vector<double> minor;
  int exponent = 0;
};

/// Round values in [low, high], at most `most` labelled ones and, where the range allows, at least two: steps
/// of 1, 2 or 5 times a power of ten on a linear axis; decades on a logarithmic one, with 2 and 5 between
/// them when it spans little. Throws std::invalid_argument unless low < high, both finite and, for
/// logarithms, positive.
Ticks ticks(Scale scale, double low, double high, int most);

/// `value` with `digits` significant digits as a reader would write it: "0.25", "−1200", "3.5·10⁻⁷".
std::string number(double value, int digits = 3);

}  // namespace byhand::renderer
