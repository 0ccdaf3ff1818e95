#pragma once

#include "solver/scene.hpp"

// Boxes on the ground.
namespace byhand {

/// The ground, through the origin, solid against `up`.
template <class M>
int add_ground(Scene<M>& scene, const Surface& surface = {}, const Linear<M>& up = Linear<M>::Unit(1)) {
  const int ground = scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>());
  scene.set_shape(ground, HalfSpace<M>{up}, surface);
  return ground;
}

/// A box with full side lengths `sides` [m] at a pose.
template <class M>
int add_box(Scene<M>& scene, const Pose<M>& pose, double mass, const Linear<M>& sides,
            const Surface& surface = {}) {
  const int body = scene.add_body(pose, box<M>(mass, sides));
  scene.set_shape(body, Box<M>{sides}, surface);
  return body;
}

/// A unit box of `mass` [kg] with its centre `x` [m] to the right and `y` [m] above the origin.
template <class M>
int add_unit_box(Scene<M>& scene, double x, double y, double mass = 1, const Surface& surface = {}) {
  Pose<M> pose;
  pose.position = x * Linear<M>::Unit(0) + y * Linear<M>::Unit(1);
  return add_box(scene, pose, mass, Linear<M>(Linear<M>::Ones()), surface);
}

/// Unit boxes of 1 kg one upon the other on the ground, the topmost of `top_mass` [kg]. Body 0 is the ground, body
/// i the i-th box from it.
template <class M = PlaneBody>
Scene<M> stack(int count, double top_mass = 1, const Surface& surface = {}) {
  require(count >= 1, "number of boxes", count, "at least 1");
  Scene<M> scene;
  add_ground(scene, surface);
  for (int i = 1; i <= count; ++i) add_unit_box(scene, 0, i - 0.5, i == count ? top_mass : 1, surface);
  return scene;
}

/// A wall of unit boxes of 1 kg that narrows by half a box on either side from one row to the next: `base` boxes
/// below, one on top, a tenth of a box apart.
template <class M = PlaneBody>
Scene<M> pyramid(int base, const Surface& surface = {}) {
  require(base >= 1, "number of boxes in the lowest row", base, "at least 1");
  Scene<M> scene;
  add_ground(scene, surface);
  for (int row = 0; row < base; ++row)
    for (int i = 0; i < base - row; ++i)
      add_unit_box(scene, 1.1 * (i - 0.5 * (base - row - 1)), row + 0.5, 1, surface);
  return scene;
}

/// Pushes all that moves sideways, in proportion to its height over the origin, the topmost with `speed` [m/s]:
/// a stack that merely looks settled does not survive it.
template <class M>
void kick(Scene<M>& scene, double speed) {
  const Bodies<M>& bodies = scene.bodies();
  double top = 0;
  for (const auto& pose : bodies.pose) top = std::max(top, pose.position.y());
  require_positive("height of the topmost body", top, "m");
  for (int i = 0; i < bodies.size(); ++i)
    if (moves(bodies.inverse_mass[i]))
      scene.set_velocity(i, bodies.velocity[i] + speed * bodies.pose[i].position.y() / top * Velocity<M>::Unit(0));
}

}  // namespace byhand
