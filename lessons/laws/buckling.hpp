#pragma once

#include "lessons/laws/law.hpp"

namespace byhand::laws {

/// The load μ = mg/κ at which a column of N boxes of unit height buckles whose faces answer a turn θ by κθ, the
/// lowest by base × κθ: 7.837/N³ for many boxes.
double buckling_load(int boxes, double base);

/// The softest contacts [Hz] on which a column of unit boxes stands.
double softest_contacts(int boxes);

/// Law 17: soft contacts buckle.
Law buckling();

}  // namespace byhand::laws
