#pragma once

#include <string_view>

#include "lessons/catalogue/any_scene.hpp"

// What a run costs, counted: the same on every machine. The unit is one row-solve of Gauss–Seidel, (17) and (20).
// Whatever a substep sets up besides (rows written, bodies moved, contacts found) is charged what it takes in
// instructions beside such a row-solve.
namespace byhand {

/// Row-solves of Gauss–Seidel that each count of an Effort amounts to.
struct Weights {
  double row_solve = 1, row = 0, body = 0, contact = 0, substep = 0, step = 0;
};

/// Of the family of that name, for bodies that turn in space or for all others; calibrated by
/// tests/lessons/09_what_accuracy_costs/calibrate.cpp.
Weights weights_of(std::string_view family, bool in_space = false);

inline double cost_of(const Effort& effort, const Weights& weights) {
  return weights.row_solve * static_cast<double>(effort.row_solves) +
         weights.row * static_cast<double>(effort.rows) + weights.body * static_cast<double>(effort.bodies) +
         weights.contact * static_cast<double>(effort.contacts) +
         weights.substep * static_cast<double>(effort.substeps) + weights.step * static_cast<double>(effort.steps);
}

}  // namespace byhand
