#pragma once

#include <algorithm>
#include <vector>

#include "solver/model.hpp"
#include "solver/support/finite.hpp"
#include "solver/support/require.hpp"

namespace byhand {

/// One body's share of M⁻¹ in (18): m⁻¹ [1/kg] and, where the body turns, I⁻¹ in the body frame, along its
/// principal axes [1/(kg m²)]. Zero throughout means that no force moves it: see `fixed`.
template <class M>
struct InverseMass {
  double linear = 0;
  Angular<M> angular = Angular<M>::Zero();
};
template <int L>
struct InverseMass<Model<L, 0>> {
  double linear = 0;
};

/// A body that constraints can lean on and that no force moves. It rests, or it keeps the velocity that it is
/// given, like a lift or a driven crank.
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
/// plane, three in space, of which none exceeds the sum of the other two (∫x² ≥ 0 along each axis).
template <class M>
requires(M::angular > 0) InverseMass<M> with_mass(double mass, const Angular<M>& inertia) {
  require_positive("mass", mass, "kg");
  for (const double moment : inertia) require_positive("moment of inertia", moment, "kg m²");
  if constexpr (M::angular == 3) {
    const double largest = inertia.maxCoeff(), others = inertia.sum() - largest;
    if (largest > others * (1 + 1e-12))
      refuse("largest moment of inertia", largest, "at most " + text_of(others) + ", the sum of the other two",
             "kg m²");
  }
  return {1 / mass, inertia.cwiseInverse()};
}

/// A uniform disc (plane) or solid ball (space) of `radius` [m].
template <class M>
InverseMass<M> ball(double mass, double radius) {
  require_positive("radius", radius, "m");
  return with_mass<M>(mass, Angular<M>::Constant((M::linear == 2 ? 0.5 : 0.4) * mass * radius * radius));
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
using InverseInertia = Eigen::Matrix<double, M::angular, M::angular>;
template <class M>
InverseInertia<M> inverse_inertia(const InverseMass<M>& inverse_mass, const Pose<M>& pose) {
  if constexpr (M::angular == 3) {
    const Eigen::Matrix3d R = pose.rotation.toRotationMatrix();
    return R * inverse_mass.angular.asDiagonal() * R.transpose();
  } else {
    return inverse_mass.angular;
  }
}
template <class M>
const InverseInertia<M>& inverse_inertia(const InverseMass<M>&, const InverseInertia<M>& known) {
  return known;
}

/// I in the world [kg m²].
template <class M>
InverseInertia<M> inertia(const InverseMass<M>& inverse_mass, const Pose<M>& pose) {
  return inverse_inertia(InverseMass<M>{inverse_mass.linear, inverse_mass.angular.cwiseInverse()}, pose);
}

/// M⁻¹ of (18) times a force and torque [N, N m] or an impulse and angular impulse [N s, N m s].
template <class M>
Velocity<M> times_inverse_mass(const Velocity<M>& force, const InverseMass<M>& mass, const Pose<M>& pose) {
  Velocity<M> gain;
  gain.template head<M::linear>() = mass.linear * force.template head<M::linear>();
  if constexpr (M::angular > 0)
    gain.template tail<M::angular>() = inverse_inertia(mass, pose) * force.template tail<M::angular>();
  return gain;
}

template <class M>
class Scene;

/// The inverse masses of all bodies. Whether a body moves decides how rows are laid out, so that only the scene,
/// which counts such changes, may write them.
template <class M>
class InverseMasses {
 public:
  const InverseMass<M>& operator[](int body) const { return all_[body]; }
  auto begin() const { return all_.begin(); }
  auto end() const { return all_.end(); }

 private:
  friend class Scene<M>;
  std::vector<InverseMass<M>> all_;
};

/// How gravity and damping act on one body: v' = s g - c v and ω' = -d ω.
struct BodyForces {
  double gravity_scale = 1;                        // s
  double linear_damping = 0, angular_damping = 0;  // c and d [1/s] >= 0
};

/// All bodies of a scene, each quantity contiguous: the solver's inner loop reads velocities alone.
template <class M>
struct Bodies {
  std::vector<Pose<M>> pose;
  std::vector<Velocity<M>> velocity;
  InverseMasses<M> inverse_mass;
  std::vector<int> removed;          // indices that no body has at present
  std::vector<BodyForces> forces;    // by body; empty while all have the default
  std::vector<Velocity<M>> applied;  // force [N] and torque [N m] on each body throughout the next step; or empty

  int size() const { return static_cast<int>(pose.size()); }
  bool has(int body) const {
    return 0 <= body && body < size() && std::find(removed.begin(), removed.end(), body) == removed.end();
  }
};

/// Whether the pose of a body changes with time.
template <class M>
bool in_motion(const Bodies<M>& bodies, int body) {
  return moves(bodies.inverse_mass[body]) || !bodies.velocity[body].isZero(0);
}

/// Whether all of these are finite numbers: 0 x is zero for those, and not a number for the others.
template <int L, int A>
bool are_finite(const std::vector<Pose<Model<L, A>>>& pose, const std::vector<Packed<double, L + A>>& velocity) {
  Packed<double, L> x = decltype(x)::Zero();
  Packed<double, L + A> V = decltype(V)::Zero();
  Eigen::Matrix<double, A == 3 ? 4 : 2, 1> q = decltype(q)::Zero();
  for (std::size_t i = 0; i < pose.size(); ++i) {
    x += 0 * pose[i].position;
    V += 0 * velocity[i];
    if constexpr (A == 1) {
      const Eigen::Vector2d turned(pose[i].rotation.cos, pose[i].rotation.sin);
      q += 0 * turned;
    }
    if constexpr (A == 3) q += 0 * pose[i].rotation.coeffs();
  }
  return x.sum() + V.sum() + q.sum() == 0;
}

/// Throws NotFinite for the first body with a pose or velocity that is not finite; `when` ends the sentence.
template <class M>
void require_finite(const std::vector<Pose<M>>& pose, const std::vector<Velocity<M>>& velocity, const char* when) {
  if (are_finite(pose, velocity)) return;
  int body = 0;
  while (are_finite<M::linear, M::angular>({pose[body]}, {velocity[body]})) ++body;
  throw NotFinite("body " + std::to_string(body) + " has a position or velocity that is not a finite number" +
                  when);
}

/// Throws std::invalid_argument unless `body` is the index of a body.
template <class M>
void require_body(const Bodies<M>& bodies, int body) {
  if (bodies.has(body)) return;
  const bool removed = 0 <= body && body < bodies.size();
  refuse("body index", body,
         removed ? "that of a body that was not removed"
                 : "at least 0 and less than " + std::to_string(bodies.size()) + ", the number of bodies");
}

/// Throws std::invalid_argument for a position that is not finite or a rotation that is not of length 1.
template <class M>
void require_valid(const Pose<M>& pose) {
  for (const double x : pose.position) require_finite("position", x, "m");
  double norm2 = 1;
  if constexpr (M::angular == 1)
    norm2 = pose.rotation.cos * pose.rotation.cos + pose.rotation.sin * pose.rotation.sin;
  if constexpr (M::angular == 3) norm2 = pose.rotation.squaredNorm();
  require_unit("squared length of the rotation", norm2);
}

/// Throws std::invalid_argument for an inverse mass that is neither positive nor zero throughout.
template <class M>
void require_valid(const InverseMass<M>& mass) {
  const auto fits = [&](double share) { return moves(mass) ? share > 0 && std::isfinite(share) : share == 0; };
  constexpr auto allowed = "positive and finite, or zero throughout for a fixed body";
  require(fits(mass.linear), "inverse mass", mass.linear, allowed);
  if constexpr (M::angular > 0)
    for (const double share : mass.angular) require(fits(share), "inverse moment of inertia", share, allowed);
}

/// Throws std::invalid_argument for a velocity that is not finite.
template <class M>
void require_valid(const Velocity<M>& velocity) {
  for (const double v : velocity) require_finite("velocity", v, "m/s or rad/s");
}

}  // namespace byhand
