#pragma once

#include "lessons/scene_file/scene_file.hpp"

namespace byhand::doctor {

/// How the file's method solves and corrects, as far as the laws ask.
struct Treatment {
  double h = 0;    // a substep [s]
  int passes = 0;  // of sweeps in a substep; 0 solves exactly
  bool warm_start = true;
  double beta = 0;             // share of C that a substep takes back
  double slop = 0;             // [m]
  bool adds_velocity = false;  // whether the correction is a velocity, which stays
  bool regularised = true;     // whether rows that repeat have an answer
  double frequency = 0;        // ω of soft constraints [rad/s]; 0: rows are hard
  bool stale = false;          // whether the velocities end along the rows of the step's beginning
};
Treatment treatment_of(const SceneFile& file);

/// One sweep of the file's method.
RowSolver one_sweep_of(const RowSolver& solver);

}  // namespace byhand::doctor
