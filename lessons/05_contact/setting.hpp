#pragma once

#include <cmath>

#include "lessons/tutor/lesson.hpp"

namespace byhand::contact {

/// The lesson's parameters.
struct Setting {
  tutor::Parameter<double> h, beta;            // [s], [1]
  tutor::Parameter<double> mass;               // of the box that stands, slides and bounces [kg]
  tutor::Parameter<double> width;              // of the box that stands on two contacts, 1 m high [m]
  tutor::Parameter<double> depth, cap;         // of the overlap at the start [m], on the speed of its cure [m/s]
  tutor::Parameter<double> friction, slope;    // μ [1], [deg]
  tutor::Parameter<double> speed;              // of the box that is pushed, the cradle's first ball [m/s]
  tutor::Parameter<double> restitution, drop;  // e [1], height of the first fall [m]
  tutor::Parameter<int> balls;                 // of the cradle
  tutor::Parameter<int> boxes, sweeps;         // of the stack
  tutor::Parameter<int> base;                  // boxes in the pyramid's lowest row
  tutor::Parameter<double> ratio;              // mass of the upper box over that of the lower [1]
};

inline constexpr double gravity = 9.81;  // [m/s²], as Scene has it
inline constexpr double pi = 3.14159265358979323846;
inline double radians(double degrees) { return degrees / 180 * pi; }
inline double degrees(double radians) { return radians / pi * 180; }

/// The value, or 0 where it is only rounding beside `scale`.
inline double without_rounding(double value, double scale) { return std::abs(value) < 1e-9 * scale ? 0 : value; }

}  // namespace byhand::contact
