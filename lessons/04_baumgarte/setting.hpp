#pragma once

#include "lessons/pictures/prelude.hpp"

namespace byhand::baumgarte {

using namespace course;
using namespace renderer;
using pictures::at, pictures::curve, pictures::each;

/// The lesson's parameters.
struct Setting {
  course::Parameter<double> beta, h;         // [1], [s]
  course::Parameter<double> speed, release;  // round the circle [m/s], of the pendulum [deg]
  course::Parameter<int> links, sweeps;      // of the chain
  double length = 2, mass = 3, error = 0.1;  // of the rod [m], of the bob [kg], at the start [m]
};

inline constexpr double gravity = standard_gravity;

/// The value, or 0 where it is only rounding beside `scale`.
inline double without_rounding(double value, double scale) { return std::abs(value) < 1e-9 * scale ? 0 : value; }

}  // namespace byhand::baumgarte
