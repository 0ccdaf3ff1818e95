#pragma once

#include "lessons/pictures/prelude.hpp"

namespace byhand::contact {

using namespace course;
using namespace renderer;
using pictures::at, pictures::curve, pictures::each;

/// The lesson's parameters.
struct Setting {
  course::Parameter<double> h, beta;            // [s], [1]
  course::Parameter<double> mass;               // of the box that stands, slides and bounces [kg]
  course::Parameter<double> width;              // of the box that stands on two contacts, 1 m high [m]
  course::Parameter<double> depth, cap;         // of the overlap at the start [m], on the speed of its cure [m/s]
  course::Parameter<double> friction, slope;    // μ [1], [deg]
  course::Parameter<double> speed;              // of the box that is pushed, the cradle's first ball [m/s]
  course::Parameter<double> restitution, drop;  // e [1], height of the first fall [m]
  course::Parameter<int> balls;                 // of the cradle
  course::Parameter<int> boxes, sweeps;         // of the stack
  course::Parameter<int> base;                  // boxes in the pyramid's lowest row
  course::Parameter<double> ratio;              // mass of the upper box over that of the lower [1]
};

inline constexpr double gravity = standard_gravity;

/// The value, or 0 where it is only rounding beside `scale`.
inline double without_rounding(double value, double scale) { return std::abs(value) < 1e-9 * scale ? 0 : value; }

}  // namespace byhand::contact
