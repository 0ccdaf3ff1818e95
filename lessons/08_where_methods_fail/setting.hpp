#pragma once

#include "lessons/tutor/lesson.hpp"

namespace byhand::failures {

/// The lesson's parameters.
struct Setting {
  tutor::Parameter<int> resolution;  // cells a side of each map
  tutor::Parameter<int> boxes;       // of the stack that is filmed
  tutor::Parameter<int> sweeps;      // that are too few for it, and for the chain
  tutor::Parameter<int> links;       // of the chains
  tutor::Parameter<double> beta;
  tutor::Parameter<double> end_mass;  // in masses of a link
  tutor::Parameter<double> hertz;     // of soft contacts
  tutor::Parameter<double> conflict;  // of two rods between the same points [m]
};

inline constexpr double gravity = 9.81, step = 1.0 / 60;  // of the scenes [m/s²], [s]

}  // namespace byhand::failures
