#pragma once

#include "solver/contact/contact_manager.hpp"

namespace byhand {

/// Two bodies that press on each other, after a step.
template <class M>
struct Touch {
  struct Point {
    Linear<M> at;           // half-way between the two surfaces, in the world [m]
    double separation;      // [m], negative where they overlap
    double normal_impulse;  // >= 0 [N s]
  };

  int body1 = 0, body2 = 0;
  Linear<M> normal;    // unit vector from the first body to the second, in the world
  Linear<M> impulse;   // normal and friction, on the second body in the last substep [N s]
  bool began = false;  // whether they did not press in the step before
  std::vector<Point> points = {};
};

/// The pairs that pressed on each other in the last substep of the last step, in ascending order of bodies. A
/// bounce is over within its step and is not listed.
template <class M>
std::vector<Touch<M>> touches(const Scene<M>& scene, const ContactManager<M>& contacts) requires(M::angular > 0);

/// The pairs that pressed in the step before and do so no longer.
template <class M>
std::vector<BodyPair> parted(const ContactManager<M>& contacts) requires(M::angular > 0);

}  // namespace byhand
