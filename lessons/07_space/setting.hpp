#pragma once

#include <Eigen/Core>

#include "lessons/pictures/prelude.hpp"

namespace byhand::space {

using namespace course;
using namespace renderer;
using pictures::at, pictures::curve, pictures::each;

/// The lesson's parameters.
struct Setting {
  course::Parameter<double> h;             // [s]
  course::Parameter<double> tilt;          // of the book that is caught [deg]
  course::Parameter<double> angle;         // of the cone [deg]
  course::Parameter<double> spin, wobble;  // of the book [rad/s], beside its middle axis [1]
  course::Parameter<double> friction;      // μ [1]
  double length = 2, mass = 3;             // of rods [m], of each body [kg]
  double share = 0.5;                      // of the speed that keeps the cone [1]
  double speed = 4, heading = 30;          // of the pucks [m/s], of the one that is looked at closely [deg]
};

inline constexpr double gravity = standard_gravity;

/// A thick book [m]: the moments about x, y and z differ, y is the middle one.
inline Eigen::Vector3d book_sides() { return {1.2, 0.8, 0.2}; }

}  // namespace byhand::space
