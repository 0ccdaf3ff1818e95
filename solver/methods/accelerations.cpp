#include "solver/methods/accelerations.hpp"

namespace byhand {

void require_valid(const Accelerations& family) {
  require(family.substeps >= 1, "number of substeps", family.substeps, "at least 1");
  require_in("regularisation", family.regularisation, 0, 1);
}

template <class M>
void write_free_accelerations(const Bodies<M>& bodies, const Linear<M>& gravity, Bodies<M>& accelerated) {
  accelerated = bodies;
  for (int i = 0; i < bodies.size(); ++i) {
    Velocity<M>& a = accelerated.velocity[i];
    a.setZero();
    if (!moves(bodies.inverse_mass[i])) continue;
    a.template head<M::linear>() = gravity;
    if constexpr (M::angular == 3) {  // Euler's equations, I Ω̇ = IΩ × Ω in the body's axes
      const Eigen::Quaterniond& q = bodies.pose[i].rotation;
      const Eigen::Vector3d &inverse_moments = bodies.inverse_mass[i].angular,
                            spin = rotate(inverse(q), bodies.velocity[i].template tail<3>());
      const Eigen::Vector3d momentum = spin.cwiseQuotient(inverse_moments);
      a.template tail<3>() = rotate(q, momentum.cross(spin).cwiseProduct(inverse_moments));
    }
  }
}

namespace {

/// A stage of an explicit Runge–Kutta rule: what share its slope has in the whole step's, and how much of a step
/// to the next stage is made along it.
struct Stage {
  double weight, to_next;
};
inline constexpr Stage euler_stages[] = {{1, 0}};
inline constexpr Stage rk4_stages[] = {{1.0 / 6, 0.5}, {1.0 / 3, 0.5}, {1.0 / 3, 1}, {1.0 / 6, 0}};

/// A pose and velocity `time` [s] along a slope.
template <class M>
void go_along(const Slope<M>& slope, double time, const Pose<M>& from, const Velocity<M>& from_velocity,
              Pose<M>& pose, Velocity<M>& velocity) {
  velocity = from_velocity + time * slope.acceleration;
  if constexpr (M::angular == 3) {
    pose.position = from.position + time * slope.velocity.template head<3>();
    pose.rotation.coeffs() = (from.rotation.coeffs() + time * slope.turning).normalized();
  } else {
    pose = moved<M, double>(from, slope.velocity, time);
  }
}

/// Notes a stage's slope and forces with their weight, and goes on to the next stage if there is one.
template <class M>
void add_stage(const Stage& stage, Bodies<M>& bodies, AccelerationsWork<M>& work) {
  for (std::size_t row = 0; row < work.change.size(); ++row)
    work.system.lambda[row] += stage.weight * work.h * work.change[row];
  for (int i = 0; i < bodies.size(); ++i) {
    if (!moves(bodies.inverse_mass[i])) continue;
    Slope<M> slope{bodies.velocity[i], work.accelerated.velocity[i]};
    if constexpr (M::angular == 3)
      slope.turning = turning(bodies.pose[i].rotation, slope.velocity.template tail<3>()).coeffs();
    Slope<M>& sum = work.sum[i];
    sum.velocity += stage.weight * slope.velocity;
    sum.acceleration += stage.weight * slope.acceleration;
    sum.turning += stage.weight * slope.turning;
    if (stage.to_next > 0)
      go_along(slope, stage.to_next * work.h, work.begin.pose[i], work.begin.velocity[i], bodies.pose[i],
               bodies.velocity[i]);
  }
}

/// From the beginning of the step along the sum of all stages.
template <class M>
void finish_stages(Bodies<M>& bodies, AccelerationsWork<M>& work) {
  for (int i = 0; i < bodies.size(); ++i)
    if (moves(bodies.inverse_mass[i]))
      go_along(work.sum[i], work.h, work.begin.pose[i], work.begin.velocity[i], bodies.pose[i],
               bodies.velocity[i]);
}

/// Puts the bodies into the middle of the step that the accelerations of `work` make; returns by how much their
/// velocities change at most [m/s, rad/s].
template <class M>
double go_to_middle(Bodies<M>& bodies, const AccelerationsWork<M>& work) {
  double largest = 0;
  for (int i = 0; i < bodies.size(); ++i) {
    if (!moves(bodies.inverse_mass[i])) continue;
    const Velocity<M> V = work.begin.velocity[i] + work.h / 2 * work.accelerated.velocity[i];
    const double change = (V - bodies.velocity[i]).cwiseAbs().maxCoeff();
    if (!(change <= largest)) largest = change;  // also where it is no number
    bodies.velocity[i] = V;
    bodies.pose[i] = moved<M, double>(work.begin.pose[i], V, work.h / 2);
  }
  return largest;
}

/// And to its end.
template <class M>
void go_to_end(Bodies<M>& bodies, AccelerationsWork<M>& work) {
  for (std::size_t row = 0; row < work.change.size(); ++row) work.system.lambda[row] = work.h * work.change[row];
  for (int i = 0; i < bodies.size(); ++i) {
    if (!moves(bodies.inverse_mass[i])) continue;
    bodies.pose[i] = moved<M, double>(work.begin.pose[i], bodies.velocity[i], work.h);
    bodies.velocity[i] = work.begin.velocity[i] + work.h * work.accelerated.velocity[i];
  }
}

//! [accelerate]
/// V̇ of all bodies into `work.accelerated`, and f [N, or what is conjugate to C] into `work.change`.
template <class M>
void accelerate(const Scene<M>& scene, double regularisation, AccelerationsWork<M>& work) {
  const Bodies<M>& bodies = scene.bodies();
  scene.write_rows(work.system, work.h);  // J and M⁻¹Jᵀ
  for (int i = 0; i < bodies.size(); ++i) work.paths[i] = on_its_way<M>(bodies.pose[i], bodies.velocity[i]);
  scene.write_bias_accelerations(work.system, work.paths, work.offset);  // J̇V
  write_free_accelerations(bodies, scene.gravity, work.accelerated);
  solve_rows(regularisation, work.accelerated, work);              // f
  apply_all(work.system, work.change, work.accelerated.velocity);  // M⁻¹F + M⁻¹Jᵀf
}
//! [accelerate]

//! [runge_kutta]
/// One substep by an explicit rule whose stages need only the one before.
template <class M>
void runge_kutta(Scene<M>& scene, std::span<const Stage> stages, double regularisation,
                 AccelerationsWork<M>& work) {
  std::fill(work.sum.begin(), work.sum.end(), Slope<M>());
  for (const Stage& stage : stages) {
    accelerate(scene, regularisation, work);
    add_stage(stage, scene.state(), work);
  }
  finish_stages(scene.state(), work);
}
//! [runge_kutta]

//! [midpoint]
/// One substep by the implicit midpoint rule, to rounding.
template <class M>
void implicit_midpoint(Scene<M>& scene, double regularisation, AccelerationsWork<M>& work) {
  Convergence convergence(1e-9);  // [m/s, rad/s]
  do accelerate(scene, regularisation, work);
  while (!convergence.reached(go_to_middle(scene.state(), work)));
  go_to_end(scene.state(), work);
}
//! [midpoint]

}  // namespace

template <class M>
void advance(Scene<M>& scene, const Accelerations& family, double step, AccelerationsWork<M>& work) {
  require_steppable(scene, family, step);
  begin_equalities(scene, step / family.substeps, work);
  work.paths.resize(scene.bodies().size());
  work.sum.resize(scene.bodies().size());
  for (int i = 0; i < family.substeps; ++i) {
    work.begin = scene.bodies();
    std::fill(work.system.lambda.begin(), work.system.lambda.end(), 0.0);
    or_back_to(work.begin, scene.state(), [&] {
      switch (family.scheme) {
        case Scheme::explicit_euler: return runge_kutta(scene, euler_stages, family.regularisation, work);
        case Scheme::rk4: return runge_kutta(scene, rk4_stages, family.regularisation, work);
        case Scheme::implicit_midpoint: return implicit_midpoint(scene, family.regularisation, work);
      }
    });
  }
}

#define BYHAND_INSTANTIATE(M)                                                             \
  template void write_free_accelerations(const Bodies<M>&, const Linear<M>&, Bodies<M>&); \
  template void advance(Scene<M>&, const Accelerations&, double, AccelerationsWork<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
