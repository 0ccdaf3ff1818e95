#pragma once

#include <functional>
#include <vector>

namespace byhand {

/// Numbers of extended precision: minimal coordinates and their rates.
using ExtendedState = std::vector<long double>;

/// `rate` of `state`, written into a vector of the same size.
using Rate = std::function<void(const ExtendedState& state, ExtendedState& rate)>;

/// A state and the largest error that any of its numbers may be expected to have.
struct Certified {
  std::vector<double> state;
  double uncertainty = 0;
};

/// Integrates from 0 to `time` [s] twice, by two unrelated methods in extended precision (Fehlberg's
/// Runge-Kutta of order 8 and Bulirsch and Stoer's extrapolation); the uncertainty is twice their difference,
/// and a rounding to double. `tolerance`, > 0, is what a step of either may get wrong, relative and absolute.
/// Throws std::invalid_argument unless the start is finite and `time` finite and >= 0.
Certified certified_integration(const Rate& rate, const std::vector<double>& start, double time,
                                double tolerance = 1e-17);

/// The states after 0, end/parts, … `end` [s], each integrated so from the one before, whose error goes on: for a
/// curve, in the time of few integrations.
std::vector<std::vector<double>> integrated_path(const Rate& rate, const std::vector<double>& start, double end,
                                                 int parts);

}  // namespace byhand
