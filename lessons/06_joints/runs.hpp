#pragma once

#include "lessons/06_joints/setting.hpp"

namespace byhand::joints {

/// Steps of h [s] up to the time [s] (never back), and calls `look` after each.
template <class M, class F>
void advance_to(Simulation<M>& simulation, double time, double h, F&& look) {
  while (simulation.time < time - h / 2) {
    simulation.step(h);
    look();
  }
}
template <class M>
void advance_to(Simulation<M>& simulation, double time, double h) {
  advance_to(simulation, time, h, [] {});
}

/// The simulation as it is at that time [s].
template <class M>
Simulation<M> after(Simulation<M> simulation, double time, double h) {
  advance_to(simulation, time, h);
  return simulation;
}

}  // namespace byhand::joints
