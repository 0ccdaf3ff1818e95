#pragma once

#include <cmath>

#include "solver/jacobian.hpp"
#include "tests/solver/dense.hpp"

// A constraint's derivatives from its `value` alone, by dual numbers: what a J derived by hand is held against.
namespace byhand {

/// A number and its rate. Eigen's own cost a dozen types for every sum that they are in.
struct Dual {
  double at = 0, rate = 0;

  Dual() = default;
  Dual(double constant) : at(constant) {}
  Dual(double value, double derivative) : at(value), rate(derivative) {}

  double value() const { return at; }

  friend Dual operator-(const Dual& a) { return {-a.at, -a.rate}; }
  friend Dual operator+(const Dual& a, const Dual& b) { return {a.at + b.at, a.rate + b.rate}; }
  friend Dual operator-(const Dual& a, const Dual& b) { return {a.at - b.at, a.rate - b.rate}; }
  friend Dual operator*(const Dual& a, const Dual& b) { return {a.at * b.at, a.rate * b.at + a.at * b.rate}; }
  friend Dual operator/(const Dual& a, const Dual& b) {
    return {a.at / b.at, (a.rate * b.at - a.at * b.rate) / (b.at * b.at)};
  }
  friend Dual sqrt(const Dual& a) { return {std::sqrt(a.at), a.rate / (2 * std::sqrt(a.at))}; }
  Dual& operator+=(const Dual& b) { return *this = *this + b; }
  Dual& operator-=(const Dual& b) { return *this = *this - b; }
  Dual& operator*=(const Dual& b) { return *this = *this * b; }
  Dual& operator/=(const Dual& b) { return *this = *this / b; }
};

/// The pose at the present moment of a body that moves with constant V.
template <class M>
Pose<M, Dual> moving(const Pose<M>& pose, const Velocity<M>& V);

/// dC/dt at the present moment of bodies that move with constant V.
template <class Kind, class M>
Rows<Kind::rows> rate_by_duals(const Kind& constraint, const Pose<M>& pose1, const Velocity<M>& V1,
                               const Pose<M>& pose2, const Velocity<M>& V2) {
  const Rows<Kind::rows, Dual> C = constraint.template value<Dual>(moving<M>(pose1, V1), moving<M>(pose2, V2));
  Rows<Kind::rows> rate;
  for (int k = 0; k < Kind::rows; ++k) rate[k] = C[k].rate;
  return rate;
}

/// dC by each of the 2 dof small moves and turns of the two bodies, in the order of (6).
template <class Kind, class M>
Dense gradient_by_duals(const Kind& constraint, const Pose<M>& pose1, const Pose<M>& pose2) {
  Dense gradient(Kind::rows, 2 * M::dof);
  for (int i = 0; i < 2 * M::dof; ++i) {
    Velocity<M> V1 = Velocity<M>::Zero(), V2 = V1;
    (i < M::dof ? V1[i] : V2[i - M::dof]) = 1;
    gradient.set_block(0, i, rate_by_duals(constraint, pose1, V1, pose2, V2));
  }
  return gradient;
}

}  // namespace byhand

template <>
struct Eigen::NumTraits<byhand::Dual> : Eigen::NumTraits<double> {
  using Real = byhand::Dual;
  using NonInteger = byhand::Dual;
  using Nested = byhand::Dual;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 2,
    AddCost = 2,
    MulCost = 4
  };
};
