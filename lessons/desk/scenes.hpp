#pragma once

#include "lessons/desk/sheet.hpp"

namespace byhand::desk {

/// Runs the constraint that a sheet derives, five seconds by the solver as any other kind: "pendulum" (one body
/// fixed, the other hung on it), "chain" (two links), "box" (two boxes thrown without gravity). Returns a picture
/// of characters and what was measured, or the sentence that says why it cannot run.
std::string run_scene(const Sheet& sheet, const std::string& scene);

/// The same as numbers.
struct Ran {
  double largest_C = 0, largest_rate = 0;                 // |C| and |JV| after a step
  int rows = 0;                                           // of all constraints in the scene
  std::vector<std::vector<std::array<double, 2>>> paths;  // of each body that moves
};
Ran run_in(const Sheet& sheet, const std::string& scene);

}  // namespace byhand::desk
