#pragma once

#include <vector>

#include "solver/model.hpp"
#include "solver/require.hpp"

namespace byhand {

/// One body's share of M⁻¹ in (18): m⁻¹ [1/kg] and, where the body turns, I⁻¹ in the body frame, along its
/// principal axes [1/(kg m²)]. Zero throughout means fixed: that, and not a mass of zero, is how a body is
/// held.
template <class M>
struct InverseMass {
  double linear = 0;
  Angular<M> angular = Angular<M>::Zero();
};
template <int L>
struct InverseMass<Model<L, 0>> {
  double linear = 0;
};

/// A body that constraints can lean on and that nothing moves.
template <class M>
InverseMass<M> fixed() {
  return {};
}

template <class M>
bool moves(const InverseMass<M>& inverse_mass) {
  return inverse_mass.linear > 0;
}

/// A particle of `mass` [kg] > 0.
template <class M>
requires(M::angular == 0) InverseMass<M> with_mass(double mass) {
  require_positive("mass", mass, "kg");
  return {1 / mass};
}

/// A body of `mass` [kg] > 0 and principal moments of `inertia` [kg m²] > 0 about its centre: one in the
/// plane, three in space.
template <class M>
requires(M::angular > 0) InverseMass<M> with_mass(double mass, const Angular<M>& inertia) {
  require_positive("mass", mass, "kg");
  for (const double moment : inertia) require_positive("moment of inertia", moment, "kg m²");
  return {1 / mass, inertia.cwiseInverse()};
}

/// A uniform disc (plane) or solid ball (space) of `radius` [m].
template <class M>
InverseMass<M> ball(double mass, double radius) {
  require_positive("radius", radius, "m");
  const double share = M::linear == 2 ? 0.5 : 0.4;
  return with_mass<M>(mass, Angular<M>::Constant(share * mass * radius * radius));
}

/// A uniform box with full side lengths `sides` [m].
template <class M>
InverseMass<M> box(double mass, const Linear<M>& sides) {
  for (const double side : sides) require_positive("side", side, "m");
  const Linear<M> squares = sides.cwiseAbs2();
  if constexpr (M::linear == 2)
    return with_mass<M>(mass, Angular<M>(mass / 12 * squares.sum()));
  else
    return with_mass<M>(mass, Angular<M>(mass / 12 * (squares.sum() - squares.array())));
}

/// I⁻¹ of (18) in the world [1/(kg m²)]: a number in the plane. In space it belongs to the body and turns with it:
/// R I⁻¹ Rᵀ.
template <class M>
Eigen::Matrix<double, M::angular, M::angular> inverse_inertia(const InverseMass<M>& inverse_mass,
                                                              const Pose<M>& pose) {
  if constexpr (M::angular == 3) {
    const Eigen::Matrix3d R = pose.rotation.toRotationMatrix();
    return R * inverse_mass.angular.asDiagonal() * R.transpose();
  } else {
    return inverse_mass.angular;
  }
}

/// I in the world [kg m²].
template <class M>
Eigen::Matrix<double, M::angular, M::angular> inertia(const InverseMass<M>& inverse_mass, const Pose<M>& pose) {
  InverseMass<M> mass = inverse_mass;
  mass.angular = inverse_mass.angular.cwiseInverse();
  return inverse_inertia(mass, pose);
}

/// All bodies of a scene, each quantity contiguous: the solver's inner loop reads velocities alone.
template <class M>
struct Bodies {
  std::vector<Pose<M>> pose;
  std::vector<Velocity<M>> velocity;
  std::vector<InverseMass<M>> inverse_mass;

  int size() const { return static_cast<int>(pose.size()); }

  /// Adds a body and returns its index. Throws std::invalid_argument for numbers that are not finite, a rotation
  /// that is none, and an inverse mass that is neither positive nor zero throughout.
  int add(const Pose<M>& at, const InverseMass<M>& mass, const Velocity<M>& moving) {
    for (const double x : at.position) require_finite("position", x, "m");
    for (const double v : moving) require_finite("velocity", v, "m/s or rad/s");
    if constexpr (M::angular > 0) require_unit(at.rotation);
    require_mass(mass);
    require(moves(mass) || moving.isZero(0), "velocity of a fixed body", moving.norm(), "zero");
    pose.push_back(at);
    velocity.push_back(moving);
    inverse_mass.push_back(mass);
    return size() - 1;
  }

 private:
  static void require_mass(const InverseMass<M>& mass) {
    const auto fits = [&](double share) { return moves(mass) ? share > 0 && std::isfinite(share) : share == 0; };
    constexpr auto allowed = "positive and finite, or zero throughout for a fixed body";
    require(fits(mass.linear), "inverse mass", mass.linear, allowed);
    if constexpr (M::angular > 0)
      for (const double share : mass.angular) require(fits(share), "inverse moment of inertia", share, allowed);
  }
  static void require_unit(const Rotation<M>& rotation) {
    double norm2 = 0;
    if constexpr (M::angular == 1) norm2 = rotation.cos * rotation.cos + rotation.sin * rotation.sin;
    if constexpr (M::angular == 3) norm2 = rotation.squaredNorm();
    require_in("squared length of the rotation", norm2, 1 - 1e-9, 1 + 1e-9);
  }
};

}  // namespace byhand
