#pragma once

#include "lessons/09_what_accuracy_costs/setting.hpp"

#include "lessons/catalogue/catalogue.hpp"

namespace byhand::accuracy {

/// A film: two methods' runs of a pendulum beside their points on a work–precision chart as the step is halved.
void walking_down(const Problem& pendulum, course::Page& page);

}  // namespace byhand::accuracy
