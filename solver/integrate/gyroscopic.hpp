#pragma once

#include "solver/integrate/euler.hpp"

// A body with three different principal moments keeps its angular momentum, not its angular velocity. With π = IΩ,
// both in the body's axes, Euler's equations
//
//   π̇ = π × Ω            (in the world I ω̇ = -ω × Iω)
//
// turn π backwards as fast as the body turns forwards. A step without this term keeps ω and loses Iω.
//
//   explicit_   Ω₁ = Ω₀ + h I⁻¹(π₀ × Ω₀). It gains energy: E₁ - E₀ = ½h² (π₀ × Ω₀) · I⁻¹(π₀ × Ω₀) >= 0.
//
//   implicit    The pose turns by exp(hΩ) about one axis Ω for the whole step. That keeps the world's momentum if
//               π₁ = exp(-hΩ) π₀, which with the mean π_m = (π₀ + π₁)/2 is (Rodrigues' formula)
//
//                   π₁ - π₀ = h f π_m × Ω,    f = tan(θ/2)/(θ/2),  θ = h|Ω|.
//
//               Its product with I⁻¹π_m is the change of energy, which vanishes if Ω = I⁻¹π_m. So both are kept
//               exactly when Ω is the mean of Ω₀ and Ω₁: the implicit midpoint rule, with f ≈ 1 + θ²/12 instead of
//               Cayley's 1 because the pose turns by exp. Half of the step precedes the row solve, half follows:
//
//                   before   π_m + ½hf Ω × π_m = π₀,  π_m = IΩ    three equations for Ω, by Newton's method
//                   after    π₁ = π_m - ½hf Ω × π_m               with Ω as changed by the rows
//
//               The rows thus see the velocity with which poses move. (Source of the rule with Cayley's map: J. C.
//               Simo and K. K. Wong, Unconditionally stable algorithms for rigid body dynamics that exactly
//               preserve energy and momentum, Int. J. Numer. Meth. Engng 31, 1991; f is derived here.)
//
//               f is infinite at θ = π. So a body that turns by more than 1 rad makes several such turns in the
//               step, of at most 1 rad each. The rows see the Ω of the first one; once they are solved, it and the
//               others follow, at a cost proportional to the angle. So a free body keeps energy and momentum at
//               any spin.
namespace byhand {

/// How ω × Iω of bodies in space enters a step; other models have no such term.
enum class Gyroscopic { none, explicit_, implicit };

/// Before the rows are solved: changes velocities from Ω₀ to Ω, with which the poses turn for a step h [s].
void begin_turn(Gyroscopic choice, Bodies<SpaceBody>& bodies, double h);
/// After the poses have moved: changes velocities from Ω to Ω₁, and where a body turns by more than 1 rad its
/// rotation too. Throws NotFinite for more than 100,000 rad.
void end_turn(Gyroscopic choice, Bodies<SpaceBody>& bodies, double h);
template <class M>
void begin_turn(Gyroscopic, Bodies<M>&, double) {}
template <class M>
void end_turn(Gyroscopic, Bodies<M>&, double) {}

/// Moves the bodies freely for h [s]: poses along velocities, which become those at the end.
template <class M>
void move_freely(Gyroscopic choice, Bodies<M>& bodies, double h) {
  begin_turn(choice, bodies, h);
  advance_poses(bodies, h);
  end_turn(choice, bodies, h);
}

}  // namespace byhand
