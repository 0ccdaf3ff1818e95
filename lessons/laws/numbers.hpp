#pragma once

#include <cmath>

namespace byhand::laws {

inline constexpr double g = 9.81, sixtieth = 1.0 / 60;  // [m/s²], [s]

inline double square(double x) { return x * x; }

/// Numbers in [-½, ½] without a pattern: the fractions of multiples of the golden ratio. They disturb all modes of
/// a scene at once, the same on every machine.
inline double uneven(int i) { return 0.6180339887498949 * i - std::floor(0.6180339887498949 * i) - 0.5; }

}  // namespace byhand::laws
