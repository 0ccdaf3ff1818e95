#pragma once

#include "solver/constraints/face_contact.hpp"
#include "solver/scene.hpp"

namespace byhand {

using Boxes = Scene<PlaneBody, FaceContact>;

/// The ground, level at height zero, as body 0.
inline int add_ground(Boxes& scene, const Surface& surface = {}) {
  const int ground = scene.add_body(Linear<PlaneBody>(0, 0), fixed<PlaneBody>());
  scene.set_shape(ground, HalfSpace<PlaneBody>{}, surface);
  return ground;
}

/// A box with full side lengths `sides` [m] at a pose.
inline int add_box(Boxes& scene, const Pose<PlaneBody>& pose, double mass, const Linear<PlaneBody>& sides,
                   const Surface& surface = {}) {
  const int body = scene.add_body(pose, box<PlaneBody>(mass, sides));
  scene.set_shape(body, Box<PlaneBody>{0.5 * sides}, surface);
  return body;
}

/// Unit boxes of 1 kg one upon the other on the ground, the topmost of `top_mass` [kg]. Body 0 is the ground, body
/// i the i-th box from it.
inline Boxes stack(int count, double top_mass = 1, const Surface& surface = {}) {
  require(count >= 1, "number of boxes", count, "at least 1");
  Boxes scene;
  add_ground(scene, surface);
  for (int i = 1; i <= count; ++i) {
    Pose<PlaneBody> pose;
    pose.position = {0, i - 0.5};
    add_box(scene, pose, i == count ? top_mass : 1, {1, 1}, surface);
  }
  return scene;
}

/// A wall of unit boxes of 1 kg that narrows by half a box on either side from one row to the next: `base` boxes
/// below, one on top, a tenth of a box apart.
inline Boxes pyramid(int base, const Surface& surface = {}) {
  require(base >= 1, "number of boxes in the lowest row", base, "at least 1");
  Boxes scene;
  add_ground(scene, surface);
  for (int row = 0; row < base; ++row)
    for (int i = 0; i < base - row; ++i) {
      Pose<PlaneBody> pose;
      pose.position = {1.1 * (i - 0.5 * (base - row - 1)), row + 0.5};
      add_box(scene, pose, 1, {1, 1}, surface);
    }
  return scene;
}

}  // namespace byhand
