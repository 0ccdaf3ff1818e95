#pragma once

#include "lessons/pictures/prelude.hpp"

namespace byhand::contact {

using namespace course;
using namespace renderer;
using pictures::at, pictures::curve, pictures::each;

/// The lesson's parameters.
struct Setting {
  course::Parameter<double> h, beta;     // [s], [1]
  course::Parameter<double> width;       // of the box that stands on two contacts, 1 m high [m]
  course::Parameter<double> friction;    // μ [1]
  course::Parameter<int> boxes, sweeps;  // of the stack
  double mass = 3;                       // of the box that stands, slides and bounces [kg]
  double depth = 0.3, cap = 1;           // of the overlap at the start [m], on the speed of its cure [m/s]
  double slope = 25;                     // [deg]
  double speed = 3;                      // of the box that is pushed, the cradle's first ball [m/s]
  double restitution = 0.5, drop = 1;    // e [1], height of the first fall [m]
  int balls = 5;                         // of the cradle
  int base = 10;                         // boxes in the pyramid's lowest row
  double ratio = 100;                    // mass of the upper box over that of the lower [1]
};

inline constexpr double gravity = standard_gravity;

/// The value, or 0 where it is only rounding beside `scale`.
inline double without_rounding(double value, double scale) { return std::abs(value) < 1e-9 * scale ? 0 : value; }

}  // namespace byhand::contact
