#pragma once

#include "lessons/exact/heavy_top.hpp"
#include "solver/constraints/pin.hpp"
#include "solver/scene.hpp"

namespace byhand {

/// A body with principal `moments` [kg m²] that nothing holds or pulls, and that turns at `spin` [rad/s] about its
/// own axes at first: the thrown book that flips. Body 0 is the top.
inline Scene<SpaceBody> free_top(const Eigen::Vector3d& moments, const Eigen::Vector3d& spin) {
  Scene<SpaceBody> scene;
  scene.gravity.setZero();
  Velocity<SpaceBody> V = Velocity<SpaceBody>::Zero();
  V.tail<3>() = spin;
  scene.add_body(Eigen::Vector3d(0, 0, 0), with_mass<SpaceBody>(1, moments), V);
  return scene;
}

/// A heavy symmetric top with its tip on a ball joint at the origin, leaning by `angle` [rad] from straight up
/// towards +x, that turns about its own axis and at once about the vertical at `precession` [rad/s]. With a rate
/// of top.precession(angle, …) it keeps its lean; a gyroscope is a top whose axis is level. Body 0 is the ground,
/// body 1 the top, whose own axis is its y.
inline Scene<SpaceBody> spinning_top(const HeavyTop& top, double angle, double precession) {
  using M = SpaceBody;
  Scene<M> scene;
  scene.gravity = {0, -top.gravity, 0};
  const int ground = scene.add_body(Linear<M>(0, 0, 0), fixed<M>());
  Pose<M> pose;
  pose.rotation = space_rotation(Angular<M>(0, 0, -angle));
  const Linear<M> axis = rotate(pose.rotation, Linear<M>(0, 1, 0));
  pose.position = top.arm * axis;
  const double across = top.moment_across - top.mass * top.arm * top.arm;  // about the centre of mass
  // Of the whole spin the part along the axis is given; the precession adds what it lacks across.
  const Linear<M> vertical(0, precession, 0);
  const Linear<M> turning = vertical + (top.spin - vertical.dot(axis)) * axis;
  Velocity<M> V;
  V << turning.cross(pose.position), turning;
  const int body = scene.add_body(pose, with_mass<M>(top.mass, Angular<M>(across, top.moment_along, across)), V);
  scene.add(pin<M>(scene.bodies(), ground, body, Linear<M>(0, 0, 0)));
  return scene;
}

}  // namespace byhand
