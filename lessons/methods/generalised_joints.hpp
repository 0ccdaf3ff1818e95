#pragma once

#include "solver/scene.hpp"

// A scene without loops as a tree of joints. Each body that moves hangs on another by one constraint, and where it
// is follows from where that is and from the joint's own numbers:
//
//   free     nothing holds it: its pose and velocity
//   pin      its orientation and ω
//   rod      the unit vector e from the parent's end of the rod to its own, in the plane by its angle, in space as
//            three numbers; and its orientation and ω
//   hinge    the turn about the axis
//   slider   the distance s along the axis
//   weld     none
//
// So no constraint has an error that could grow: C = 0 is how the scene is written down.
namespace byhand {

enum class JointKind { free, pin, rod, hinge, slider, weld };

template <class M>
struct Joint {
  JointKind kind = JointKind::free;
  int body = 0, parent = 0;                                           // a free body is its own parent
  int place = -1;                                                     // of the constraint in natural order
  bool reversed = false;                                              // whether the body is the constraint's first
  Linear<M> parent_arm = Linear<M>::Zero(), arm = Linear<M>::Zero();  // to the joint, in the frames of both [m]
  Linear<M> axis = Linear<M>::Zero();                                 // unit vector in the parent's frame
  // The body's orientation in the parent's axes: of a hinge, when the step began.
  [[no_unique_address]] Rotation<M> rest = Pose<M>().rotation;
  double length = 0;  // of the rod [m]
};

/// A joint's numbers and their rates, as a pose and a velocity of which each kind uses its part: e or s·axis as
/// the position; the orientation, or the hinge's turn in the parent's axes, as the rotation. The rate of a rod's
/// angle in the plane is the first number of its velocity.
template <class M>
struct JointState {
  Pose<M> at;
  Velocity<M> rate = Velocity<M>::Zero();
};

/// What turns with the bodies, in the world: the arms r₁ and r₂ of parent and body to the joint [m] and its axis.
template <class M>
struct JointFrame {
  Linear<M> r1, r2, axis;
};

/// ė of a rod [1/s].
template <class M>
Linear<M> turning_of_rod(const JointState<M>& state) {
  const Linear<M>& e = state.at.position;
  if constexpr (M::linear == 2) return state.rate[0] * Linear<M>(-e.y(), e.x());
  return state.rate.template head<M::linear>();
}

/// ω × r.
template <class M>
Linear<M> turned(const Angular<M>& rate, const Linear<M>& r) {
  if constexpr (M::angular == 0) return Linear<M>::Zero();
  if constexpr (M::angular == 1) return {-rate[0] * r.y(), rate[0] * r.x()};
  if constexpr (M::angular == 3) return rate.cross(r);
}

/// Why the scene is no such tree, in one sentence; empty if it is.
template <class M>
std::string refusal_unless_tree(const Scene<M>& scene);

/// The joints of a tree, parents first.
template <class M>
std::vector<Joint<M>> joints_of(const Scene<M>& scene);

/// Reads arms, axis, length and rest of a joint from its constraint and the bodies' poses.
template <class M>
void read_joint(const Scene<M>& scene, Joint<M>& joint);

/// What the bodies' poses and velocities say of a joint; what it does not allow is left out.
template <class M>
JointState<M> state_of(const Joint<M>& joint, const Bodies<M>& bodies);

/// Moves a joint's numbers by their rates for `time` [s].
template <class M>
void move_joint(const Joint<M>& joint, double time, JointState<M>& state);

/// Writes pose and velocity of a joint's body, once its parent has them.
template <class M>
JointFrame<M> place_body(const Joint<M>& joint, const JointState<M>& state, Bodies<M>& bodies);

}  // namespace byhand
