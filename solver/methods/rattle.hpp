#pragma once

#include "solver/methods/equalities.hpp"

// RATTLE: leapfrog that ends each step on C = 0 and on JV = 0, both to rounding.
//
//   V½ = V₀ + ½h g + M⁻¹J(x₀)ᵀλ,   x₁ = x₀ moved by V½ for h,   with λ such that C(x₁) = 0
//   V₁ = V½ + ½h g + M⁻¹J(x₁)ᵀμ                                 with μ such that J(x₁)V₁ = 0
//
// λ is found by Newton's method with the matrix left at x₀: each correction solves JM⁻¹Jᵀ δ = -C(x₁)/h, where the
// true one has J(x₁) on the left. What remains of an error is therefore the share by which J turns in a step, and
// one factor serves all corrections. That at x₁, which gives μ, is the next substep's.
//
// Between the two kicks a body in space turns freely by the implicit rule of gyroscopic.hpp, which is symmetric as
// the rest is. So the whole runs backwards as it ran forwards, is of order 2, and its energy error stays bounded
// for ever; momentum is kept where the constraints keep it, for λ and μ act along J.
//
// Cost of a substep: rows written and solved directly once, and some back-substitutions; once more at the
// beginning of a step, whose scene may have been changed.
// (Source: H. C. Andersen, Rattle: a "velocity" version of the Shake algorithm, J. Comput. Phys. 52, 1983;
// B. Leimkuhler and R. D. Skeel, Symplectic numerical integrators in constrained Hamiltonian systems, J. Comput.
// Phys. 112, 1994.)
namespace byhand {

template <class M>
struct RattleWork;

struct Rattle {
  template <class M>
  using Work = RattleWork<M>;

  int substeps = 1;           // >= 1
  double regularisation = 0;  // >= 0, as of Direct
};

/// Throws std::invalid_argument for a choice outside its range.
void require_valid(const Rattle& family);

/// Why this scene cannot be run so, in one sentence; empty where it can.
template <class M>
std::string refusal(const Scene<M>& scene, const Rattle&) {
  return refusal_unless_equalities(scene, "RATTLE");
}

template <class M>
struct RattleWork : EqualitiesWork<M> {
  std::vector<Velocity<M>> kicked;  // V½
};

/// One time step [s]. Throws std::invalid_argument for step <= 0, a family outside its range or a scene that it
/// refuses; SingularSystem for rows that repeat; NoConvergence for a step in which C = 0 cannot be reached. The
/// bodies then are where the substep began.
template <class M>
void advance(Scene<M>& scene, const Rattle& family, double step, RattleWork<M>& work);

}  // namespace byhand
