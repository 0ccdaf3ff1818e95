#pragma once

#include <string>

#include "solver/integrate/euler.hpp"
#include "solver/integrate/gyroscopic.hpp"
#include "solver/methods/positions.hpp"
#include "solver/scene.hpp"
#include "solver/touching.hpp"

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
template <class S>
std::string refusal(const S&, const Xpbd&) {
  return {};
}

/// What is kept between steps: scratch, and λ of the last substep in `rows`, which can be measured.
template <class M>
struct Xpbd::Work {
  PositionRows rows;
  std::vector<Pose<M>> before;
  std::conditional_t<M::angular == 0, NoTouching, Touching<M>> touching;
  double h = 0;              // the substep that λ belongs to [s]
  long long row_solves = 0;  // so far
};

//! [step]
/// One time step [s]. Throws std::invalid_argument for a step <= 0 or a method outside its range.
template <class S, class M = typename S::model>
void advance(S& scene, const Xpbd& method, double step, Xpbd::Work<M>& work) {
  require_steppable(scene, method, step);
  if constexpr (S::touches) work.touching.find(scene);
  lay_out(scene, work.rows);
  Bodies<M>& bodies = scene.bodies;
  const double h = work.h = step / method.substeps;
  for (int substep = 0; substep < method.substeps; ++substep) {
    for_each_with_row(scene, [&]<class Kind>(const Kind& constraint, int row) {
      begin_rows(constraint, bodies, h, row, work.rows);
      if constexpr (Kind::bound != Bound::none && Kind::drifting > 0)
        push_out_slowly(constraint, bodies, method.push_speed * h, row, work.rows);
    });
    std::fill(work.rows.impulse.begin(), work.rows.impulse.end(), 0.0);
    begin_turn(method.gyroscopic, bodies, h);
    add_gravity(bodies, scene.gravity, h);
    work.before = bodies.pose;
    advance_poses(bodies, h);
    for (int i = 0; i < method.iterations; ++i)
      for_each_with_row(scene, [&](const auto& constraint, int row) {
        solve_on_positions(constraint, bodies, h, row, work.rows);
      });
    velocities_between(work.before, h, bodies);
    end_turn(method.gyroscopic, bodies, h);
    work.row_solves += static_cast<long long>(method.iterations) * work.rows.rows();
    work.row_solves += end_rows(scene, h, method.bounce_threshold, work.rows);
  }
}
//! [step]

}  // namespace byhand
