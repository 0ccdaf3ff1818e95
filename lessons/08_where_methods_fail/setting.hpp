#pragma once

#include "lessons/pictures/prelude.hpp"

namespace byhand::failures {

using namespace course;
using namespace renderer;
using pictures::at, pictures::curve, pictures::each;

/// The lesson's parameters.
struct Setting {
  course::Parameter<int> resolution;  // cells a side of each map
  course::Parameter<int> boxes;       // of the stack that is filmed
  course::Parameter<int> sweeps;      // that are too few for it, and for the chain
  course::Parameter<double> beta;
  course::Parameter<double> end_mass;  // in masses of a link
  course::Parameter<double> hertz;     // of soft contacts
  int links = 10;                      // of the chain that rings
  double conflict = 0.1;               // of two rods between the same points [m]
};

inline constexpr double gravity = 9.81, step = 1.0 / 60;  // of the scenes [m/s²], [s]

}  // namespace byhand::failures
