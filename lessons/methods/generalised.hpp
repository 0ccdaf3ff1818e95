#pragma once

#include <array>

#include "lessons/methods/equalities.hpp"
#include "lessons/methods/generalised_joints.hpp"

// Generalised coordinates: only numbers that the joints leave free are integrated, one a hinge, and no constraint
// is solved for. For a tree of joints (generalised_joints.hpp), with V of the bodies' centres, each joint says
//
//   V_c = X V_p + S q̇,    V̇_c = X V̇_p + S q̈ + c,
//
// where X carries the motion of the parent on, S that of the joint itself, and c has the terms that are quadratic
// in velocities. Newton's law for all bodies below a joint together is f = A V̇_c + p, with the articulated inertia
// A, and the force f that the joint exerts does no work along S:
//
//   0 = Sᵀf    so    q̈ = -(SᵀAS)⁻¹ Sᵀ(A (X V̇_p + c) + p)
//
// which leaves f = Ā X V̇_p + p̄ for the parent to carry: A_p += XᵀĀX, p_p += Xᵀp̄. Once from the leaves to the
// roots, and once back with V̇: the cost is proportional to the number of joints, and the rows of A = JM⁻¹Jᵀ never
// appear. Source: R. Featherstone, Rigid Body Dynamics Algorithms, 2008, §7.3.
//
//   semi_implicit_euler   q̇₁ = q̇₀ + h q̈(q₀, q̇₀), q₁ = q₀ moved by q̇₁ for h. Order 1.
//   rk4                   the classical rule. Order 4.
//
// In space orientations are integrated as quaternions, and a rod's direction as a vector, each scaled to unit
// length at every stage. A joint counts as a row-solve in each slope, and as a prepared row in each step.
namespace byhand {

enum class JointRule { semi_implicit_euler, rk4 };

struct Generalised {
  static constexpr const char* name = "a method in generalised coordinates";
  static constexpr int most_stages = 6;

  /// How a joint's numbers change; in space q̇ says how the rotation turns.
  template <class M>
  struct Slope {
    Velocity<M> rate = Velocity<M>::Zero(), acceleration = Velocity<M>::Zero();
    Packed<double, M::angular == 3 ? 4 : 0, 1> turning = decltype(turning)::Zero();
  };
  /// A body with all below it, and what of its joint the way back needs.
  template <class M>
  struct Articulated {
    Packed<double, M::dof, M::dof> A;             // [kg, kg m, kg m²]
    Velocity<M> p, c;                             // [N, N m], [m/s², rad/s²]
    Packed<double, M::dof, M::dof> S, K;          // S and AS(SᵀAS)⁻¹, in their first columns
    Velocity<M> rest;                             // (SᵀAS)⁻¹Sᵀ(Ac + p), in its first numbers
    Packed<double, M::linear, M::angular> reach;  // X: what ω of the parent adds to v
    bool carries = false;                         // X: whether ω of the parent is added to ω
  };
  template <class M>
  struct Work : StepWork<M> {
    std::vector<Joint<M>> joints;  // parents first
    std::vector<JointState<M>> begin, state;
    std::vector<JointFrame<M>> frame;
    std::vector<Articulated<M>> part;       // by body
    std::vector<Velocity<M>> acceleration;  // by body
    std::array<std::vector<Slope<M>>, most_stages> slope;
    State<M> other;  // of the bodies, by the formula of order 5
  };

  JointRule rule = JointRule::rk4;
  int substeps = 1;  // >= 1
};

inline void require_valid(const Generalised& method) { require_valid_equalities(method.substeps, 0); }
template <class M>
std::string refusal(const Scene<M>& scene, const Generalised&) {
  const std::string reason = refusal_unless_equalities(scene, Generalised::name);
  return reason.empty() ? refusal_unless_tree(scene) : reason;
}

/// A gap that a joint has at the start is closed.
template <class M>
void advance(Scene<M>& scene, const Generalised& method, double step, Generalised::Work<M>& work);

// Its parts, for methods that choose their substeps.

/// Lays the joints out if the scene has changed, and reads their numbers. Throws std::invalid_argument unless they
/// are a tree.
template <class M>
void read_joints(const Scene<M>& scene, Generalised::Work<M>& work);
/// One substep h [s] by Fehlberg's formula of order 4, begun at `time` [s] after the start of the whole; `again`
/// if it begins where the last one did. Returns the largest displacement of a body from where the formula of order
/// 5 puts it, and what the difference of velocities adds to that in as long a time [m].
template <class M>
double fehlberg(Scene<M>& scene, double time, double h, bool again, Generalised::Work<M>& work);

}  // namespace byhand
