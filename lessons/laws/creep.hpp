#pragma once

#include "lessons/laws/closed_forms.hpp"
#include "lessons/laws/law.hpp"

namespace byhand::laws {

/// The gravity [m/s²] up to which so many sweeps of a time step [s] hold a column of boxes.
double gravity_that_sweeps_hold(int boxes, int sweeps, double step, const BoxSize& size = {});

/// The regularisation, a share of the diagonal, up to which an exact solve with a time step [s] holds it.
double regularisation_that_holds(int boxes, double step);

/// Law 18: why columns solved by sweeps fall.
Law creep();

/// Law 20: what has nothing to do with it, and what has.
Law exact_columns();

}  // namespace byhand::laws
