#pragma once

#include "lessons/desk/sheet.hpp"

namespace byhand::desk {

/// Runs the constraint that a sheet derives, five seconds by the solver as any other kind: "pendulum" (one body
/// fixed, the other hung on it), "chain" (two links), "box" (two boxes thrown without gravity). Returns a picture
/// of characters and what was measured, or the sentence that says why it cannot run.
std::string run_scene(const Sheet& sheet, const std::string& scene);

using Point = std::array<double, 2>;  // in the plane of the picture, which space is seen in from +z [m]

/// The parts (6) of one row of J on one body: the force and the torque about the viewer's axis for λ/h = 1.
struct Parts {
  std::size_t body = 0;
  Point linear = {};
  double angular = 0;
};

/// What is drawn of one moment.
struct Moment {
  std::vector<Point> centres;               // by body
  std::vector<std::vector<Point>> corners;  // of each body: 4 in turn in the plane, 8 of a box in space
  std::vector<Parts> parts;                 // of the first row of each constraint, body 1 then body 2
};

/// The same as numbers.
struct Ran {
  double largest_C = 0, largest_rate = 0;  // |C| and |JV| after a step
  int rows = 0;                            // of all constraints in the scene
  std::vector<bool> moves;                 // by body
  std::vector<Moment> moments;             // the beginning, and 60 a second
};
/// Whether an edge of the box joins these two of its corners.
bool is_edge(std::size_t i, std::size_t j);
Ran run_in(const Sheet& sheet, const std::string& scene);
/// What was measured, in a sentence.
std::string measured(const Sheet& sheet, const Ran& ran);

}  // namespace byhand::desk
