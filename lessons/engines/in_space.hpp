#pragma once

#include "lessons/engines/adapters.hpp"

// For engines that know space alone: scenes in the plane lie at z = 0, their boxes are 1 m deep.
namespace byhand::engines {

inline Eigen::Vector3d in_space(const Linear<PlaneBody>& v) { return {v.x(), v.y(), 0}; }
inline const Eigen::Vector3d& in_space(const Eigen::Vector3d& v) { return v; }

inline Eigen::Vector3d sides_in_space(const Box<PlaneBody>& box) { return {box.sides.x(), box.sides.y(), 1}; }
inline Eigen::Vector3d sides_in_space(const Box<SpaceBody>& box) { return box.sides; }

/// Principal moments [kg m²]; in the plane those about the other axes do not matter.
inline Eigen::Vector3d inertia_in_space(const InverseMass<PlaneBody>& mass) {
  return Eigen::Vector3d::Constant(1 / mass.angular[0]);
}
inline Eigen::Vector3d inertia_in_space(const InverseMass<SpaceBody>& mass) { return mass.angular.cwiseInverse(); }

template <class M>
Eigen::Quaterniond rotation_in_space(const Pose<M>& pose) {
  if constexpr (M::linear == 2)
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle_of(pose.rotation), Eigen::Vector3d::UnitZ()));
  else
    return pose.rotation;
}
template <class M>
Eigen::Vector3d velocity_in_space(const Velocity<M>& V) {
  return in_space(Linear<M>(V.template head<M::linear>()));
}
template <class M>
Eigen::Vector3d spin_in_space(const Velocity<M>& V) {
  if constexpr (M::linear == 2)
    return {0, 0, V[2]};
  else
    return V.template tail<3>();
}

/// Writes what an engine has come to into body i.
template <class M>
void put(Bodies<M>& bodies, int i, const Eigen::Vector3d& position, const Eigen::Quaterniond& q,
         const Eigen::Vector3d& v, const Eigen::Vector3d& spin) {
  bodies.pose[i].position = position.head<M::linear>();
  if constexpr (M::linear == 2) {
    bodies.pose[i].rotation = rotation_of(2 * std::atan2(q.z(), q.w()));
    bodies.velocity[i] << v.x(), v.y(), spin.z();
  } else {
    bodies.pose[i].rotation = q.normalized();
    bodies.velocity[i] << v, spin;
  }
}

}  // namespace byhand::engines
