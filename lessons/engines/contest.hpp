#pragma once

#include <functional>
#include <optional>

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

/// How a run begins: with so many `settling` frames in which the engine comes to its own rest. Then `begin` is
/// called once with that rest. Where it returns true, the velocities it has set become the bodies'.
template <class M>
struct Start {
  int settling = 0;
  std::function<bool(Scene<M>&)> begin = [](Scene<M>&) { return false; };
};

/// The same from such a start: look's time begins after it.
template <class M>
void run_from(const Start<M>& start, const Contestant<M>& contestant, const Scene<M>& scene, int frames,
              const std::function<void(const Scene<M>&, double)>& look);

/// The same for as long as look says true.
template <class M>
void run_while(const Start<M>& start, const Contestant<M>& contestant, const Scene<M>& scene, int frames,
               const std::function<bool(const Scene<M>&, double)>& look);

/// Processor seconds a frame: of the quickest and the slowest of some rounds.
struct Seconds {
  double least = 0, most = 0;
};

/// Those of each contestant, the mean of so many frames after the start in each round, which lasts a millisecond
/// at least. The contestants take turns, so that what else the machine does troubles all alike. Building and the
/// start are not timed.
template <class M>
std::vector<Seconds> seconds_a_frame(const Start<M>& start, const std::vector<Contestant<M>>& contestants,
                                     const Scene<M>& scene, int frames, int rounds);

/// A setting's time and error.
struct Point {
  Seconds seconds;
  double error = 0;
  std::string words = {};
};

/// Errors within a hundredth of each other count as equal, and times within a tenth: as much does one differ from
/// run to run of a program.
constexpr double equal_errors = 1.01, equal_times = 1.1;

/// One entrant beside another, by the quickest rounds: what else the machine does makes a round slower, never
/// quicker. Two are compared within any time that leaves both a run: ahead if some point of its own, a tenth
/// slower, then has a smaller error than each point of the other that is as fast; level if only without that
/// tenth.
enum class Rank { behind, level, ahead };
struct Beside {
  Rank rank = Rank::behind;
  Point point = {};  // of those that are ahead, or level, the one with the least error
  // Of those, too, that are quicker than every run of the other, by a tenth.
  std::optional<Point> quicker = {};
};
Beside at_equal_time(const std::vector<Point>& points, const std::vector<Point>& others);

}  // namespace byhand::engines
