#pragma once

#include "lessons/06_joints/setting.hpp"

namespace byhand::joints {

/// A film: one anchor, row by row, what motion each row leaves to a bar, and a claim about the pin.
void rows_adding_up(const Setting& setting, course::Page& page);

}  // namespace byhand::joints
