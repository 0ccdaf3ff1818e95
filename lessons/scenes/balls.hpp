#pragma once

#include "lessons/scenes/boxes.hpp"

namespace byhand {

/// A ball of 1 kg with its lowest point `height` [m] above the ground, at rest, and all its surfaces of one
/// restitution e. Body 0 is the ground, body 1 the ball.
template <class M>
Scene<M> bouncing_ball(double height, double restitution, double radius = 0.5) {
  Scene<M> scene;
  scene.set_contact_rows(ContactRows::points);
  const Surface surface{0, restitution};
  add_ground(scene, surface);
  const Linear<M> centre = (height + radius) * Linear<M>::Unit(1);
  scene.set_shape(scene.add_body(centre, ball<M>(1, radius)), Ball<M>{radius}, surface);
  return scene;
}

/// Newton's cradle without its strings: `count` balls of 1 kg and 1 m across that just touch, in a row along +x
/// and without gravity. The first comes at `speed` [m/s], the others rest. Body i is ball i + 1.
template <class M>
Scene<M> newtons_cradle(int count, double restitution = 1, double speed = 1) {
  require(count >= 2, "number of balls", count, "at least 2");
  Scene<M> scene;
  scene.set_contact_rows(ContactRows::points);
  scene.gravity.setZero();
  for (int i = 0; i < count; ++i) {
    const int body = scene.add_body(Linear<M>(i * Linear<M>::Unit(0)), ball<M>(1, 0.5));
    scene.set_shape(body, Ball<M>{0.5}, {0, restitution});
  }
  scene.set_velocity(0, speed * Velocity<M>::UnitX());
  return scene;
}

}  // namespace byhand
