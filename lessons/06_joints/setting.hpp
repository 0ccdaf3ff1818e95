#pragma once

#include "lessons/pictures/prelude.hpp"

namespace byhand::joints {

using namespace course;
using namespace renderer;
using pictures::at, pictures::curve, pictures::each;

/// The lesson's parameters.
struct Setting {
  course::Parameter<double> h;         // [s]
  course::Parameter<double> side;      // of the box on the arm [m]
  course::Parameter<double> angle;     // from which the four-bar is released [deg]
  course::Parameter<double> strength;  // of the motor that holds an arm [mgl]
  course::Parameter<double> speed;     // of the slider-crank [rad/s]
  course::Parameter<int> sweeps;       // over rows in a step
  double length = 2, mass = 3;         // of bars and rods [m], [kg]
  double beta = 0.2;                   // share of an error that a step corrects
  double coupler = 2;                  // mass of the four-bar's coupler [kg]
  double crank = 0.4;                  // of the slider-crank [m]
  double gap = 0.2;                    // between the lengths of two rods [m]
};

inline constexpr double gravity = standard_gravity;

/// The value, or 0 where it is only rounding beside `scale`.
inline double without_rounding(double value, double scale) { return std::abs(value) < 1e-9 * scale ? 0 : value; }

/// All rows at once, and as much of the error as one step can take: what is left is the step's own.
inline VelocityStepping exactly(double regularisation = 0) {
  return {.solver = Direct{.regularisation = regularisation}, .drift = Baumgarte{1}};
}

}  // namespace byhand::joints
