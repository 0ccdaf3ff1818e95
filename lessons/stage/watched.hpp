#pragma once

#include <string>
#include <vector>

#include "lessons/catalogue/any_scene.hpp"
#include "lessons/scene_file/scene_file.hpp"

namespace byhand::stage {

/// One moment of a run.
struct Sample {
  double time = 0;        // [s]
  double energy = 0;      // kinetic and potential [J]
  double separation = 0;  // largest gap of a joint or overlap of two bodies [m]
};

/// A run of a scene.
struct Watched {
  std::vector<Sample> samples;  // the first at time 0, then one a step
  // Where the bodies are, at most 600 times, the first at time 0 and the last at the end.
  std::vector<std::vector<Placement>> instants;
  std::vector<double> times;  // of the instants [s]
  std::string stopped = {};   // why it ended early, in one sentence; empty if it did not
  Effort effort = {};
  double energy_scale = 0;  // [J]

  double end() const { return samples.back().time; }
  double largest_separation() const;  // [m]
  double energy_change() const;       // largest, by the scale
  /// The last instant that is not later than a time [s].
  const std::vector<Placement>& at(double time) const;
};

/// Runs a file's scene with its own method and step for its duration, or with another method. Throws
/// std::invalid_argument where the method cannot run it.
Watched watch(const SceneFile& file);
Watched watch(const SceneFile& file, const Method& method);

/// The same choices for scenes of any model.
AnyStepping any_stepping(const VelocityStepping& method);

}  // namespace byhand::stage
