#pragma once

#include <string>
#include <utility>
#include <vector>

namespace byhand::renderer {

enum class Scale { linear, logarithmic };

/// A tick of an axis; minor ticks have no label.
struct Tick {
  double value = 0;
  std::string label{};  ///< UTF-8, with a true minus sign and raised digits: "−0.5", "10⁻³"
};

/// The ticks of an axis. `exponent`: power of ten factored out of the labels (0: none).
struct Ticks {
  std::vector<Tick> major;
  std::vector<double> minor;
  int exponent = 0;
};

/// Ticks at round values in [low, high], at most `most` major ones and, if the range allows, at least two. A
/// linear axis has steps of 1, 2 or 5 times a power of ten; a logarithmic one has decades, with 2 and 5 between
/// few decades. Throws std::invalid_argument unless low < high, both finite and, on a logarithmic axis, positive.
Ticks ticks(Scale scale, double low, double high, int most);

/// Formats `value` with `digits` significant digits: "0.25", "−1200", "3.5·10⁻⁷".
std::string number(double value, int digits = 3);

}  // namespace byhand::renderer
