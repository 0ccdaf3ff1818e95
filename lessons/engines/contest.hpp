#pragma once

#include <functional>

#include "lessons/engines/engine.hpp"
#include "solver/step.hpp"

// Contests between engines and the course's solver: the same scene, the same measures, times taken in turns.
namespace byhand::engines {

constexpr double frame = 1.0 / 60;  // [s]

/// Who runs a scene, and how: `steps` equal steps a frame.
template <class M>
struct Contestant {
  std::string name;
  std::function<std::unique_ptr<World<M>>(const Scene<M>&)> build;
  int steps = 1;
  std::string setting = "its default";
  int effort = 1;  // how far its knob is turned, to compare its own settings by
};

template <class M>
Contestant<M> ours(std::string name, const VelocityStepping& method, int steps = 1);
template <class M>
Contestant<M> theirs(const Engine& engine, int knob, int steps = 1);

/// Calls look(scene, time) after each of so many frames, with the scene's bodies as the contestant has moved them.
template <class M>
void run(const Contestant<M>& contestant, const Scene<M>& scene, int frames,
         const std::function<void(const Scene<M>&, double)>& look);

/// Processor seconds a frame of each contestant, the least mean of `rounds` runs of so many frames. The
/// contestants take turns, so that what else the machine does troubles all alike. Building is not timed.
template <class M>
std::vector<double> seconds_a_frame(const std::vector<Contestant<M>>& contestants, const Scene<M>& scene,
                                    int frames, int rounds);

}  // namespace byhand::engines
