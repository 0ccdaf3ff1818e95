#pragma once

#include "solver/integrate/gyroscopic.hpp"
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
template <class S>
std::string refusal(const S& scene, const Rattle&) {
  return refusal_unless_equalities(scene, "RATTLE");
}

template <class M>
struct RattleWork : EqualitiesWork<M> {
  std::vector<Velocity<M>> kicked;  // V½
};

/// The bodies where they come to from the beginning of the substep with the velocities `kicked`.
template <class M>
void move_kicked(Bodies<M>& bodies, const RattleWork<M>& work);

/// C/h of every row, as offsets; returns the largest |C|.
template <class S, class M = typename S::model>
double write_errors(const S& scene, RattleWork<M>& work) {
  double largest = 0;
  int number = 0;
  scene.for_each([&](const auto& constraint) {
    using Kind = std::remove_cvref_t<decltype(constraint)>;
    if constexpr (Kind::bound == Bound::none && Kind::drifting == Kind::rows) {
      const Rows<Kind::rows> C = constraint.template value<double>(scene.bodies.pose[constraint.at.body1],
                                                                   scene.bodies.pose[constraint.at.body2]);
      for (int k = 0; k < Kind::rows; ++k) {
        if (!(std::abs(C[k]) <= largest)) largest = std::abs(C[k]);  // also where it is no number
        work.offset[work.system.row_of[number] + k] = C[k] / work.h;
      }
    }
    ++number;
  });
  return largest;
}

/// Corrects λ and the kicked velocities by the errors that stand as offsets.
template <class M>
void correct_kick(RattleWork<M>& work);

/// Factors the rows as they are written, and finds the impulses that would leave JV = 0.
template <class M>
void factor_rows(const Bodies<M>& bodies, double regularisation, RattleWork<M>& work);
/// Puts those impulses into V, and to λ.
template <class M>
void stop_rates(Bodies<M>& bodies, RattleWork<M>& work);

//! [rattle]
/// One substep from rows that are written and factored at its beginning, and leaves them so at its end.
template <class S, class M = typename S::model>
void rattle(S& scene, const Rattle& family, RattleWork<M>& work) {
  std::fill(work.system.lambda.begin(), work.system.lambda.end(), 0.0);
  add_gravity(scene.bodies, scene.gravity, work.h / 2);
  work.kicked = scene.bodies.velocity;
  Convergence convergence(1e-9);  // [units of C]
  for (move_kicked(scene.bodies, work); !convergence.reached(write_errors(scene, work));
       move_kicked(scene.bodies, work))
    correct_kick(work);
  end_turn(Gyroscopic::implicit, scene.bodies, work.h);
  scene.write_rows(work.system, work.h);
  add_gravity(scene.bodies, scene.gravity, work.h / 2);
  factor_rows(scene.bodies, family.regularisation, work);
  stop_rates(scene.bodies, work);
}
//! [rattle]

/// One time step [s]. Throws std::invalid_argument for step <= 0, a family outside its range or a scene that it
/// refuses; SingularSystem for rows that repeat; NoConvergence for a step in which C = 0 cannot be reached. The
/// bodies then are where the substep began.
template <class S, class M = typename S::model>
void advance(S& scene, const Rattle& family, double step, RattleWork<M>& work) {
  begin_step(scene, family, step, work);
  scene.write_rows(work.system, work.h);
  factor_rows(scene.bodies, family.regularisation, work);
  for (int i = 0; i < family.substeps; ++i) {
    work.begin = scene.bodies;
    or_back_to(work.begin, scene.bodies, [&] { rattle(scene, family, work); });
  }
}

}  // namespace byhand
