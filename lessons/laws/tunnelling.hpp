#pragma once

#include "lessons/laws/law.hpp"

namespace byhand::laws {

/// Balls of 5 cm radius that fly at a wall of `wall` [m] at `speed` [m/s], each a two-hundredth of a step ahead of
/// the one before.
struct FlyingBalls {
  double speed = 10, wall = 0.1;
  double margin = 0.02;  // from which contacts are seen [m]
  double lookahead = 0;  // by how many steps of its approach a contact is seen before that
  double step = 1.0 / 60;
};
/// The share of them that ends behind it.
double share_that_passes(const FlyingBalls& balls, int how_many = 200);

/// Law 16: what is fast passes unseen.
Law tunnelling();

}  // namespace byhand::laws
