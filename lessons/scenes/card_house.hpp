#pragma once

#include <numbers>

#include "lessons/scenes/boxes.hpp"

namespace byhand {

/// A house of cards of `storeys`: tents of two cards of 0.02 × 1 m that lean against each other at `lean` [rad]
/// from upright, one tent less in each storey, and level cards from ridge to ridge; all of 1 kg. Cards touch at
/// corners, and friction alone holds them: it wants a coefficient above tan(lean). Body 0 is the ground.
inline Scene<PlaneBody> card_house(int storeys, double lean = 0.3, const Surface& surface = {}) {
  require(storeys >= 1, "number of storeys", storeys, "at least 1");
  require_in("lean", lean, 0.1, 0.5, "rad");
  const double thick = 0.02, length = 1;
  const auto [sin, cos] = sin_cos(lean);
  // From a leaning card's centre to the corner by which it touches the other, and down to the one on which it
  // stands:
  const double across = 0.5 * (length * sin + thick * cos), up = 0.5 * (length * cos + thick * sin);
  const double tent = 4 * across;  // from one ridge to the next [m]
  Scene<PlaneBody> scene;
  add_ground(scene, surface);
  const auto add_card = [&](double x, double y, double angle, const Linear<PlaneBody>& sides) {
    add_box(scene, Pose<PlaneBody>{{x, y}, plane_rotation(angle)}, 1, sides, surface);
  };
  for (int storey = 0; storey < storeys; ++storey) {
    const double floor = storey * (2 * up + thick);
    const int tents = storeys - storey;
    for (int i = 0; i < tents; ++i) {
      const double ridge = tent * (i - 0.5 * (tents - 1));
      add_card(ridge - across, floor + up, -lean, {thick, length});
      add_card(ridge + across, floor + up, lean, {thick, length});
    }
    for (int i = 0; i + 1 < tents; ++i)
      add_card(tent * (i - 0.5 * (tents - 2)), floor + 2 * up + 0.5 * thick, 0, {tent - thick, thick});
  }
  return scene;
}

}  // namespace byhand
