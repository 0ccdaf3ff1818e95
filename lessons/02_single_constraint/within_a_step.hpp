#pragma once

#include "lessons/02_single_constraint/setting.hpp"

namespace byhand::single_constraint {

/// The film of one step, slowed: gravity, JV, λ, back onto the tangent.
void within_a_step(const Setting& setting, course::Page& page);

}  // namespace byhand::single_constraint
