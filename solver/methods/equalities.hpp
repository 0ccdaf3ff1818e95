#pragma once

#include <limits>
#include <stdexcept>
#include <string>

#include "solver/integrate/euler.hpp"
#include "solver/methods/direct.hpp"
#include "solver/scene.hpp"

// What methods share that hold every constraint exactly, as differential-algebraic equations: they run scenes of
// equalities, M V̇ = F + Jᵀf with C = 0, and no others.
namespace byhand {

/// What they keep between steps. λ of `system` is the impulse over the last substep, so λ/h is the mean force in
/// it: the force in its middle, to second order.
template <class M>
struct EqualitiesWork {
  System<M> system;
  DirectWork<M> direct;
  std::vector<double> offset, change;  // by row
  Bodies<M> begin;                     // of the substep
  int version = 0;                     // of the scene that is laid out
  double h = 0;                        // the last substep [s]
  long long row_solves = 0;            // so far; see direct_row_solves
};

/// Thrown where the equations of an implicit step have no solution that its iteration comes to.
struct NoConvergence : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Why `method` cannot run this scene, in one sentence; empty where it can.
template <class S>
std::string refusal_unless_equalities(const S& scene, std::string_view method) {
  std::string reason;
  if constexpr (S::touches)
    if (!scene.colliders.shapes.empty())
      reason = fmt::format("{} knows no contacts, and this scene has bodies that may touch", method);
  int number = 0;
  scene.for_each([&](const auto& constraint) {
    using Kind = std::remove_cvref_t<decltype(constraint)>;
    if (!reason.empty()) return;
    if constexpr (Kind::bound != Bound::none)
      reason = fmt::format("{} holds equalities alone, and constraint {} is bounded", method, number);
    else if constexpr (Kind::drifting < Kind::rows)
      reason = fmt::format("{} holds equalities alone, and constraint {} is a spring", method, number);
    else if (constraint.softness > 0)
      reason = fmt::format("{} holds constraints exactly, and constraint {} is soft: it gives way by {} in a step",
                           method, number, constraint.softness);
    ++number;
  });
  return reason;
}

/// What every step of theirs begins with: refuses bad input, and lays the rows out anew if constraints were added.
template <class S, class Family, class M = typename S::model>
void begin_step(const S& scene, const Family& family, double step, EqualitiesWork<M>& work) {
  require_steppable(scene, family, step);
  work.h = step / family.substeps;
  if (work.version == scene.version()) return;
  work.version = scene.version();
  work.direct.plan = plan_elimination(scene.graph(), M::dof);
  scene.lay_out(work.direct.plan.order, work.system);
  work.direct.views.clear();
  for (auto* numbers : {&work.offset, &work.change}) numbers->assign(work.system.rows(), 0.0);
}

/// x of JM⁻¹Jᵀ x = -(JV + offset) into `work.change`, for the V of `bodies`.
template <class M>
void solve_rows(double regularisation, const Bodies<M>& bodies, EqualitiesWork<M>& work);

/// Calls f; if that throws, the bodies are where `begin` says.
template <class M, class F>
void or_back_to(const Bodies<M>& begin, Bodies<M>& bodies, F&& f) {
  try {
    f();
  } catch (...) {
    bodies.pose = begin.pose;
    bodies.velocity = begin.velocity;
    throw;
  }
}

/// Watches an iteration whose errors shrink: it has to come down to `enough`, and goes on until nothing is gained
/// any more but rounding.
class Convergence {
 public:
  explicit Convergence(double enough) : enough_(enough) {}

  /// Whether the iteration is done. Throws NoConvergence after a hundred errors, or for one that is no number.
  bool reached(double error) {
    if (error == 0 || (error <= enough_ && error > 0.9 * last_)) return true;
    if (++count_ == 100 || !std::isfinite(error))
      throw NoConvergence(
          "the equations of an implicit step were not solved in 100 iterations; take a smaller step");
    last_ = error;
    return false;
  }

 private:
  double enough_, last_ = std::numeric_limits<double>::infinity();
  int count_ = 0;
};

}  // namespace byhand
