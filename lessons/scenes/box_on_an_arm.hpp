#pragma once

#include "lessons/scenes/pendulum.hpp"
#include "solver/constraints/pin.hpp"

namespace byhand {

/// A square box of `side` [m] and 1 kg, pinned to the origin by a point `arm` [m] from its centre, at rest at
/// `angle` [rad] from straight down: so little inertia on so long an arm couples the two rows of the pin. Body 0
/// is the ground, body 1 the box.
inline Scene<PlaneBody> box_on_an_arm(double side, double arm, double angle) {
  require_positive("arm", arm, "m");
  using M = PlaneBody;
  Scene<M> scene;
  const int ground = scene.add_body(Linear<M>(0, 0), fixed<M>());
  const int held = scene.add_body(Linear<M>(arm * from_straight_down<M>(angle)), box<M>(1, Linear<M>(side, side)));
  scene.add(pin<M>(scene.bodies(), ground, held, Linear<M>(0, 0)));
  return scene;
}

}  // namespace byhand
