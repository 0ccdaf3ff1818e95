#pragma once

#include "lessons/laws/law.hpp"

namespace byhand::laws {

/// A weightless bob on a rod that is 1 mm too long, corrected by β per step; read literally, by β [1/s].
Outcome stretched_rod(double beta, double step, bool literally = false);

/// Law 1: what a correction by β leaves of one row's error.
Law one_row();

/// Law 3: drift without correction.
Law uncorrected_drift();

}  // namespace byhand::laws
