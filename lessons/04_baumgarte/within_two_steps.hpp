#pragma once

#include "lessons/04_baumgarte/setting.hpp"

namespace byhand::baumgarte {

/// The film of a step that leaves the circle and of the correction in the next: tangent, drift, correction.
void within_two_steps(const Setting& setting, course::Page& page);

}  // namespace byhand::baumgarte
