#pragma once

#include "lessons/06_joints/setting.hpp"
#include "lessons/scenes/four_bar.hpp"

namespace byhand::joints {

using FourBar = Simulation<PlaneBody>;

/// The lesson's four-bar linkage: arms of the lesson's length and mass, a coupler half as long again.
FourBarOptions bars_of(const Setting& setting, double angle, int arms = 2);

/// Its angle from straight down [rad], read off one of its arms, 1 or 2.
double arm_angle(const FourBar& linkage, int arm = 1);

}  // namespace byhand::joints
