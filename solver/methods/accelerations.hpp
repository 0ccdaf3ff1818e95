#pragma once

#include "solver/jet.hpp"
#include "solver/methods/equalities.hpp"

// Constraints as accelerations: differentiated twice, C = 0 becomes linear in what Newton's law gives,
//
//   M V̇ = F + Jᵀf,   C̈ = J V̇ + J̇V = 0    so    JM⁻¹Jᵀ f = -(J M⁻¹F + J̇V),
//
// which is (17) once more, with M⁻¹F in place of V, J̇V in place of b, and a force f in place of an impulse. F is
// weight and, of a body in space, -ω × Iω. These are ordinary differential equations (of index 1), and any rule
// integrates them; but C = 0 is no longer asked for, only C̈ = 0, so what a rule gets wrong stays and grows as t².
// The rows' pulls are the one thing that is exact.
//
//   explicit Euler     x₁ = x₀ + hv₀, v₁ = v₀ + ha(x₀, v₀)                                   order 1, gains energy
//   RK4                the classical rule of four stages; in space on the quaternion's four numbers, q̇ = ½ωq,
//                      at unit length wherever a is asked for and at the end                  order 4
//   implicit midpoint  V_m = V₀ + ½h a(X_m, V_m), X_m half a step along V_m; V₁ = V₀ + h a, X₁ a whole step along
//                      V_m. By fixed-point iteration. Symmetric, so energy and C stay bounded order 2
//
// Cost of a substep: rows written and solved directly 1, 4, or as often as the iteration takes.
// (Source: E. Hairer and G. Wanner, Solving Ordinary Differential Equations II, §VII.1.)
namespace byhand {

enum class Scheme { explicit_euler, rk4, implicit_midpoint };

template <class M>
struct AccelerationsWork;

struct Accelerations {
  template <class M>
  using Work = AccelerationsWork<M>;

  Scheme scheme = Scheme::rk4;
  int substeps = 1;           // >= 1
  double regularisation = 0;  // >= 0, as of Direct
};

/// Throws std::invalid_argument for a choice outside its range.
void require_valid(const Accelerations& family);

/// Why this scene cannot be run so, in one sentence; empty where it can.
template <class S>
std::string refusal(const S& scene, const Accelerations&) {
  return refusal_unless_equalities(scene, "integration of accelerations");
}

/// How a body's state changes: Ẋ and V̇. In space q̇ tells how the pose turns.
template <class M>
struct Slope {
  Velocity<M> velocity = Velocity<M>::Zero(), acceleration = Velocity<M>::Zero();
  Eigen::Matrix<double, M::angular == 3 ? 4 : 0, 1> turning = decltype(turning)::Zero();
};

template <class M>
struct AccelerationsWork : EqualitiesWork<M> {
  std::vector<Pose<M, Jet>> paths;  // by body
  Bodies<M> accelerated;            // poses, and accelerations in the place of velocities
  std::vector<Slope<M>> sum;        // by body, over stages
};

/// M⁻¹F of every body at its pose and velocity [m/s², rad/s²].
template <class M>
void write_free_accelerations(const Bodies<M>& bodies, const Linear<M>& gravity, Bodies<M>& accelerated);

/// J̇V of every row, as offsets.
template <class S, class M = typename S::model>
void write_bias_accelerations(const S& scene, AccelerationsWork<M>& work) {
  for (int i = 0; i < scene.bodies.size(); ++i)
    work.paths[i] = on_its_way<M>(scene.bodies.pose[i], scene.bodies.velocity[i]);
  int number = 0;
  scene.for_each([&](const auto& constraint) {
    using Kind = std::remove_cvref_t<decltype(constraint)>;
    if constexpr (Kind::bound == Bound::none && Kind::drifting == Kind::rows) {
      const auto [body1, body2] = std::pair(constraint.at.body1, constraint.at.body2);
      Eigen::Map<Rows<Kind::rows>>(&work.offset[work.system.row_of[number]]) =
          bias_acceleration<Kind, M>(constraint, work.paths[body1], work.paths[body2]);
    }
    ++number;
  });
}

//! [accelerate]
/// V̇ of all bodies into `work.accelerated`, and f [N, or what is conjugate to C] into `work.change`.
template <class S, class M = typename S::model>
void accelerate(const S& scene, double regularisation, AccelerationsWork<M>& work) {
  scene.write_rows(work.system, work.h);  // J and M⁻¹Jᵀ
  write_bias_accelerations(scene, work);  // J̇V
  write_free_accelerations(scene.bodies, scene.gravity, work.accelerated);
  solve_rows(regularisation, work.accelerated, work);              // f
  apply_all(work.system, work.change, work.accelerated.velocity);  // M⁻¹F + M⁻¹Jᵀf
}
//! [accelerate]

/// A stage of an explicit Runge–Kutta rule: what share its slope has in the whole step's, and how much of a step
/// to the next stage is made along it.
struct Stage {
  double weight, to_next;
};
inline constexpr Stage euler_stages[] = {{1, 0}};
inline constexpr Stage rk4_stages[] = {{1.0 / 6, 0.5}, {1.0 / 3, 0.5}, {1.0 / 3, 1}, {1.0 / 6, 0}};

/// Notes a stage's slope and forces with their weight, and goes on to the next stage if there is one.
template <class M>
void add_stage(const Stage& stage, Bodies<M>& bodies, AccelerationsWork<M>& work);
/// From the beginning of the step along the sum of all stages.
template <class M>
void finish_stages(Bodies<M>& bodies, AccelerationsWork<M>& work);

//! [runge_kutta]
/// One substep by an explicit rule whose stages need only the one before.
template <class S, class M = typename S::model>
void runge_kutta(S& scene, std::span<const Stage> stages, double regularisation, AccelerationsWork<M>& work) {
  std::fill(work.sum.begin(), work.sum.end(), Slope<M>());
  for (const Stage& stage : stages) {
    accelerate(scene, regularisation, work);
    add_stage(stage, scene.bodies, work);
  }
  finish_stages(scene.bodies, work);
}
//! [runge_kutta]

/// Puts the bodies into the middle of the step that the accelerations of `work` make; returns by how much their
/// velocities change at most [m/s, rad/s].
template <class M>
double go_to_middle(Bodies<M>& bodies, const AccelerationsWork<M>& work);
/// And to its end.
template <class M>
void go_to_end(Bodies<M>& bodies, AccelerationsWork<M>& work);

//! [midpoint]
/// One substep by the implicit midpoint rule, to rounding.
template <class S, class M = typename S::model>
void implicit_midpoint(S& scene, double regularisation, AccelerationsWork<M>& work) {
  Convergence convergence(1e-9);  // [m/s, rad/s]
  do accelerate(scene, regularisation, work);
  while (!convergence.reached(go_to_middle(scene.bodies, work)));
  go_to_end(scene.bodies, work);
}
//! [midpoint]

/// One time step [s]. Throws std::invalid_argument for step <= 0, a family outside its range or a scene that it
/// refuses; SingularSystem for rows that repeat; NoConvergence for an implicit step that is too long. The bodies
/// then are where the substep began.
template <class S, class M = typename S::model>
void advance(S& scene, const Accelerations& family, double step, AccelerationsWork<M>& work) {
  begin_step(scene, family, step, work);
  work.paths.resize(scene.bodies.size());
  work.sum.resize(scene.bodies.size());
  for (int i = 0; i < family.substeps; ++i) {
    work.begin = scene.bodies;
    std::fill(work.system.lambda.begin(), work.system.lambda.end(), 0.0);
    or_back_to(work.begin, scene.bodies, [&] {
      switch (family.scheme) {
        case Scheme::explicit_euler: return runge_kutta(scene, euler_stages, family.regularisation, work);
        case Scheme::rk4: return runge_kutta(scene, rk4_stages, family.regularisation, work);
        case Scheme::implicit_midpoint: return implicit_midpoint(scene, family.regularisation, work);
      }
    });
  }
}

}  // namespace byhand
