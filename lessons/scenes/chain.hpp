#pragma once

#include "lessons/scenes/pendulum.hpp"
#include "solver/constraints/distance.hpp"
#include "solver/constraints/pin.hpp"
#include "solver/scene.hpp"

namespace byhand {

/// A chain of equal links between an anchor at the origin and a free end: what it is made of and how it begins.
struct ChainOptions {
  int links = 10;       // >= 1
  double length = 1;    // of one link [m]
  double mass = 1;      // of one link or bob [kg]
  double end_mass = 1;  // of the last one [kg]
  double angle = 0;     // from straight down [rad]; π/2 is level
};

inline void require_valid(const ChainOptions& chain) {
  require(chain.links >= 1, "number of links", chain.links, "at least 1");
  require_positive("length of a link", chain.length, "m");
  require_positive("mass", chain.mass, "kg");
  require_positive("end mass", chain.end_mass, "kg");
}

/// Bobs on massless rods. Body 0 is the anchor, body i the i-th bob from it; constraint i - 1 holds bob i.
template <class M, template <class> class Rod = Distance>
Scene<M> rod_chain(const ChainOptions& chain) {
  require_valid(chain);
  Scene<M> scene;
  const Linear<M> along = from_straight_down<M>(chain.angle);
  scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>());
  for (int i = 1; i <= chain.links; ++i) {
    const double mass = i == chain.links ? chain.end_mass : chain.mass;
    InverseMass<M> bob;
    if constexpr (M::angular == 0)
      bob = with_mass<M>(mass);
    else
      bob = ball<M>(mass, chain.length / 4);
    scene.add_body(Linear<M>(i * chain.length * along), bob);
    scene.add(Rod<M>{{i - 1, i}, chain.length});
  }
  return scene;
}

/// Stiff links pinned end to end: boxes a tenth as thick as they are long. Body 0 is the anchor, body i the i-th
/// link from it; pin i - 1 holds link i by its upper end.
template <class M>
Scene<M> pinned_chain(const ChainOptions& chain) {
  require_valid(chain);
  Scene<M> scene;
  const Linear<M> along = from_straight_down<M>(chain.angle);
  Linear<M> sides = Linear<M>::Constant(chain.length / 10);
  sides[1] = chain.length;
  scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>());
  for (int i = 1; i <= chain.links; ++i) {
    Pose<M> pose;
    pose.position = (i - 0.5) * chain.length * along;
    if constexpr (M::angular == 1)
      pose.rotation = plane_rotation(chain.angle);
    else
      pose.rotation = space_rotation(Angular<M>(0, 0, chain.angle));
    scene.add_body(pose, box<M>(i == chain.links ? chain.end_mass : chain.mass, sides));
    scene.add(pin<M>(scene.bodies(), i - 1, i, Linear<M>((i - 1) * chain.length * along)));
  }
  return scene;
}

}  // namespace byhand
