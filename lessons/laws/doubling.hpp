#pragma once

#include "lessons/laws/law.hpp"

namespace byhand::laws {

/// By how much one step of h [s] and two of h/2 differ for a weightless bob that rests with its rod too long by
/// `error` [m], corrected by β per step; read literally, by β [1/s] [m].
double doubling_difference(double beta, double step, double error, bool literally = false);

/// Law 21: step doubling sees a floor under Baumgarte.
Law step_doubling();

}  // namespace byhand::laws
