#pragma once

#include <functional>

#include "lessons/engines/engine.hpp"

// Contests between engines: the same scene, the same measures, times taken in turns.
namespace byhand::engines {

constexpr double frame = 1.0 / 60;  // [s]

/// Who runs a scene, and how.
template <class M>
struct Contestant {
  std::string name;
  Setting setting;
  std::function<std::unique_ptr<World<M>>(const Scene<M>&)> build;

  /// "substeps 16, joint hertz 240, 4 steps a frame"
  std::string words() const;
};

template <class M>
Contestant<M> contestant(const Engine& engine, const Setting& setting);

/// Calls look(scene, time) after each of so many frames, with the scene's bodies as the contestant has moved them.
template <class M>
void run(const Contestant<M>& contestant, const Scene<M>& scene, int frames,
         const std::function<void(const Scene<M>&, double)>& look);

/// The same, after so many `settling` frames in which the engine comes to its own rest: look's time begins there,
/// and `begin` is called once with that rest. Where it returns true, the velocities it has set become the bodies'.
template <class M>
void run_from_rest(const Contestant<M>& contestant, const Scene<M>& scene, int settling, int frames,
                   const std::function<bool(Scene<M>&)>& begin,
                   const std::function<void(const Scene<M>&, double)>& look);

/// Processor seconds a frame of each contestant, the least mean of `rounds` runs of so many frames. The
/// contestants take turns, so that what else the machine does troubles all alike. Building is not timed.
template <class M>
std::vector<double> seconds_a_frame(const std::vector<Contestant<M>>& contestants, const Scene<M>& scene,
                                    int frames, int rounds);

}  // namespace byhand::engines
