#pragma once

#include "solver/constraints/normalised_distance.hpp"
#include "solver/scene.hpp"

namespace byhand {

/// A particle of `mass` [kg] that goes round the origin at `speed` [m/s] on a rod of `radius` [m], without
/// gravity, anticlockwise in the plane z = 0. Body 0 is the anchor, body 1 the particle; `Rod` is Distance or
/// NormalisedDistance.
template <class M, template <class> class Rod = NormalisedDistance>
Scene<M> particle_on_a_circle(double radius, double speed, double mass) {
  require_positive("radius", radius, "m");
  Scene<M> scene;
  scene.gravity.setZero();
  const int anchor = scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>());
  const int particle =
      scene.add_body(Linear<M>(radius * Linear<M>::Unit(0)), with_mass<M>(mass), speed * Velocity<M>::Unit(1));
  scene.add(Rod<M>{{anchor, particle}, radius});
  return scene;
}

}  // namespace byhand
