#pragma once

#include "lessons/catalogue/catalogue.hpp"
#include "lessons/page/page.hpp"

namespace byhand::accuracy {

/// A film: two methods' runs of a pendulum beside their points on a work–precision chart as the step is halved.
void walking_down(const Problem& pendulum, course::Page& page);

}  // namespace byhand::accuracy
