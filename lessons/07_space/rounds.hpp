#pragma once

#include "lessons/07_space/setting.hpp"
#include "solver/constraints/normalised_distance.hpp"

namespace byhand::space {

/// A bob on a rod, and the one row that holds it.
using Bob = Simulation<SpaceParticle>;

/// Circling at the speed that keeps it on its cone.
Bob circling(const Setting& setting, double angle);
/// Set out sideways, at the setting's share of that speed.
Bob set_out(const Setting& setting);

/// The rod's angle from straight down [rad].
double from_down(const Bob& bob);

/// What a bob does from one time that it is highest or lowest to the next but one: how long it takes [s] and how
/// far round the vertical it gets [rad].
struct Nutation {
  double period, precession;
};
Nutation nutation_of(Bob bob, double h);

/// The pull of the rod in the last step [N].
double tension(const Bob& bob);
/// The third turn about the vertical: the means of that pull [N] and of the bob's distance from the anchor [m],
/// the least and the largest angle from straight down [rad], and its duration [s].
struct Turn {
  double tension = 0, distance = 0, least = INFINITY, most = 0, period = 0;
};
Turn third_turn(Bob bob, double h);

}  // namespace byhand::space
