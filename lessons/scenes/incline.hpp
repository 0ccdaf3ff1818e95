#pragma once

#include "lessons/scenes/boxes.hpp"

namespace byhand {

/// A box of `mass` [kg] and side lengths `sides` [m] that lies flat on a slope of `angle` [rad] down towards +x
/// and sets out at `speed` [m/s] along the slope. At 0 rad the slope is level ground. Body 0 is the slope, body 1
/// the box; both have the friction `friction`.
template <class M = PlaneBody>
Scene<M> box_on_incline(double angle, double friction, double speed = 0,
                        const Linear<M>& sides = Linear<M>(Linear<M>::Ones()), double mass = 1) {
  const auto [sin, cos] = sin_cos(angle);
  const Linear<M> up = sin * Linear<M>::Unit(0) + cos * Linear<M>::Unit(1),
                  down_the_slope = cos * Linear<M>::Unit(0) - sin * Linear<M>::Unit(1);
  Pose<M> lying;
  lying.position = 0.5 * sides.y() * up;
  if constexpr (M::angular == 1)
    lying.rotation = plane_rotation(-angle);
  else
    lying.rotation = space_rotation(Angular<M>(0, 0, -angle));
  Scene<M> scene;
  add_ground(scene, {friction}, up);
  const int body = add_box(scene, lying, mass, sides, {friction});
  Velocity<M> sliding = Velocity<M>::Zero();
  sliding.template head<M::linear>() = speed * down_the_slope;
  scene.set_velocity(body, sliding);
  return scene;
}

}  // namespace byhand
