#pragma once

#include "lessons/scenes/pendulum.hpp"

namespace byhand {

/// The pendulum of SphericalPendulum: a bob of `mass` [kg] on a rod of `length` [m] at `angle` [rad] from straight
/// down, that goes round the vertical at `azimuth_rate` [rad/s] at first. Body 0 is the anchor, body 1 the bob, a
/// particle or a ball that the rod holds by its centre.
template <class M, template <class> class Rod = NormalisedDistance>
Scene<M> spherical_pendulum(double angle, double azimuth_rate, double length, double mass) {
  static_assert(M::linear == 3, "in the plane there is no vertical to go round");
  Scene<M> scene = pendulum<M, Rod>(angle, length, mass);
  Velocity<M> round = Velocity<M>::Zero();
  round.z() = -azimuth_rate * scene.bodies().pose[1].position.x();
  scene.set_velocity(1, round);
  return scene;
}

}  // namespace byhand
