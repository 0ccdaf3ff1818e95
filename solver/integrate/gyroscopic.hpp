#pragma once

#include "solver/body.hpp"

// A body whose three moments differ keeps its angular momentum, not its angular velocity. With π = IΩ, both in the
// body's own axes, Euler's equations
//
//   π̇ = π × Ω            (the world's I ω̇ = -ω × Iω, seen from the body)
//
// turn π backwards as fast as the body turns forwards. A step that leaves this out keeps ω and loses Iω.
//
//   explicit_   Ω₁ = Ω₀ + h I⁻¹(π₀ × Ω₀). It gains energy: E₁ - E₀ = ½h² (π₀ × Ω₀) · I⁻¹(π₀ × Ω₀) >= 0.
//
//   implicit    The pose turns by exp(hΩ) about one axis Ω for the whole step. That keeps the world's momentum if
//               π₁ = exp(-hΩ) π₀, which of the mean π_m = (π₀ + π₁)/2 says (Rodrigues' formula)
//
//                   π₁ - π₀ = h f π_m × Ω,    f = tan(θ/2)/(θ/2),  θ = h|Ω|.
//
//               Its product with I⁻¹π_m is the change of energy, which vanishes if Ω = I⁻¹π_m. So both are kept
//               exactly when Ω is the mean of Ω₀ and Ω₁: the implicit midpoint rule, with f ≈ 1 + θ²/12 in place
//               of Cayley's 1 because the pose turns by exp. The step comes in two halves about the row solve:
//
//                   before   π_m + ½hf Ω × π_m = π₀,  π_m = IΩ    three equations for Ω, by Newton
//                   after    π₁ = π_m - ½hf Ω × π_m               with Ω as the rows have left it
//
//               The rows thus see the velocity with which poses move. (Source of the rule with Cayley's map: J. C.
//               Simo and K. K. Wong, Unconditionally stable algorithms for rigid body dynamics that exactly
//               preserve energy and momentum, Int. J. Numer. Meth. Engng 31, 1991; f is derived here.)
namespace byhand {

/// How ω × Iω of a body in space enters a step; of any other model there is none.
enum class Gyroscopic { none, explicit_, implicit };

/// Ω to turn with for a step h [s], and so to solve the rows with, from Ω₀ [rad/s]; `moments` are the principal
/// ones [kg m²], all in the body's axes.
Eigen::Vector3d turn_with(Gyroscopic choice, const Eigen::Vector3d& spin, const Eigen::Vector3d& moments,
                          double h);
/// Ω₁ [rad/s] at the end of a step h [s] that turned with Ω.
Eigen::Vector3d after_turn(Gyroscopic choice, const Eigen::Vector3d& spin, const Eigen::Vector3d& moments,
                           double h);

namespace detail {

template <auto half, class M>
void for_each_spin(Gyroscopic choice, Bodies<M>& bodies, double h) {
  if constexpr (M::angular == 3) {
    if (choice == Gyroscopic::none) return;
    for (int i = 0; i < bodies.size(); ++i) {
      if (!moves(bodies.inverse_mass[i])) continue;
      const Eigen::Quaterniond& q = bodies.pose[i].rotation;
      auto omega = bodies.velocity[i].template tail<3>();
      const Eigen::Vector3d moments = bodies.inverse_mass[i].angular.cwiseInverse();
      const Eigen::Vector3d spin = rotate(inverse(q), omega);
      omega += rotate(q, half(choice, spin, moments, h) - spin);  // only the change, or rounding of |q| adds up
    }
  }
}

}  // namespace detail

//! [gyroscopic]
/// The gyroscopic moments into V before the rows are solved.
template <class M>
void begin_turn(Gyroscopic choice, Bodies<M>& bodies, double h) {
  detail::for_each_spin<turn_with>(choice, bodies, h);
}
/// What is left of them when the poses have moved.
template <class M>
void end_turn(Gyroscopic choice, Bodies<M>& bodies, double h) {
  if (choice == Gyroscopic::implicit) detail::for_each_spin<after_turn>(choice, bodies, h);
}
//! [gyroscopic]

}  // namespace byhand
