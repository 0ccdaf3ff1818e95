#pragma once

#include <string>
#include <vector>

#include "lessons/practise/learner/practise.hpp"

namespace byhand::practise {

/// What a picture shows at one instant; numbers alone, so that a film can be kept and sent.
struct Shape {
  enum Kind { bob, rod, box, anchor, ground } kind;
  Vec2 at, to;       // box: `to` holds its sides
  double angle = 0;  // [rad]
};

struct Frame {
  std::vector<Shape> shapes;
  double reading = 0;
};

/// What a learner's code does to a scene, 30 frames a second.
struct Film {
  std::string title;           // "Two boxes on a rod"
  std::string quantity, unit;  // of the reading
  std::vector<Frame> frames;
};

inline constexpr int frames_per_second = 30;

}  // namespace byhand::practise
