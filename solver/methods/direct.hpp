#pragma once

#include <stdexcept>

#include "solver/graph.hpp"
#include "solver/methods/prepared.hpp"

namespace byhand {

/// How the matrix of all rows is factored: along the scene's graph, in time proportional to its size on
/// chains, trees and stars; or as one dense matrix, the reference.
enum class Factorisation { structured, dense };

/// All rows at once and exactly: (JM⁻¹Jᵀ + γ)λ = -(JV + b). For rows without bounds.
struct Direct {
  Factorisation factorisation = Factorisation::structured;
  double regularisation = 0;  // >= 0: this share of each row's own JM⁻¹Jᵀ is added to its γ
};

/// Throws std::invalid_argument for a choice outside the ranges above.
void require_valid(const Direct& solver);

/// Thrown where rows repeat or contradict each other and no softness or regularisation decides between them.
struct SingularSystem : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What the direct solve keeps: the plan while the graph stays, and scratch so that no step allocates.
template <class M>
struct DirectWork {
  struct View {
    const double *J, *W;  // rows × 2 dof, row-major
    int row, body1, body2;
    bool folded1, folded2;
  };
  Elimination plan;
  std::vector<double> values, unknowns, diagonal;
  std::vector<View> views;  // by node
};

/// Solves the system's rows for λ and puts the impulses into the velocities; what λ was before does not
/// matter. The system must be laid out in the order of `work.plan`. Throws SingularSystem, and leaves the
/// velocities alone then.
template <class M>
void solve(const Direct& solver, System<M>& system, Bodies<M>& bodies, DirectWork<M>& work);

}  // namespace byhand
