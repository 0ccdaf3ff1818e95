#pragma once

#include <array>

#include "solver/constraints/limit.hpp"
#include "solver/constraints/pin.hpp"
#include "solver/contact/shape.hpp"
#include "solver/scene.hpp"

namespace byhand {

/// The parts of a ragdoll, as offsets from its first body.
namespace ragdoll {
enum Part {
  torso,
  head,
  left_upper_arm,
  left_forearm,
  right_upper_arm,
  right_forearm,
  left_thigh,
  left_shin,
  right_thigh,
  right_shin
};
inline constexpr int parts = 10;
}  // namespace ragdoll

/// Adds a ragdoll of 1.75 m and 70 kg, seen from the front with its arms held out, the middle of its hips at a
/// point [m]: ten boxes, nine pins, and two limits for each. If it `collides`, the boxes touch what they are not
/// joined to. Returns the index of its torso.
inline int add_ragdoll(Scene<PlaneBody>& scene, const Linear<PlaneBody>& hips, bool collides = true) {
  using M = PlaneBody;
  using namespace ragdoll;
  struct Limb {
    Part part, from;                 // what it is and what it hangs on
    Linear<M> middle, sides, joint;  // from the middle of the hips [m]
    double mass;                     // [kg]
    double least, most;              // angle against what it hangs on [rad]
  };
  const Linear<M> none(0, 0), along(0.30, 0.09), upright(0.13, 0.42);
  const Limb limbs[] = {
      {torso, torso, {0, 0.29}, {0.34, 0.56}, none, 35, 0, 0},
      {head, torso, {0, 0.73}, {0.18, 0.24}, {0, 0.60}, 5, -0.6, 0.6},
      {left_upper_arm, torso, {-0.33, 0.51}, along, {-0.18, 0.51}, 2.5, -1.2, 1.4},
      {left_forearm, left_upper_arm, {-0.64, 0.51}, along, {-0.485, 0.51}, 1.5, -0.1, 2.4},
      {right_upper_arm, torso, {0.33, 0.51}, along, {0.18, 0.51}, 2.5, -1.4, 1.2},
      {right_forearm, right_upper_arm, {0.64, 0.51}, along, {0.485, 0.51}, 1.5, -2.4, 0.1},
      {left_thigh, torso, {-0.1, -0.22}, upright, {-0.1, 0}, 7, -1.2, 0.2},
      {left_shin, left_thigh, {-0.1, -0.66}, upright, {-0.1, -0.44}, 4, -0.1, 2.2},
      {right_thigh, torso, {0.1, -0.22}, upright, {0.1, 0}, 7, -0.2, 1.2},
      {right_shin, right_thigh, {0.1, -0.66}, upright, {0.1, -0.44}, 4, -2.2, 0.1},
  };
  const int first = scene.bodies().size();
  for (const Limb& limb : limbs) {
    const int body = scene.add_body(Linear<M>(hips + limb.middle), box<M>(limb.mass, limb.sides));
    if (collides) scene.set_shape(body, Box<M>{limb.sides}, {0.5});
    if (limb.part == torso) continue;
    scene.add(pin<M>(scene.bodies(), first + limb.from, body, Linear<M>(hips + limb.joint)));
    const Turn<M> bend = turn<M>(scene.bodies(), first + limb.from, body);
    scene.add(at_least<M>(limb.least, bend));
    scene.add(at_most<M>(limb.most, bend));
  }
  return first;
}

}  // namespace byhand
