#pragma once

#include "lessons/tutor/parameter.hpp"

namespace byhand::beside {

/// The parameters of this lesson.
struct Setting {
  tutor::Parameter<int> links;        // of the chain
  tutor::Parameter<double> end_mass;  // of its last link [kg]; the others weigh 1 kg
  tutor::Parameter<int> base;         // boxes in the pyramid's lowest row
  tutor::Parameter<int> boxes;        // of the stack
  tutor::Parameter<double> friction;  // of the block on the slope
};

}  // namespace byhand::beside
