#include "lessons/laws/redundant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lessons/scenes/pendulum.hpp"
#include "solver/step.hpp"

// Law 8. Two rods between the same points have the same J and so one answer for the sum of their λ only. If their
// lengths differ by Δ, so do their biases, by βΔ/h: each row that is solved undoes what the other has just done,
// by an impulse of mβΔ/h. A warm start keeps both sums. So after k sweeps in each step the two pulls have come
// apart by 2kmβΔ/h more, for ever, while the bob hardly moves:
//
//   d|λ1 - λ2|/dt = 2kmβΔ/h²
//
// Softness ends it where γ(λ1 - λ2) makes up for the difference of the biases: |λ1 - λ2| = βΔ/(hγ).
//
// Derived for this course.
namespace byhand::laws {

namespace {

Simulation<PlaneParticle> bob_of(const ConflictingRods& rods) {
  using M = PlaneParticle;
  const double length = 2, mass = 3;
  auto scene = pendulum<M, NormalisedDistance>(0, length, mass);
  scene.add(NormalisedDistance<M>{{0, 1}, length + rods.conflict});
  scene.change_all<NormalisedDistance>([&](auto& rod) { rod.softness = rods.softness; });
  VelocityStepping method{GaussSeidel{rods.sweeps}, Baumgarte{rods.beta}};
  if (rods.sweeps == 0) method.solver = Direct{};
  return {std::move(scene), method};
}

}  // namespace

double pull_apart(const ConflictingRods& rods, double time) {
  Simulation<PlaneParticle> bob = bob_of(rods);
  while (bob.time < time - 0.5 * rods.step) bob.step(rods.step);
  const auto& lambda = bob.work.system.lambda;
  return std::abs(lambda[0] - lambda[1]) / rods.step;
}

double bob_moves(const ConflictingRods& rods, double time) {
  Simulation<PlaneParticle> bob = bob_of(rods);
  const Eigen::Vector2d start = bob.scene.bodies().pose[1].position;
  double farthest = 0;
  while (bob.time < time - 0.5 * rods.step) {
    bob.step(rods.step);
    farthest = std::max(farthest, (bob.scene.bodies().pose[1].position - start).norm());
  }
  return farthest;
}

Law conflicting_rows() {
  Law law{8,
          Family::wrong_rows,
          "conflicting rows",
          "rows that contradict each other build up λ without bound, while the bodies hardly move",
          "|λ₁ − λ₂| grows by 2kmβΔ/h² a second; with softness it ends at βΔ/(hγ)",
          {}};
  for (const ConflictingRods& rods :
       {ConflictingRods{}, {.conflict = 0.01}, {.beta = 0.05}, {.sweeps = 1}, {.step = 1.0 / 240}}) {
    const double h = rods.step;
    law.boundaries.push_back({"growth of the pulls' difference", "N/s",
                              fmt::format("Δ {} m, β {}, {}, {:.0f} Hz", rods.conflict, rods.beta,
                                          counted(rods.sweeps, "sweep"), 1 / h),
                              2 * rods.sweeps * 3 * rods.beta * rods.conflict / (h * h * h), 0.02,
                              [=] { return (pull_apart(rods, 4) - pull_apart(rods, 2)) / 2; }});
  }
  for (const double softness : {1e-3, 1e-2}) {
    ConflictingRods rods;
    rods.softness = softness;
    law.boundaries.push_back({"bound of the pulls' difference", "N", fmt::format("γ {} 1/kg", softness),
                              rods.beta * rods.conflict / (rods.step * rods.step * softness), 0.02,
                              [=] { return pull_apart(rods, 100); }});
  }
  return law;
}

}  // namespace byhand::laws
