#include "lessons/methods/accelerations.hpp"

#include "solver/support/each_model.hpp"

namespace byhand {
namespace {

/// Writes M⁻¹F of every body at its pose and velocity [m/s², rad/s²].
template <class M>
void write_free_accelerations(const Bodies<M>& bodies, const Linear<M>& gravity, Bodies<M>& accelerated) {
  accelerated = bodies;
  for (int i = 0; i < bodies.size(); ++i)
    accelerated.velocity[i] =
        moves(bodies.inverse_mass[i]) ? free_acceleration(bodies, i, gravity) : Velocity<M>(Velocity<M>::Zero());
}

/// Writes V̇ of all bodies into `work.accelerated`, and f [N, or what is conjugate to C] into `work.change`.
template <class M>
void accelerate(const Scene<M>& scene, double regularisation, Accelerations::Work<M>& work) {
  const Bodies<M>& bodies = scene.bodies();
  scene.write_rows(work.system, work.h);  // J and M⁻¹Jᵀ
  for (int i = 0; i < bodies.size(); ++i) work.paths[i] = on_its_way<M>(bodies.pose[i], bodies.velocity[i]);
  scene.write_bias_accelerations(work.system, work.paths, work.offset);  // J̇V
  write_free_accelerations(bodies, scene.gravity, work.accelerated);
  solve_rows(regularisation, work.accelerated, work);              // f
  apply_all(work.system, work.change, work.accelerated.velocity);  // M⁻¹F + M⁻¹Jᵀf
}

/// A stage of an explicit Runge–Kutta rule: the weight of its slope in the whole step's, and the share of the step
/// that is made along it to the next stage, 0 for the last.
struct Stage {
  double weight, to_next;
};
inline constexpr Stage euler_stages[] = {{1, 0}};
inline constexpr Stage rk4_stages[] = {{1.0 / 6, 0.5}, {1.0 / 3, 0.5}, {1.0 / 3, 1}, {1.0 / 6, 0}};

/// Moves a body from the start of the substep for `time` [s] along a slope.
template <class M>
void go_along(const Slope<M>& slope, double time, int body, Bodies<M>& bodies, const Bodies<M>& begin) {
  const Pose<M>& from = begin.pose[body];
  Pose<M>& pose = bodies.pose[body];
  bodies.velocity[body] = begin.velocity[body] + time * slope.acceleration;
  if constexpr (M::angular == 3) {
    pose.position = from.position + time * slope.velocity.template head<3>();
    pose.rotation.coeffs() = (from.rotation.coeffs() + time * slope.turning).normalized();
  } else {
    pose = moved<M, double>(from, slope.velocity, time);
  }
}

/// One substep by an explicit rule whose stages each need only the one before.
template <class M>
void runge_kutta(Scene<M>& scene, std::span<const Stage> stages, double regularisation,
                 Accelerations::Work<M>& work) {
  Bodies<M>& bodies = scene.state();
  std::fill(work.sum.begin(), work.sum.end(), Slope<M>());
  for (const auto& [weight, to_next] : stages) {
    accelerate(scene, regularisation, work);
    for (std::size_t row = 0; row < work.change.size(); ++row)
      work.system.lambda[row] += weight * work.h * work.change[row];
    for (int i = 0; i < bodies.size(); ++i) {
      if (!in_motion(bodies, i)) continue;
      Slope<M> slope{bodies.velocity[i], work.accelerated.velocity[i]}, &sum = work.sum[i];
      if constexpr (M::angular == 3)
        slope.turning = turning(bodies.pose[i].rotation, slope.velocity.template tail<3>()).coeffs();
      sum.velocity += weight * slope.velocity;
      sum.acceleration += weight * slope.acceleration;
      sum.turning += weight * slope.turning;
      const bool last = to_next == 0;
      go_along(last ? sum : slope, last ? work.h : to_next * work.h, i, bodies, work.begin);
    }
  }
}

/// Moves the bodies to the middle of the substep with the current accelerations. Returns the change of their
/// velocities, the root of a sum of `square_of`.
template <class M>
double go_to_middle(Bodies<M>& bodies, const Accelerations::Work<M>& work) {
  double sum = 0;
  for (int i = 0; i < bodies.size(); ++i) {
    if (!in_motion(bodies, i)) continue;
    const Velocity<M> V = work.begin.velocity[i] + work.h / 2 * work.accelerated.velocity[i];
    if (const InverseMass<M>& mass = bodies.inverse_mass[i]; moves(mass))
      sum += square_of<M>(mass, V - bodies.velocity[i]);
    bodies.velocity[i] = V;
    bodies.pose[i] = moved<M, double>(work.begin.pose[i], V, work.h / 2);
  }
  return std::sqrt(sum);
}

/// One substep by the implicit midpoint rule, to rounding.
template <class M>
void implicit_midpoint(Scene<M>& scene, double regularisation, Accelerations::Work<M>& work) {
  Bodies<M>& bodies = scene.state();
  const auto accelerate_there = [&] { accelerate(scene, regularisation, work); };
  accelerate_there();
  iterate(
      tolerance(bodies, work.h), [&] { return go_to_middle(bodies, work); }, accelerate_there);
  for (std::size_t row = 0; row < work.change.size(); ++row) work.system.lambda[row] = work.h * work.change[row];
  for (int i = 0; i < bodies.size(); ++i) {
    if (!in_motion(bodies, i)) continue;
    bodies.pose[i] = moved<M, double>(work.begin.pose[i], bodies.velocity[i], work.h);
    bodies.velocity[i] = work.begin.velocity[i] + work.h * work.accelerated.velocity[i];
  }
}

}  // namespace

template <class M>
void advance(Scene<M>& scene, const Accelerations& method, double step, Accelerations::Work<M>& work) {
  require_steppable(scene, method, step);
  Attempt attempt(scene, work);
  begin_equalities(scene, step / method.substeps, work);
  require_slow_damping(scene.bodies(), work.h);
  work.paths.resize(scene.bodies().size());
  work.sum.resize(scene.bodies().size());
  run_substeps(method.substeps, scene, work, [&] {
    switch (method.scheme) {
      case Scheme::explicit_euler: return runge_kutta(scene, euler_stages, method.regularisation, work);
      case Scheme::rk4: return runge_kutta(scene, rk4_stages, method.regularisation, work);
      case Scheme::implicit_midpoint: return implicit_midpoint(scene, method.regularisation, work);
    }
  });
  attempt.finish();
}

#define BYHAND_INSTANTIATE(M) \
  template void advance(Scene<M>&, const Accelerations&, double, Accelerations::Work<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
