#pragma once

#include "lessons/07_space/setting.hpp"

namespace byhand::space {

/// A film: ω, the three parts of Iω, and how they turn with a book on which no torque acts. `careless` is the
/// share of the spin about each other axis. Claims that Iω stays and that the spin follows Euler's equations.
void turning_with_the_body(const Setting& setting, double careless, course::Page& page);

}  // namespace byhand::space
