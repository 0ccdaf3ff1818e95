#pragma once

#include <string>
#include <vector>

#include "lessons/scene_file/scene_file.hpp"

// Whether a scene will hold with its method and step, before it is run so: the laws of lesson 8, with every number
// from the scene's own rows.
namespace byhand::doctor {

enum class Grade { fine, near_the_limit, fails };

/// Where a run shows what a finding foresees: in gaps within a few steps, in gaps after a while, or elsewhere.
enum class Shows { elsewhere, at_once, in_time };

/// What to turn, and how far.
struct Knob {
  std::string name;   // of a member of the file's method, or "step"
  double value = 0;   // at which the law no longer limits the scene
  std::string words;  // "substeps = 4"
};

/// What one law says of the scene.
struct Finding {
  int law = 0;  // its number in lesson 8
  Grade grade = Grade::fine;
  std::string quantity = {};  // "ω·h"
  double number = 0, limit = 0;
  double time = 0;               // when it is first beyond its limit [s]
  std::vector<int> bodies = {};  // that it is about
  std::string sentence = {};     // the number, by how much, what happens and when
  std::vector<Knob> knobs = {};  // in the order in which to turn them
  Shows shows = Shows::elsewhere;
  double by_half = 1;  // the number that it foresees for half of the run, of Shows::in_time

  /// By how much the number is beyond its limit.
  double excess() const { return limit > 0 ? number / limit : 0; }
};

struct Diagnosis {
  std::vector<Finding> findings;  // the worst first

  Grade grade() const { return findings.empty() ? Grade::fine : findings.front().grade; }
  /// The law that breaks the scene first; 0 where it holds.
  int law() const { return grade() == Grade::fails ? findings.front().law : 0; }
};

/// Throws std::invalid_argument where the method cannot run the scene.
Diagnosis diagnose(const SceneFile& file);

/// The length of each body [m]: of its shape, else twice its longest arm, else of its rod; 0 of what nothing
/// holds.
std::vector<double> body_sizes(const SceneFile& file);

/// The file with a knob turned.
SceneFile turned(SceneFile file, const Knob& knob);

}  // namespace byhand::doctor
