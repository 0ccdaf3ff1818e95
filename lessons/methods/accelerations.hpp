#pragma once

#include "lessons/methods/equalities.hpp"
#include "solver/integrate/jet.hpp"

// Constraints as accelerations: differentiated twice, C = 0 becomes linear in what Newton's law gives,
//
//   M V̇ = F + Jᵀf,   C̈ = J V̇ + J̇V = 0    so    JM⁻¹Jᵀ f = -(J M⁻¹F + J̇V),
//
// which is (17) with M⁻¹F in place of V, J̇V in place of b, and a force f in place of an impulse. F is the weight
// and, for a body in space, -ω × Iω. Any rule integrates these ordinary differential equations (of index 1). The
// forces are exact, but only C̈ = 0 is enforced, not C = 0: the error of a rule stays and grows as t².
//
//   explicit Euler     x₁ = x₀ + hv₀, v₁ = v₀ + ha(x₀, v₀). Order 1, gains energy.
//   RK4                the classical rule of four stages; in space on the quaternion's four numbers, q̇ = ½ωq,
//                      scaled to unit length at every stage and at the end. Order 4.
//   implicit midpoint  V_m = V₀ + ½h a(X_m, V_m), X_m half a step along V_m; V₁ = V₀ + h a, X₁ a whole step along
//                      V_m. By fixed-point iteration. Symmetric. Of particles on rods the errors of energy and C
//                      stay small for some twenty periods and grow then (lesson 9); of bodies that turn they grow
//                      as t² from the start, for C̈ = 0 is kept to second order only.
//                      Order 2.
//
// Cost of a substep: rows written and solved directly 1, 4, or as often as the iteration takes.
// Source: E. Hairer and G. Wanner, Solving Ordinary Differential Equations II, §VII.1.
namespace byhand {

enum class Scheme { explicit_euler, rk4, implicit_midpoint };

/// How a body's state changes: Ẋ and V̇. In space q̇ says how the pose turns.
template <class M>
struct Slope {
  Velocity<M> velocity = Velocity<M>::Zero(), acceleration = Velocity<M>::Zero();
  Eigen::Matrix<double, M::angular == 3 ? 4 : 0, 1> turning = decltype(turning)::Zero();
};

struct Accelerations {
  template <class M>
  struct Work : EqualitiesWork<M> {
    std::vector<Pose<M, Jet>> paths;  // by body
    Bodies<M> accelerated;            // poses, and accelerations in place of velocities
    std::vector<Slope<M>> sum;        // by body, over stages
  };

  Scheme scheme = Scheme::rk4;
  int substeps = 1;           // >= 1
  double regularisation = 0;  // as of Direct
};

inline void require_valid(const Accelerations& method) {
  require_valid_equalities(method.substeps, method.regularisation);
}
template <class M>
std::string refusal(const Scene<M>& scene, const Accelerations&) {
  return refusal_unless_equalities(scene, "integration of accelerations");
}

/// Throws also SingularSystem for repeated rows, NoConvergence for an implicit step that is too long.
template <class M>
void advance(Scene<M>& scene, const Accelerations& method, double step, Accelerations::Work<M>& work);

}  // namespace byhand
