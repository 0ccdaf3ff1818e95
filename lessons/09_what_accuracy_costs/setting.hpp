#pragma once

#include <string>

#include "lessons/tutor/parameter.hpp"

namespace byhand::accuracy {

/// What the chooser is asked. A number of the scene that another scene does not have is left aside there.
struct Setting {
  tutor::Parameter<std::string> scene;
  tutor::Parameter<double> drift, trajectory, energy, momentum, reaction;  // but for drift, 0: not asked for
  tutor::Parameter<double> budget;                                         // 0: none
  tutor::Parameter<int> links;
  tutor::Parameter<double> end_mass, mass, length;
  tutor::Parameter<int> boxes;
  tutor::Parameter<double> top_mass;
  tutor::Parameter<int> base;
};

}  // namespace byhand::accuracy
