#pragma once

#include "lessons/laws/law.hpp"

namespace byhand::laws {

/// The overlap [m] above which a corrected contact throws its body off.
double popping_overlap(double beta, double step);

/// Law 2: contacts pop.
Law pop();

}  // namespace byhand::laws
