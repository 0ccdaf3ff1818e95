#pragma once

#include "solver/body.hpp"

// How far apart two states of a body are, in metres, by its points at the radius of gyration k: I = mk² with the
// largest moment I. So no length has to be chosen.
namespace byhand {

/// k [m]
template <class M>
double gyration(const InverseMass<M>& mass) {
  if constexpr (M::angular == 0)
    return 0;
  else
    return std::sqrt(mass.linear / mass.angular.minCoeff());
}

/// How far such points move between two poses, at most [m]; of a turn its chord counts. No less than what rounding
/// hides.
template <class M>
double displacement(const InverseMass<M>& mass, const Pose<M>& from, const Pose<M>& to) {
  double chord = 0;
  if constexpr (M::angular == 1)
    chord = Linear<M>(to.rotation.cos - from.rotation.cos, to.rotation.sin - from.rotation.sin).norm();
  if constexpr (M::angular == 3) chord = 2 * (inverse(from.rotation) * to.rotation).vec().norm();
  return (to.position - from.position).norm() + gyration<M>(mass) * chord + 0x1p-52 * to.position.norm();
}

/// By how much their velocities change between two, at most [m/s].
template <class M>
double difference(const InverseMass<M>& mass, const Velocity<M>& from, const Velocity<M>& to) {
  const Velocity<M> change = to - from;
  return change.template head<M::linear>().norm() + gyration<M>(mass) * change.template tail<M::angular>().norm();
}

}  // namespace byhand
