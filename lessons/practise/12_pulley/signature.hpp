#pragma once

#include "practise.hpp"

namespace plain {
/// A rope runs from an anchor of body 1 over two fixed wheels, which are points, to a tackle on body 2 that takes
/// `ratio` lengths of it.
struct Pulley {
  Vec2 wheel1, wheel2;
  double ratio = 1, L = 1;  // L [m]: length1 + ratio · length2
};
}  // namespace plain

/// C, which is 0 where the rope is just taut. p: centres of the bodies, r: from them to the anchors [m].
double value(Vec2 p1, Vec2 r1, Vec2 p2, Vec2 r2, const Pulley& pulley);

/// J of your C.
BodyRow jacobian(Vec2 p1, Vec2 r1, Vec2 p2, Vec2 r2, const Pulley& pulley);

#define FUNCTIONS value, jacobian
