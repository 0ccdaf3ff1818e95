#pragma once

#include "lessons/pictures/prelude.hpp"

namespace byhand::beside {

using namespace course;
using namespace renderer;
using pictures::at, pictures::curve, pictures::each;

/// The parameters of this lesson.
struct Setting {
  course::Parameter<int> links;        // of the chain
  course::Parameter<double> end_mass;  // of its last link [kg]; the others weigh 1 kg
  course::Parameter<int> base;         // boxes in the pyramid's lowest row
  course::Parameter<int> boxes;        // of the stack
  course::Parameter<double> friction;  // of the block on the slope
};

}  // namespace byhand::beside
