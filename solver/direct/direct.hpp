#pragma once

#include <stdexcept>

#include "solver/rows/row_solver.hpp"

namespace byhand {

template <class M>
struct DirectWork;

/// How the matrix of all rows is factored: along the scene's graph, in time proportional to its size on chains,
/// trees and stars; or as one dense matrix, the reference.
enum class Factorisation { structured, dense };

/// Solves all rows exactly: (JM⁻¹Jᵀ + γ)λ = -(JV + b).
///
/// Bounds are kept by an active set: the rows that are not at a bound are solved, λ is clamped to its bounds, and
/// sweeps of Gauss–Seidel find what else changes. This repeats until one of them is within the tolerance; after
/// `rounds`, sweeps alone finish the solve.
struct Direct {
  Factorisation factorisation = Factorisation::structured;
  double regularisation = 0;  // >= 0: this share of each row's own JM⁻¹Jᵀ is added to its γ
  int rounds = 20;            // >= 1, with bounds
  double tolerance = 1e-10;   // with bounds, in (0, 1]: the largest residual, as a share of the largest λ
  double smallest_pivot =
      1e-13;  // in [0, 1]: a pivot below this share of its row's diagonal is taken for rounding

  template <class M>
  using Work = DirectWork<M>;
  Layout layout() const {
    return factorisation == Factorisation::structured ? Layout::elimination : Layout::natural;
  }
  template <class M>
  std::vector<int> order(const Graph& graph, DirectWork<M>& work) const;
  /// The system must be laid out in the order of `work.plan`. Throws SingularSystem, which without bounds leaves
  /// the velocities unchanged.
  template <class M>
  Solution solve(System<M>& system, Bodies<M>& bodies, DirectWork<M>& work, Begin begin = Begin::step) const;
};

/// Throws std::invalid_argument for a choice outside the ranges above.
inline void require_valid(const Direct& solver) {
  require_in("regularisation", solver.regularisation, 0, 1);
  require(solver.rounds >= 1, "number of rounds", solver.rounds, "at least 1");
  require(solver.tolerance > 0 && solver.tolerance <= 1, "tolerance", solver.tolerance, "above 0 and at most 1");
  require_in("smallest pivot", solver.smallest_pivot, 0, 1);
}

/// Thrown where rows repeat or contradict each other and neither softness nor regularisation decides between them.
struct SingularSystem : std::runtime_error {
  using std::runtime_error::runtime_error;
};
}  // namespace byhand
