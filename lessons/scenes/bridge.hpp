#pragma once

#include "lessons/scenes/rod.hpp"
#include "solver/constraints/pin.hpp"
#include "solver/scene.hpp"

namespace byhand {

/// Planks pinned end to end between two anchors at one height.
struct BridgeOptions {
  int planks = 10;              // >= 2
  double length = 1, mass = 1;  // of one plank [m, kg]
  double slope = 0.3;           // of the steepest plank at first [rad], in (0, π/2]: a level bridge is taut
};

/// The bridge hangs in an arc below the level of its anchors, the left one at the origin. Body 0 is the ground,
/// body i the i-th plank from the left; pin i - 1 holds plank i by its left end, the last pin the last plank by
/// its right.
inline Scene<PlaneBody> bridge(const BridgeOptions& options) {
  require(options.planks >= 2, "number of planks", options.planks, "at least 2");
  require(0 < options.slope && options.slope <= 1.57, "slope of the bridge", options.slope, "in (0, 1.57] [rad]");
  using M = PlaneBody;
  Scene<M> scene;
  const int ground = scene.add_body(Linear<M>(0, 0), fixed<M>());
  Linear<M> end(0, 0);
  for (int i = 1; i <= options.planks; ++i) {
    const double share = (i - 1.0) / (options.planks - 1);  // of the way across
    const auto [sin, cos] = sin_cos((2 * share - 1) * options.slope);
    const Linear<M> next = end + options.length * Linear<M>(cos, sin);
    const PlaneRod plank(end, next, options.mass);
    const int body = scene.add_body(plank.pose, plank.mass);
    scene.add(pin<M>(scene.bodies(), i == 1 ? ground : body - 1, body, end));
    end = next;
  }
  scene.add(pin<M>(scene.bodies(), options.planks, ground, end));
  return scene;
}

}  // namespace byhand
