#pragma once

#include <cmath>

#include "solver/jacobian.hpp"

namespace byhand {

/// A function of time as its value and first two derivatives. Eigen's dual numbers, nested for a second
/// derivative, store the first one twice and take twice as long to compile and to run.
struct Jet {
  double at = 0, rate = 0, bend = 0;

  Jet() = default;
  Jet(double constant) : at(constant) {}
  Jet(double value, double first, double second) : at(value), rate(first), bend(second) {}

  double value() const { return at; }

  friend Jet operator-(const Jet& a) { return {-a.at, -a.rate, -a.bend}; }
  friend Jet operator+(const Jet& a, const Jet& b) { return {a.at + b.at, a.rate + b.rate, a.bend + b.bend}; }
  friend Jet operator-(const Jet& a, const Jet& b) { return {a.at - b.at, a.rate - b.rate, a.bend - b.bend}; }
  friend Jet operator*(const Jet& a, const Jet& b) {
    return {a.at * b.at, a.rate * b.at + a.at * b.rate, a.bend * b.at + 2 * a.rate * b.rate + a.at * b.bend};
  }
  friend Jet operator/(const Jet& a, const Jet& b) {  // from a = q b, derivative by derivative
    const double q = a.at / b.at, q_rate = (a.rate - q * b.rate) / b.at;
    return {q, q_rate, (a.bend - 2 * q_rate * b.rate - q * b.bend) / b.at};
  }
};

inline Jet sqrt(const Jet& a) {  // from a = r²
  const double r = std::sqrt(a.at), r_rate = a.rate / (2 * r);
  return {r, r_rate, (a.bend - 2 * r_rate * r_rate) / (2 * r)};
}

/// q̇ = ½ω q of a body that turns at ω [rad/s] in world axes.
inline Quaternion<double> turning(const Quaternion<double>& q, const Packed<double, 3>& spin) {
  return Quaternion<double>(0, spin.x() / 2, spin.y() / 2, spin.z() / 2) * q;
}

/// The path of a body with constant V at t = 0: its rotation has the derivatives ½ω q and -¼|ω|² q, in the plane
/// ω i r and -ω² r.
template <class M>
Pose<M, Jet> on_its_way(const Pose<M>& pose, const Velocity<M>& V) {
  Pose<M, Jet> path;
  for (int i = 0; i < M::linear; ++i) path.position[i] = {pose.position[i], V[i], 0};
  if constexpr (M::angular == 1) {
    const auto [cos, sin] = pose.rotation;
    const double spin = V[M::linear];
    path.rotation = {{cos, -spin * sin, -spin * spin * cos}, {sin, spin * cos, -spin * spin * sin}};
  }
  if constexpr (M::angular == 3) {
    const Quaternion<double>& q = pose.rotation;
    const Quaternion<double> rate = turning(q, V.template tail<3>());
    const double bend = -0.25 * V.template tail<3>().squaredNorm();
    for (int i = 0; i < 4; ++i)
      path.rotation.coeffs()[i] = {q.coeffs()[i], rate.coeffs()[i], bend * q.coeffs()[i]};
  }
  return path;
}

/// J̇V of C̈ = J V̇ + J̇V: the second derivative of C along paths of constant V [units of C per second²].
template <class Kind, class M>
Rows<Kind::rows> bias_acceleration(const Kind& constraint, const Pose<M, Jet>& path1, const Pose<M, Jet>& path2) {
  const Rows<Kind::rows, Jet> C = constraint.template value<Jet>(path1, path2);
  Rows<Kind::rows> result;
  for (int k = 0; k < Kind::rows; ++k) result[k] = C[k].bend;
  return result;
}

}  // namespace byhand

template <>
struct Eigen::NumTraits<byhand::Jet> : Eigen::NumTraits<double> {
  using Real = byhand::Jet;
  using NonInteger = byhand::Jet;
  using Nested = byhand::Jet;
  enum { RequireInitialization = 1, ReadCost = 3, AddCost = 3, MulCost = 8 };
};
