#pragma once

#include "solver/integrate/gyroscopic.hpp"
#include "solver/methods/positions.hpp"

// Extended position-based dynamics of rigid bodies. A substep h moves the poses freely, puts them onto the
// constraints, and reads the velocities off where they went:
//
//   x* = x₀ + h (v₀ + h g)           poses as nothing holds them
//   C(x* + M⁻¹JᵀΛ) + γΛ = 0          each constraint in turn, by positions.hpp, from Λ = 0
//   v₁ = (x₁ - x₀)/h                 a chord, not a tangent
//
// Without γ, C is kept to rounding in as many iterations as Newton needs. But v₁ points along the chord, x* of the
// next substep leaves the constraint by twice what a tangent would, and putting it back shortens the way: a
// particle on a circle that turned by φ in one substep turns by tan φ₁ = sin φ/(2 - cos φ), or φ - φ³, in the
// next. Its spin falls as ω₀/√(1 + 2ω₀² h t) though nothing brakes it. More substeps cure that and more iterations
// do not. The linear momentum of free bodies is kept: a constraint moves its two bodies by opposite m Δx.
//
// An overlap would leave with the velocity C/h at which it is pushed out, which small substeps make large: a
// one-sided row asks for C >= C₀ + h·(push speed) while that is below zero. Contacts that were met fast are solved
// once more for the velocity -e JV⁻ with which they part. (The paper takes the speed off every contact that
// pressed instead. With one iteration that takes back part of the support which the sweep has just built up: two
// boxes, one upon the other, begin to rock and ten are thrown about, while as it is here they stand.)
//
// (Sources: M. Müller, M. Macklin, N. Chentanez, S. Jeschke, T.-Y. Kim, Detailed rigid body simulation with
// extended position based dynamics, SCA 2020; the law of the circle is derived here.)
namespace byhand {

/// XPBD, as choices. Cost of a step: substeps × iterations × rows, and once those of contacts that bounce.
struct Xpbd {
  template <class M>
  struct Work;

  int substeps = 20;                         // >= 1
  int iterations = 1;                        // of each substep >= 1
  Gyroscopic gyroscopic = Gyroscopic::none;  // of bodies in space
  double push_speed = 1;                     // with which overlap is pushed out at most [m/s] > 0
  double bounce_threshold = 0.5;             // slower than this nothing bounces [m/s] >= 0
};

/// Throws std::invalid_argument for a choice outside its range.
void require_valid(const Xpbd& method);

/// Why this scene cannot be run so: it always can.
template <class M>
std::string refusal(const Scene<M>&, const Xpbd&) {
  return {};
}

/// What is kept between steps: scratch, and λ of the last substep, which can be measured.
template <class M>
struct Xpbd::Work : PositionWork<M> {};

/// One time step [s]. Throws std::invalid_argument for a step <= 0 or a method outside its range.
template <class M>
void advance(Scene<M>& scene, const Xpbd& method, double step, Xpbd::Work<M>& work);

}  // namespace byhand
