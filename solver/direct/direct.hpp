#pragma once

#include <stdexcept>

#include "solver/direct/graph.hpp"
#include "solver/rows/gauss_seidel.hpp"

namespace byhand {

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
  double tolerance = 1e-10;   // with bounds, in (0, 1]: the largest residual, as a share of the largest push
  double smallest_pivot =
      1e-13;  // in [0, 1]: a pivot below this share of its row's diagonal is taken for rounding
};

/// Throws std::invalid_argument for a choice outside the ranges above.
void require_valid(const Direct& solver);

/// Thrown where rows repeat or contradict each other and neither softness nor regularisation decides between them.
struct SingularSystem : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// Throws that, or NotFinite with the names of bodies where a number is not finite.
template <class M>
[[noreturn]] void refuse_singular(const System<M>& system, const Bodies<M>& bodies);

/// The plan of the last layout, the last factor, and scratch that is kept so that no step allocates.
template <class M>
struct DirectWork {
  template <int K, Bound B>
  using BlockOf = Block<M, K, B>;
  struct View {
    const double *J, *W;  // rows × 2 dof, row-major
    int body1, body2;
  };

  Elimination plan;
  std::vector<double> values, unknowns, diagonal;
  std::vector<View> views;             // by edge, in the order of the plan
  std::vector<double> offset, change;  // b + γλ and Δλ, by row
  // Of rows with bounds:
  std::vector<char> active;     // by row: whether it is solved; empty if all are
  PerBlock<M, BlockOf> masked;  // bounded blocks without their inactive rows
  std::vector<Velocity<M>> velocity_before;
  std::vector<double> lambda_before;
};

/// Solves the system's rows for λ and applies the impulses. The system must be laid out in the order of
/// `work.plan`. Throws SingularSystem, which without bounds leaves the velocities unchanged.
template <class M>
Solution solve(const Direct& solver, System<M>& system, Bodies<M>& bodies, Prepared<M>& prepared,
               DirectWork<M>& work, Begin begin = Begin::step);

/// One exact solve: `change` becomes x of (JM⁻¹Jᵀ + γ)x = -(JV + offset), for the active rows.
template <class M>
void solve_equations(const Direct& solver, const System<M>& system, const std::vector<double>& offset,
                     const Bodies<M>& bodies, DirectWork<M>& work, std::vector<double>& change);

/// The same by one dense matrix, the reference.
template <class M>
void solve_dense(const Direct& solver, const System<M>& system, const std::vector<double>& offset,
                 const Bodies<M>& bodies, const std::vector<char>& active, std::vector<double>& change);

/// Solves (JM⁻¹Jᵀ + γ)x = -offset with the factor of the last structured `solve_equations`, at a part of its cost.
template <class M>
void solve_again(const std::vector<double>& offset, DirectWork<M>& work, std::vector<double>& change);

/// The cost of a direct solve in row-solves. A row-solve takes 2 dof multiplications for JV (8) and 2 dof for
/// (20).
long long direct_row_solves(const Direct& solver, const Elimination& plan, long long rows, int dof);
/// The cost of `solve_again`.
inline long long row_solves_again(const Elimination& plan, int dof) {
  return plan.multiplications_again / (4 * dof) + 1;
}

}  // namespace byhand
