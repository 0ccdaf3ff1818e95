#pragma once

#include <unsupported/Eigen/AutoDiff>

#include "solver/jacobian.hpp"

// A constraint's derivatives from its `value` alone, by dual numbers: what a J derived by hand is held against.
namespace byhand {

/// dC/dt at the present moment of bodies that move with constant V.
template <class Kind, class M>
Rows<Kind::rows> rate_by_duals(const Kind& constraint, const Pose<M>& pose1, const Velocity<M>& V1,
                               const Pose<M>& pose2, const Velocity<M>& V2) {
  using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 1, 1>>;
  const Dual time(0.0, 1, 0);
  const auto at = [&](const Pose<M>& pose, const Velocity<M>& V) {
    return moved<M, Dual>(cast<Dual, M>(pose), Velocity<M, Dual>(V.template cast<Dual>()), time);
  };
  const Rows<Kind::rows, Dual> C = constraint.template value<Dual>(at(pose1, V1), at(pose2, V2));
  Rows<Kind::rows> rate;
  for (int k = 0; k < Kind::rows; ++k) rate[k] = C[k].derivatives()[0];
  return rate;
}

/// dC by each of the 2 dof small moves and turns of the two bodies, in the order of (6).
template <class Kind, class M>
Eigen::Matrix<double, Kind::rows, 2 * M::dof> gradient_by_duals(const Kind& constraint, const Pose<M>& pose1,
                                                                const Pose<M>& pose2) {
  Eigen::Matrix<double, Kind::rows, 2 * M::dof> gradient;
  for (int i = 0; i < 2 * M::dof; ++i) {
    Velocity<M> V1 = Velocity<M>::Zero(), V2 = V1;
    (i < M::dof ? V1[i] : V2[i - M::dof]) = 1;
    gradient.col(i) = rate_by_duals(constraint, pose1, V1, pose2, V2);
  }
  return gradient;
}

}  // namespace byhand
