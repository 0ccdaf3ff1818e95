#pragma once

#include "lessons/practise/learner/practise.hpp"

namespace byhand::single_constraint {

/// One time step of h [s] of a bob of mass m [kg] at x [m] with velocity v [m/s], on a rod from the origin; g is
/// gravity [m/s²], b = 0. In the page of this lesson its reader may change it.
void plain_step(Vec2& x, Vec2& v, double m, Vec2 g, double h);

}  // namespace byhand::single_constraint
