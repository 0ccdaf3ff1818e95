#pragma once

#include "lessons/methods/equalities.hpp"

// RATTLE: leapfrog that ends each step on C = 0 and on JV = 0, both to rounding.
//
//   V½ = V₀ + ½h g + M⁻¹J(x₀)ᵀλ,   x₁ = x₀ moved by V½ for h,   with λ such that C(x₁) = 0
//   V₁ = V½ + ½h g + M⁻¹J(x₁)ᵀμ                                 with μ such that J(x₁)V₁ = 0
//
// λ is found by Newton's method with the matrix kept at x₀, JM⁻¹Jᵀ δ = -C(x₁)/h, so that one factor serves all
// corrections; each leaves the share of the error by which J turns in a step. The factor at x₁, which gives μ, is
// also the next substep's. Between the kicks a body in space turns freely by the implicit rule of gyroscopic.hpp.
// Without damping all of it is symmetric: the step is time-reversible, of order 2, its energy error stays bounded,
// and it keeps momentum. Damping acts at the start of each half, which makes the step of order 1.
//
// Cost of a substep: rows written and solved directly once, and some back-substitutions; once more at the start of
// a step, for the scene may have changed. Sources: H. C. Andersen, Rattle: a "velocity" version of the Shake
// algorithm, J. Comput. Phys. 52, 1983; B. Leimkuhler and R. D. Skeel, Symplectic numerical integrators in
// constrained Hamiltonian systems, J. Comput. Phys. 112, 1994.
namespace byhand {

struct Rattle {
  static constexpr const char* name = "RATTLE";

  template <class M>
  struct Work : EqualitiesWork<M> {
    std::vector<Velocity<M>> kicked;  // V½
  };

  int substeps = 1;           // >= 1
  double regularisation = 0;  // as of Direct
};

inline void require_valid(const Rattle& method) {
  require_valid_equalities(method.substeps, method.regularisation);
}
template <class M>
std::string refusal(const Scene<M>& scene, const Rattle&) {
  return refusal_unless_equalities(scene, Rattle::name);
}

/// Throws also SingularSystem for repeated rows, NoConvergence for a step in which C = 0 cannot be reached.
template <class M>
void advance(Scene<M>& scene, const Rattle& method, double step, Rattle::Work<M>& work);

// Its parts, for methods that choose their substeps.

/// Writes and factors the rows; finds the impulses that would make JV = 0.
template <class M>
void factor_rows(const Scene<M>& scene, double regularisation, Rattle::Work<M>& work);
/// One substep `work.h` [s] from `work.begin`. The rows are written and factored at its start and again at its
/// end.
template <class M>
void rattle(Scene<M>& scene, double regularisation, Rattle::Work<M>& work);
/// Puts the bodies where C = 0 and JV = 0, and factors the rows there.
template <class M>
void meet_constraints(Scene<M>& scene, double regularisation, Rattle::Work<M>& work);

}  // namespace byhand
