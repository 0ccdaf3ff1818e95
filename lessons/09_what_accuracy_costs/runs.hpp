#pragma once

#include "lessons/09_what_accuracy_costs/setting.hpp"

#include "lessons/catalogue/run.hpp"

// Single runs that several steps look at.
namespace byhand::accuracy {

/// One error of a run with a setting that is no family's; infinite if the run fails.
double error_of(const Problem& problem, const byhand::Setting& setting, Error error);

/// The period [s] of a pendulum of the catalogue: from one passage through the lowest point to the next but one.
/// (A half-step's phase, which hides the order of symplectic Euler in an angle, is not in it.)
double period(const Problem& problem, const byhand::Setting& setting);

}  // namespace byhand::accuracy
