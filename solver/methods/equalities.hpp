#pragma once

#include <cmath>
#include <limits>
#include <stdexcept>

#include "solver/direct/direct.hpp"
#include "solver/methods/step_work.hpp"

// What methods share that hold every constraint exactly, as differential-algebraic equations: they run scenes of
// equalities, M V̇ = F + Jᵀf with C = 0, and no others.
namespace byhand {

/// What they keep between steps. λ/h is the force in the middle of a substep, to second order.
template <class M>
struct EqualitiesWork : StepWork<M> {
  DirectWork<M> direct;
  std::vector<double> offset, change;  // by row
  Bodies<M> begin;                     // of the substep
};

/// Thrown where the equations of an implicit step have no solution that its iteration comes to.
struct NoConvergence : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Why `method` cannot run this scene, in one sentence; empty where it can.
template <class M>
std::string refusal_unless_equalities(const Scene<M>& scene, const std::string& method);

/// Begins a step: lays the rows out in the order of elimination if the scene has changed.
template <class M>
void begin_equalities(const Scene<M>& scene, double h, EqualitiesWork<M>& work);

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
