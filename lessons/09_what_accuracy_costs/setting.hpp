#pragma once

#include <string>

#include "lessons/tutor/parameter.hpp"

namespace byhand::accuracy {

/// What the chooser is asked. A number that the scene does not have is named and left aside.
struct Setting {
  tutor::Parameter<std::string> scene;
  tutor::Parameter<double> drift, trajectory, energy, momentum, reaction;  // 0: not asked for
  tutor::Parameter<double> budget;                                         // 0: none
  tutor::Parameter<int> links;
  tutor::Parameter<double> end_mass, mass, length;
  tutor::Parameter<int> boxes;
  tutor::Parameter<double> top_mass;
  tutor::Parameter<int> base;
};

/// What these are where nobody sets them.
struct Initial {
  static constexpr int links = 50, boxes = 10, base = 10;
  static constexpr double end_mass = 1, mass = 1, length = 1, top_mass = 1;
};

}  // namespace byhand::accuracy
