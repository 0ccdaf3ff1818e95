#pragma once

#include "lessons/methods/positions.hpp"

// Extended position-based dynamics of rigid bodies. A substep h moves the poses freely, corrects them constraint
// by constraint, and takes the velocities from the displacement:
//
//   x* = x₀ + h (v₀ + h g)           free poses
//   C(x* + M⁻¹JᵀΛ) + γΛ = 0          each constraint in turn, friction last, by positions.hpp, from Λ = 0
//   v₁ = v₀ + h g + (x₁ - x*)/h      = (x₁ - x₀)/h, a chord, not a tangent
//
// A chord leaves the constraint by twice as much as a tangent, and correcting that shortens the path: a particle
// that turned by φ on a circle turns by φ₁ in the next substep, tan φ₁ = sin φ/(2 - cos φ), φ₁ ≈ φ - φ³. So its
// spin falls as ω₀/√(1 + 2ω₀² h t) without damping; more substeps reduce this, more iterations do not. Free bodies
// keep their linear momentum: a constraint moves its two bodies by opposite m Δx.
//
// An overlap would leave with the velocity C/h, so a one-sided row asks only for C >= C₀ + h·(push speed) while
// that is below zero. Contacts that met fast are solved again for the velocity -e JV⁻. (The paper takes the speed
// off every contact that pressed. With one iteration that undoes part of the sweep's support, and stacked boxes
// rock.)
//
// Source: M. Müller, M. Macklin, N. Chentanez, S. Jeschke, T.-Y. Kim, Detailed rigid body simulation with extended
// position based dynamics, SCA 2020. The law of the circle is derived here.
namespace byhand {

/// XPBD, as choices. Cost of a step: substeps × iterations × rows, and bouncing contacts once more.
struct Xpbd {
  template <class M>
  using Work = PositionWork<M>;

  int substeps = 20;                             // >= 1
  int iterations = 1;                            // per substep >= 1
  Gyroscopic gyroscopic = Gyroscopic::implicit;  // of bodies in space
  double push_speed = 1;                         // maximum speed at which overlap is pushed out [m/s] > 0
  double bounce_threshold = 0.5;                 // slower contacts do not bounce [m/s] >= 0
};

void require_valid(const Xpbd& method);
template <class M>
void advance(Scene<M>& scene, const Xpbd& method, double step, PositionWork<M>& work);

}  // namespace byhand
