#pragma once

#include "practise.hpp"

namespace plain {
/// A bob on a massless rod that hangs at the origin. Gravity pulls by −g along y.
struct Pendulum {
  Vec2 p, v;  // of the bob [m], [m/s]
  double m = 1, g = 9.81;
};
}  // namespace plain

/// One step of h [s] by symplectic Euler, the rod's row solved by (17) with b = 0.
void step(Pendulum& pendulum, double h);

#define FUNCTIONS step
