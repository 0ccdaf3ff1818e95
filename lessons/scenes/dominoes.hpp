#pragma once

#include "lessons/scenes/boxes.hpp"

namespace byhand {

/// A row of standing boxes of 0.2 × 1 m and 1 kg, `spacing` [m] from one centre to the next towards +x. The first
/// is tipped: it turns about its lower right corner at `tipping` [rad/s], clockwise. Body 0 is the ground, body i
/// the i-th domino.
inline Scene<PlaneBody> dominoes(int count, double spacing, double tipping = 0, const Surface& surface = {}) {
  require(count >= 1, "number of dominoes", count, "at least 1");
  require(spacing > 0.2, "spacing", spacing, "more than 0.2 m, the width of a domino");
  Scene<PlaneBody> scene;
  add_ground(scene, surface);
  for (int i = 0; i < count; ++i) {
    Pose<PlaneBody> standing;
    standing.position = {i * spacing, 0.5};
    add_box(scene, standing, 1, {0.2, 1}, surface);
  }
  scene.set_velocity(1, {0.5 * tipping, 0.1 * tipping, -tipping});
  return scene;
}

}  // namespace byhand
