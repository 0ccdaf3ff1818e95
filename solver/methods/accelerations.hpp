#pragma once

#include "solver/integrate/jet.hpp"
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
template <class M>
std::string refusal(const Scene<M>& scene, const Accelerations&) {
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

/// One time step [s]. Throws std::invalid_argument for step <= 0, a family outside its range or a scene that it
/// refuses; SingularSystem for rows that repeat; NoConvergence for an implicit step that is too long. The bodies
/// then are where the substep began.
template <class M>
void advance(Scene<M>& scene, const Accelerations& family, double step, AccelerationsWork<M>& work);

}  // namespace byhand
