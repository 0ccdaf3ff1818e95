#pragma once

#include "lessons/pictures/prelude.hpp"

namespace byhand::joints {

using namespace course;
using namespace renderer;
using pictures::at, pictures::curve, pictures::each;

/// The lesson's parameters.
struct Setting {
  course::Parameter<double> length, mass, h, beta;  // of bars and rods [m], [kg], [s], [1]
  course::Parameter<double> side;                   // of the box on the arm [m]
  course::Parameter<double> angle, coupler;         // release of the four-bar [deg], its coupler's mass [kg]
  course::Parameter<double> strength;               // of the motor that holds an arm [mgl]
  course::Parameter<double> crank, speed;           // of the slider-crank [m], [rad/s]
  course::Parameter<double> gap;                    // between the lengths of two rods [m]
  course::Parameter<int> sweeps;                    // over rows in a step
};

inline constexpr double gravity = standard_gravity;

/// The value, or 0 where it is only rounding beside `scale`.
inline double without_rounding(double value, double scale) { return std::abs(value) < 1e-9 * scale ? 0 : value; }

/// All rows at once, and as much of the error as one step can take: what is left is the step's own.
inline VelocityStepping exactly(double regularisation = 0) {
  return {.solver = Direct{.regularisation = regularisation}, .drift = Baumgarte{1}};
}

}  // namespace byhand::joints
