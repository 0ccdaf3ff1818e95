#pragma once

#include "lessons/10_beside_the_engines/setting.hpp"

#include "lessons/engines/contest.hpp"

// Who takes part in a contest, and the charts of its outcome.
namespace byhand::beside {

using engines::Contestant;
using engines::Engine;
using engines::frame;
constexpr double gravity = 9.81;  // [m/s²]

/// The names under which the course's solver takes part.
inline const std::string ours_name = "this course";

/// The course's solver as it is best used: by the scene's graph, with `substeps` a frame and at most so many
/// sweeps where the graph has loops. A tolerance below the default saves sweeps: what it leaves would rock on.
inline VelocityStepping best_method(int substeps = 1, int most_sweeps = 50) {
  ByGraph solver;
  solver.loops = {.sweeps = most_sweeps, .tolerance = 1e-6};
  VelocityStepping method{solver, Baumgarte{.beta = 0.2, .slop = 0.001, .speed_cap = 3}};
  method.substeps = substeps;
  return method;
}

/// A contestant in several settings, the first of which is its default.
template <class M>
struct Entrant {
  std::string name;
  std::vector<Contestant<M>> settings;
};

/// The course's solver, then each engine that `may` take part: with its defaults, and with 2, 4, … `most` times as
/// many iterations or steps a frame.
template <class M>
std::vector<Entrant<M>> entrants(int substeps, int most, const std::function<bool(const Engine&)>& may) {
  std::vector<Entrant<M>> all{{ours_name, {}}};
  const auto add_ours = [&](int count) {
    all.front().settings.push_back(engines::ours<M>(ours_name, best_method(count)));
    all.front().settings.back().setting = course::several(count, "substep", "substeps");
    all.front().settings.back().effort = count;
  };
  add_ours(substeps);
  for (int more = 1; more <= substeps * most && most > 1; more *= 2)
    if (more != substeps) add_ours(more);
  for (const Engine& engine : engines::all_engines()) {
    if (!may(engine)) continue;
    Entrant<M> entrant{engine.name, {engines::theirs<M>(engine, engine.usual)}};
    for (int more = 2; more <= most; more *= 2) {
      const auto add = [&](int knob, int steps, int number, const std::string& of_what) {
        entrant.settings.push_back(engines::theirs<M>(engine, knob, steps));
        entrant.settings.back().setting = std::to_string(number) + " " + of_what;
      };
      if (!engine.knob.empty()) add(engine.usual * more, 1, engine.usual * more, engine.knob);
      if (engine.knob != "substeps") add(engine.usual, more, more, "steps a frame");
    }
    all.push_back(entrant);
  }
  return all;
}

/// The error of each setting of an entrant; infinite where it failed.
struct Errors {
  std::string name;
  std::vector<double> by_setting;

  double usual() const { return by_setting.front(); }
  double least() const { return *std::min_element(by_setting.begin(), by_setting.end()); }
};

/// error(contestant) of every setting. The engines keep global variables, so that no two run at once.
template <class M, class F>
std::vector<Errors> errors_of(const std::vector<Entrant<M>>& all, F&& error) {
  std::vector<Errors> result;
  for (const Entrant<M>& entrant : all) {
    Errors errors{entrant.name, {}};
    for (const Contestant<M>& contestant : entrant.settings) {
      const double found = error(contestant);
      errors.by_setting.push_back(std::isfinite(found) ? found : INFINITY);
    }
    result.push_back(std::move(errors));
  }
  return result;
}

/// "1.2 mm", "failed".
std::string in_millimetres(double metres);

/// The least effort with which the course has that error, or a hundredth more: "2 substeps", "none of its
/// settings".
template <class M>
std::string reached_with(const Entrant<M>& ours, const Errors& errors, double wanted);

/// The default and the best setting of each entrant, on a logarithmic axis.
renderer::Chart compared(const std::vector<Errors>& all, const std::string& label);

/// One curve over the names of entrants, on a logarithmic axis.
renderer::Chart by_name(const std::vector<std::string>& names, std::vector<renderer::Curve> curves,
                        const std::string& label);

/// Error against microseconds a frame, one curve an entrant: of its settings those that no other of its own beats
/// in both. The title compares the course with the fastest engine, at equal time and at equal error.
template <class M>
renderer::Chart against_time(const std::vector<Entrant<M>>& all, const std::vector<Errors>& errors,
                             const Scene<M>& scene, int frames, const std::string& label);

/// Who takes part in a scene, and with which errors.
template <class M>
struct Contest {
  std::string name;
  Scene<M> scene;
  std::vector<Entrant<M>> entrants;
  std::vector<Errors> errors;
};

/// For each contest the course beside the engine that is fastest there: its least time for no more than that
/// engine's error, over that engine's time, and its least error in no more than that time, over that error.
template <class M>
renderer::Chart at_equal_error(const std::vector<Contest<M>>& contests, int frames);

/// The overlap of shapes that is deepest [m].
template <class M>
double deepest_overlap(const Scene<M>& scene);

/// How far the body has come that has come farthest [m].
template <class M>
double farthest(const Scene<M>& from, const Scene<M>& now) {
  double most = 0;
  for (int i = 0; i < from.bodies().size(); ++i)
    most = larger(most, (now.bodies().pose[i].position - from.bodies().pose[i].position).norm());
  return most;
}

/// Sweeps of the course's solver in the first and in the last of so many frames.
template <class M>
std::pair<int, int> first_and_last_sweeps(const Scene<M>& scene, int frames);

/// The names of the others with an error below that of the course's solver, by default.
std::string ahead_of_ours(const std::vector<Errors>& all);

}  // namespace byhand::beside
