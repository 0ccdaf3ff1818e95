#pragma once

#include <unsupported/Eigen/AutoDiff>

#include "solver/jacobian.hpp"

// A constraint's derivatives from its `value` alone, by dual numbers: what a J derived by hand is held against.
namespace byhand {

template <int n>
using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, n, 1>>;

/// dC/dt at the present moment of bodies that move with constant V.
template <class Kind, class M>
Rows<Kind::rows> rate_by_duals(const Kind& constraint, const Pose<M>& pose1, const Velocity<M>& V1,
                               const Pose<M>& pose2, const Velocity<M>& V2) {
  using D = Dual<1>;
  const D time(0.0, 1, 0);
  const auto at = [&](const Pose<M>& pose, const Velocity<M>& V) {
    return moved<M, D>(cast<D, M>(pose), Velocity<M, D>(V.template cast<D>()), time);
  };
  const Rows<Kind::rows, D> C = constraint.template value<D>(at(pose1, V1), at(pose2, V2));
  Rows<Kind::rows> rate;
  for (int k = 0; k < Kind::rows; ++k) rate[k] = C[k].derivatives()[0];
  return rate;
}

/// dC by each of the 2 dof small moves and turns of the two bodies, in the order of (6).
template <class Kind, class M>
Eigen::Matrix<double, Kind::rows, 2 * M::dof> gradient_by_duals(const Kind& constraint, const Pose<M>& pose1,
                                                                const Pose<M>& pose2) {
  using D = Dual<2 * M::dof>;
  const auto nudged = [&](const Pose<M>& pose, int first) {
    Velocity<M, D> nudge;
    for (int i = 0; i < M::dof; ++i) nudge[i] = D(0.0, 2 * M::dof, first + i);
    return moved<M, D>(cast<D, M>(pose), nudge, D(1.0));
  };
  const Rows<Kind::rows, D> C = constraint.template value<D>(nudged(pose1, 0), nudged(pose2, M::dof));
  Eigen::Matrix<double, Kind::rows, 2 * M::dof> gradient;
  for (int k = 0; k < Kind::rows; ++k) gradient.row(k) = C[k].derivatives().transpose();
  return gradient;
}

}  // namespace byhand
