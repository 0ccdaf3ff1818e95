#pragma once

#include <string>

#include "lessons/catalogue/catalogue.hpp"

// What the laws of lesson 8 say of a problem before anything is run.
namespace byhand {

/// The law that limits a problem, at one step a frame.
struct LawLimit {
  int law = 0;         // its number; 0: none
  std::string number;  // what it asks about: "T·h²/(m·l) = 818"
  int substeps = 1;    // the fewest in a frame that it allows where J is held still over a step
  int sweeps = 1;      // the fewest of Gauss–Seidel in one step that it allows
};
LawLimit limit_of(const Problem& problem);

/// By law 7: in how many parts a frame has to be cut. Nothing of a scene without joints.
int substeps_of_law_7(const Problem& problem);

/// The share ρ of the slowest error that one sweep of Gauss–Seidel leaves, by law 4; with a relaxation ω by
/// Young's formula. NaN for a scene that the law does not know.
double left_by_a_sweep(const Problem& problem, double relaxation = 1);

/// The β below which sweeps from a warm start settle, by laws 1 and 6; by law 1 alone where law 4 does not know
/// the scene.
double largest_beta(const Problem& problem, int sweeps, double relaxation = 1);

}  // namespace byhand
