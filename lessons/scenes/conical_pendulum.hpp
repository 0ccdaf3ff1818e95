#pragma once

#include "lessons/exact/conical_pendulum.hpp"
#include "lessons/scenes/pendulum.hpp"
#include "solver/constraints/normalised_distance.hpp"

namespace byhand {

/// A bob of `mass` [kg] on a rod of `length` [m] that circles the vertical through the origin at `angle` [rad]
/// from straight down, at the speed that keeps it there. Body 0 is the anchor, body 1 the bob, which goes towards
/// +z.
template <template <class> class Rod = NormalisedDistance>
Scene<SpaceParticle> conical_pendulum(double angle, double length, double mass) {
  Scene<SpaceParticle> scene = pendulum<SpaceParticle, Rod>(angle, length, mass);
  const ConicalPendulum exact(angle, length, -scene.gravity.y());
  scene.set_velocity(1, {0, 0, exact.angular_velocity() * exact.radius()});
  return scene;
}

}  // namespace byhand
