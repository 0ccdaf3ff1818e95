#pragma once

#include "practise.hpp"

namespace plain {
/// Equal rods and equal bobs, and how they are stepped.
struct Setting {
  double length = 1, mass = 1;    // of each rod [m], of each bob [kg]
  double g = 9.81;                // gravity pulls by −g along y [m/s²]
  double h = time_step;           // of a step [s]
  double beta = 0.2;              // share of a rod's error that a step takes away
  double sweeps = 20, steps = 1;  // sweeps in each step, and steps
};

struct Bob {
  Vec2 p, v;        // [m], [m/s]
  double pull = 0;  // of the rod that it hangs by, in the last step [N]
};
}  // namespace plain

/// Moves a chain through all steps. The first bob hangs by a rod at the origin, which does not move; each other by
/// a rod at the bob before it. λ begins at 0 in each step, and a sweep goes from the origin down.
void simulate(const Setting& setting, std::span<Bob> bobs);

#define FUNCTIONS simulate
