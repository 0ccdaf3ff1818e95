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

/// Processor seconds a frame: of the quickest and the slowest of some rounds.
struct Seconds {
  double least = 0, most = 0;
};

/// Those of each contestant, the mean of so many frames in each round. The contestants take turns, so that what
/// else the machine does troubles all alike. Building is not timed.
template <class M>
std::vector<Seconds> seconds_a_frame(const std::vector<Contestant<M>>& contestants, const Scene<M>& scene,
                                     int frames, int rounds);

/// A setting's time and error.
struct Point {
  Seconds seconds;
  double error = 0;
  std::string words = {};
};

/// Errors within a hundredth of each other count as equal.
constexpr double equal_errors = 1.01;

/// One entrant beside another. Two are compared at a time within which both have a run: ahead if some point of its
/// own has a smaller error than each point of the other that might be as fast, its slowest round against the
/// other's quickest; level if only its quickest round would be ahead. Neither, but quicker, if the other has no
/// run as fast.
enum class Rank { behind, quicker, level, ahead };
struct Beside {
  Rank rank = Rank::behind;
  double seconds = 0;  // of the quickest such point
};
Beside at_equal_time(const std::vector<Point>& points, const std::vector<Point>& others);

}  // namespace byhand::engines
