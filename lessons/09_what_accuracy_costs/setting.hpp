#pragma once

#include "lessons/pictures/prelude.hpp"

namespace byhand::accuracy {

using namespace course;
using namespace renderer;
using pictures::at, pictures::curve, pictures::each;

/// What the chooser is asked. A number that the scene does not have is named and left aside.
struct Setting {
  course::Parameter<std::string> scene;
  course::Parameter<double> drift, trajectory, energy, momentum, reaction;  // 0: not asked for
  course::Parameter<double> budget;                                         // 0: none
  course::Parameter<int> links;
  course::Parameter<double> end_mass, mass, length;
  course::Parameter<int> boxes;
  course::Parameter<double> top_mass;
  course::Parameter<int> base;
};

/// What these are where nobody sets them.
struct Initial {
  static constexpr int links = 50, boxes = 10, base = 10;
  static constexpr double end_mass = 1, mass = 1, length = 1, top_mass = 1;
};

}  // namespace byhand::accuracy
