#pragma once

#include "solver/constraints/distance.hpp"
#include "solver/constraints/normalised_distance.hpp"
#include "solver/constraints/pin.hpp"
#include "solver/scene.hpp"

namespace byhand {

/// The direction that makes an angle [rad] with straight down, towards +x; in space it stays in the plane z = 0.
template <class M>
Linear<M> from_straight_down(double angle) {
  const auto [sin, cos] = sin_cos(angle);
  return sin * Linear<M>::Unit(0) - cos * Linear<M>::Unit(1);
}

/// A bob of `mass` [kg] on a massless rod of `length` [m] below an anchor at the origin, at rest at `angle` [rad]
/// from straight down. Body 0 is the anchor, body 1 the bob; `Rod` is Distance or NormalisedDistance. A bob that
/// can turn is a ball of a tenth of the length, and the rod holds it by its centre.
template <class M, template <class> class Rod = Distance>
Scene<M> pendulum(double angle, double length, double mass) {
  require_positive("length", length, "m");
  Scene<M> scene;
  InverseMass<M> bob;
  if constexpr (M::angular == 0)
    bob = with_mass<M>(mass);
  else
    bob = ball<M>(mass, length / 10);
  const int anchor = scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>());
  const int body = scene.add_body(Linear<M>(length * from_straight_down<M>(angle)), bob);
  scene.add(Rod<M>{{anchor, body}, length});
  return scene;
}

/// A uniform thin rod of `mass` [kg] and `length` [m], hinged by one end at the origin, at rest at `angle` [rad]
/// from straight down: the compound pendulum. In space it is a hundredth as thick as it is long and hangs on a
/// ball joint. Body 0 is the ground, body 1 the rod.
template <class M = PlaneBody>
Scene<M> hinged_rod(double angle, double length, double mass) {
  require_positive("length", length, "m");
  require_positive("mass", mass, "kg");
  Scene<M> scene;
  const int ground = scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>());
  const double across = mass * length * length / 12;
  Pose<M> pose;
  pose.position = length / 2 * from_straight_down<M>(angle);
  Angular<M> inertia = Angular<M>::Constant(across);
  if constexpr (M::angular == 1) {
    pose.rotation = plane_rotation(angle);
  } else {
    pose.rotation = space_rotation(Angular<M>(0, 0, angle));
    inertia.y() = across / 1e4;
  }
  const int rod = scene.add_body(pose, with_mass<M>(mass, inertia));
  scene.add(pin<M>(scene.bodies(), ground, rod, Linear<M>(Linear<M>::Zero())));
  return scene;
}

}  // namespace byhand
