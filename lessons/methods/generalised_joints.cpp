#include "lessons/methods/generalised_joints.hpp"

#include "solver/constraints/distance.hpp"
#include "solver/constraints/hinge.hpp"
#include "solver/constraints/normalised_distance.hpp"
#include "solver/constraints/pin.hpp"
#include "solver/constraints/slider.hpp"
#include "solver/constraints/weld.hpp"
#include "solver/direct/graph.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {
namespace {

/// Calls f(kind, constraint) for a constraint that is a joint. Returns whether it is.
template <class M, class F>
bool with_joint(const Scene<M>& scene, int place, F&& f) {
  const auto tried = [&](JointKind kind, const auto* constraint) {
    if (constraint) f(kind, *constraint);
    return constraint != nullptr;
  };
  if (tried(JointKind::pin, scene.template get_if<Pin<M>>(place))) return true;
  if constexpr (M::angular == 3)
    if (tried(JointKind::hinge, scene.template get_if<Hinge<M>>(place))) return true;
  if (tried(JointKind::rod, scene.template get_if<NormalisedDistance<M>>(place)) ||
      tried(JointKind::rod, scene.template get_if<Distance<M>>(place)))
    return true;
  if constexpr (M::angular > 0)
    return tried(JointKind::slider, scene.template get_if<Slider<M>>(place)) ||
           tried(JointKind::weld, scene.template get_if<Weld<M>>(place));
  return false;
}

/// The direction to which these, as columns, are at right angles: the inverse of `tangents_of`.
template <class M>
Linear<M> across_all(const Packed<double, M::linear, M::linear - 1>& columns) {
  if constexpr (M::linear == 2)
    return {-columns(1, 0), columns(0, 0)};
  else
    return columns.col(0).cross(columns.col(1));
}

template <class M>
Linear<M> lever(const Pose<M>& pose, const Linear<M>& arm) {
  if constexpr (M::angular == 0)
    return arm;  // which is zero
  else
    return rotate(pose.rotation, arm);
}

template <class M>
Angular<M> spin(const Velocity<M>& velocity) {
  return velocity.template tail<M::angular>();
}

/// The shortest rotation that takes one unit vector to another near it.
Quaternion<double> between_directions(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d about = from.cross(to);
  return Quaternion<double>(1 + from.dot(to), about.x(), about.y(), about.z()).normalized();
}

}  // namespace

template <class M>
std::string refusal_unless_tree(const Scene<M>& scene) {
  for (int place = 0; place < scene.count(); ++place)
    if (!with_joint(scene, place, [](JointKind, const auto&) {}))
      return "generalised coordinates know pins, hinges, sliders, welds and rods, and constraint " +
             std::to_string(scene.entries()[place].id) + " is none of them";
  if (!has_no_loops(scene.graph()))
    return "generalised coordinates follow a tree of joints, and constraints of this scene close a loop";
  return {};
}

template <class M>
std::vector<Joint<M>> joints_of(const Scene<M>& scene) {
  const Bodies<M>& bodies = scene.bodies();
  std::vector<std::vector<int>> places(static_cast<std::size_t>(bodies.size()));  // of each body's constraints
  for (int place = 0; place < scene.count(); ++place)
    for (const int body : {scene.entries()[place].body1, scene.entries()[place].body2})
      places[body].push_back(place);
  std::vector<char> reached(places.size(), 0);
  std::vector<Joint<M>> joints;
  std::vector<int> next;
  const auto reach = [&](const Joint<M>& joint) {
    reached[joint.body] = 1;
    next.push_back(joint.body);
    joints.push_back(joint);
  };
  const auto follow = [&] {
    for (std::size_t i = 0; i < next.size(); ++i)
      for (const int place : places[next[i]]) {
        const auto& entry = scene.entries()[place];
        const bool reversed = entry.body1 != next[i];
        const int body = reversed ? entry.body1 : entry.body2;
        if (reached[body]) continue;
        Joint<M> joint{.body = body, .parent = next[i], .place = place, .reversed = reversed};
        with_joint(scene, place, [&](JointKind kind, const auto&) { joint.kind = kind; });
        reach(joint);
      }
    next.clear();
  };
  for (int body = 0; body < bodies.size(); ++body)
    if (!moves(bodies.inverse_mass[body])) reached[body] = 1, next.push_back(body);
  follow();
  for (int body = 0; body < bodies.size(); ++body)
    if (!reached[body]) reach({.body = body, .parent = body}), follow();
  return joints;
}

template <class M>
void read_joint(const Scene<M>& scene, Joint<M>& joint) {
  if (joint.kind == JointKind::free) return;
  with_joint(scene, joint.place, [&]<class Kind>(JointKind, const Kind& constraint) {
    if constexpr (M::angular > 0) {
      joint.parent_arm = constraint.at.arms.first, joint.arm = constraint.at.arms.second;
      if (joint.reversed) std::swap(joint.parent_arm, joint.arm);
    }
    if constexpr (requires { constraint.length; }) joint.length = constraint.length;
    if constexpr (requires { constraint.right; })
      joint.rest = joint.reversed ? constraint.right.rest : inverse(constraint.right.rest);
    if constexpr (M::angular > 0)
      if constexpr (std::is_same_v<Kind, Slider<M>>) {
        joint.axis = across_all<M>(constraint.across);
        if (joint.reversed) joint.axis = -rotate(joint.rest, joint.axis);
      }
    if constexpr (M::angular == 3)
      if constexpr (requires { constraint.axis; }) {
        const Linear<M> axis1 = across_all<M>(constraint.across), &axis2 = constraint.axis;
        const Bodies<M>& bodies = scene.bodies();
        joint.axis = joint.reversed ? axis2 : axis1;
        joint.rest = inverse(bodies.pose[joint.parent].rotation) * bodies.pose[joint.body].rotation;
        const Linear<M> now = rotate(joint.rest, joint.reversed ? axis1 : axis2);
        joint.rest = Rotation<M>(between_directions(now, joint.axis) * joint.rest).normalized();
      }
  });
}

template <class M>
JointState<M> state_of(const Joint<M>& joint, const Bodies<M>& bodies) {
  const Pose<M>&parent = bodies.pose[joint.parent], &pose = bodies.pose[joint.body];
  const Velocity<M>&parent_velocity = bodies.velocity[joint.parent], &velocity = bodies.velocity[joint.body];
  if (joint.kind == JointKind::free) return {pose, velocity};
  JointState<M> state;
  const Linear<M> r1 = lever(parent, joint.parent_arm), r2 = lever(pose, joint.arm),
                  d = pose.position + r2 - parent.position - r1,
                  rate = velocity.template head<M::linear>() + turned<M>(spin<M>(velocity), r2) -
                         parent_velocity.template head<M::linear>();  // of its end against the parent's centre
  if (joint.kind == JointKind::pin || joint.kind == JointKind::rod) {
    state.at.rotation = pose.rotation;
    state.rate.template tail<M::angular>() = spin<M>(velocity);
  }
  if (joint.kind == JointKind::rod) {
    const Linear<M> e = d.normalized(), turn = (rate - turned<M>(spin<M>(parent_velocity), r1)) / joint.length;
    state.at.position = e;
    if constexpr (M::linear == 2)
      state.rate[0] = e.x() * turn.y() - e.y() * turn.x();
    else
      state.rate.template head<3>() = turn - e * e.dot(turn);
  }
  if constexpr (M::angular > 0) {
    const Linear<M> axis = rotate(parent.rotation, joint.axis);
    if (joint.kind == JointKind::slider) {
      state.at.position = joint.axis * axis.dot(d);
      state.rate.template head<M::linear>() =
          joint.axis * axis.dot(rate - turned<M>(spin<M>(parent_velocity), Linear<M>(r1 + d)));
    }
    if constexpr (M::angular == 3)
      if (joint.kind == JointKind::hinge)
        state.rate.template tail<3>() = joint.axis * axis.dot(spin<M>(velocity) - spin<M>(parent_velocity));
  }
  return state;
}

template <class M>
void move_joint(const Joint<M>& joint, double time, JointState<M>& state) {
  const Linear<M> e = state.at.position, rate = turning_of_rod<M>(state);
  state.at = moved<M, double>(state.at, state.rate, time);
  if (joint.kind != JointKind::rod) return;
  state.at.position = e;
  const double size = rate.norm();
  if (size == 0) return;
  const SinCos<double> turn = sin_cos(size * time);
  state.at.position = (turn.cos * e + turn.sin / size * rate).normalized();
  if constexpr (M::linear == 3) state.rate.template head<3>() = turn.cos * rate - turn.sin * size * e;
}

template <class M>
JointFrame<M> place_body(const Joint<M>& joint, const JointState<M>& state, Bodies<M>& bodies) {
  Pose<M>& pose = bodies.pose[joint.body];
  Velocity<M>& velocity = bodies.velocity[joint.body];
  if (joint.kind == JointKind::free) {
    pose = state.at, velocity = state.rate;
    return {Linear<M>::Zero(), Linear<M>::Zero(), Linear<M>::Zero()};
  }
  const Pose<M>& parent = bodies.pose[joint.parent];
  const Velocity<M>& parent_velocity = bodies.velocity[joint.parent];
  const Angular<M> parent_spin = spin<M>(parent_velocity);
  Angular<M> own = spin<M>(state.rate);
  pose.rotation = state.at.rotation;
  JointFrame<M> frame{lever(parent, joint.parent_arm), Linear<M>::Zero(), Linear<M>::Zero()};
  if constexpr (M::angular > 0)
    if (joint.kind != JointKind::pin && joint.kind != JointKind::rod) {
      frame.axis = rotate(parent.rotation, joint.axis);
      pose.rotation = parent.rotation * state.at.rotation * joint.rest;
      if constexpr (M::angular == 3) own = rotate(parent.rotation, own);
      own += parent_spin;
    }
  frame.r2 = lever(pose, joint.arm);
  const Linear<M> place = state.at.position, rate = state.rate.template head<M::linear>();
  Linear<M> apart = Linear<M>::Zero(), parting = Linear<M>::Zero();  // of the two ends
  if (joint.kind == JointKind::rod)
    apart = joint.length * place, parting = joint.length * turning_of_rod<M>(state);
  if constexpr (M::angular > 0)
    if (joint.kind == JointKind::slider) {
      apart = rotate(parent.rotation, place);
      parting = rotate(parent.rotation, rate) + turned<M>(parent_spin, apart);
    }
  pose.position = parent.position + frame.r1 + apart - frame.r2;
  velocity.template tail<M::angular>() = own;
  velocity.template head<M::linear>() = parent_velocity.template head<M::linear>() +
                                        turned<M>(parent_spin, frame.r1) + parting - turned<M>(own, frame.r2);
  return frame;
}

#define BYHAND_INSTANTIATE(M)                                         \
  template std::string refusal_unless_tree(const Scene<M>&);          \
  template std::vector<Joint<M>> joints_of(const Scene<M>&);          \
  template void read_joint(const Scene<M>&, Joint<M>&);               \
  template JointState<M> state_of(const Joint<M>&, const Bodies<M>&); \
  template void move_joint(const Joint<M>&, double, JointState<M>&);  \
  template JointFrame<M> place_body(const Joint<M>&, const JointState<M>&, Bodies<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
