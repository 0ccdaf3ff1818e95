#pragma once

#include <algorithm>
#include <cmath>

#include "lessons/doctor/rows.hpp"

// What the file's own step makes of the scene's motion.
namespace byhand::doctor {

/// The power [W] that rows without bounds take because J stands still over a step of h [s]: after the step they
/// turn by J̇V h against V, and the next step takes that away, ½(J̇V h)ᵀA⁻¹(J̇V h).
template <class M>
double power_of_turning_rows(const Moment<M>& moment, const std::vector<double>& bend, double h) {
  Work<M> solving = moment.work;
  System<M>& system = solving.system;
  for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run&) {
    for (int k = 0; k < K; ++k) system.bias[block.row + k] = B == Bound::none ? bend[block.row + k] : 1e9;
  });
  system.lambda.assign(system.lambda.size(), 0.0);
  Bodies<M> bodies = moment.scene.bodies();
  for (auto& v : bodies.velocity) v.setZero();
  solve_rows<M>(RowSolver(ByGraph{}), bodies, solving);
  double sum = 0;
  for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run&) {
    if (B != Bound::none) return;
    for (int k = 0; k < K; ++k) sum -= system.lambda[block.row + k] * bend[block.row + k];
  });
  return std::max(0.0, 0.5 * h * sum);
}

/// The body and its change of velocity.
struct Kick {
  int body = -1;
  double speed = 0;  // [m/s]
};

/// The largest velocity of a body, by its spin times half its size too, that the file's first step has beside the
/// same step with exact solves.
template <class M>
Kick left_by_the_first_step(const Scene<M>& scene, const VelocityStepping& method, double step,
                            const std::vector<double>& sizes) {
  Kick worst;
  VelocityStepping exact = method;
  exact.solver = ByGraph{};
  Simulation<M> own{scene, method}, exactly{scene, exact};
  try {
    own.step(step), exactly.step(step);
  } catch (const std::runtime_error&) {
    return worst;
  }
  for (int i = 0; i < scene.bodies().size(); ++i) {
    const Velocity<M> apart = own.scene.bodies().velocity[i] - exactly.scene.bodies().velocity[i];
    double speed = apart.template head<M::linear>().norm();
    if constexpr (M::angular > 0)
      speed = std::max(speed, 0.5 * sizes[static_cast<std::size_t>(i)] * apart.template tail<M::angular>().norm());
    if (speed > worst.speed) worst = {i, speed};
  }
  return worst;
}

/// How fast the file's steps carry a body that no joint holds to one side of where exact solves leave it, once the
/// first steps are over. Of sweeps that begin at λ = 0: each step then leaves the same.
template <class M>
Kick drift_across_gravity(const Scene<M>& scene, const VelocityStepping& method, double step) {
  constexpr int begin = 15, end = 30;  // steps
  Kick worst;
  const double gravity = scene.gravity.norm();
  VelocityStepping exact = method;
  exact.solver = ByGraph{};
  Simulation<M> own{scene, method}, exactly{scene, exact};
  const auto apart = [&] {
    std::vector<Linear<M>> all;
    for (int i = 0; i < scene.bodies().size(); ++i) {
      const Linear<M> off = own.scene.bodies().pose[i].position - exactly.scene.bodies().pose[i].position;
      all.push_back(off - off.dot(scene.gravity) / (gravity * gravity) * scene.gravity);
    }
    return all;
  };
  if (gravity == 0) return worst;
  std::vector<Linear<M>> before;
  try {
    for (int i = 0; i < end; ++i) {
      if (i == begin) before = apart();
      own.step(step), exactly.step(step);
    }
  } catch (const std::runtime_error&) {
    return worst;
  }
  std::vector<char> held(before.size(), 0);
  for_each_block(exactly.work.system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run&) {
    if (B == Bound::none) held[block.body1] = held[block.body2] = 1;
  });
  const std::vector<Linear<M>> after = apart();
  const auto rests = [&](std::size_t i) {
    const int body = static_cast<int>(i);
    return exactly.scene.bodies().velocity[body].template head<M::linear>().norm() < 0.1 * gravity * step;
  };
  for (std::size_t i = 0; i < before.size(); ++i)
    if (const double speed = (after[i] - before[i]).norm() / ((end - begin) * step);
        !held[i] && rests(i) && speed > worst.speed)
      worst = {static_cast<int>(i), speed};
  return worst;
}

}  // namespace byhand::doctor
