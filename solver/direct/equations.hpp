#pragma once

#include "solver/direct/direct.hpp"
#include "solver/direct/graph.hpp"
#include "solver/rows/prepared.hpp"

// The equations of all rows, (JM⁻¹Jᵀ + γ)x = -(JV + offset), factored along the scene's graph.
namespace byhand {

/// Throws that, or NotFinite with the names of bodies where a number is not finite.
template <class M>
[[noreturn]] void refuse_singular(const System<M>& system, const Bodies<M>& bodies);

/// What impulses of rows that are connected take of energy, together and one by one [J].
struct ConnectedPart {
  double together = 0, apart = 0;
  int rows = 0;
  bool suspect() const { return together > 4.0 * rows * rows * apart; }
};

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
  long long planned = 0;  // operations of all plans so far
  std::vector<double> values, unknowns, diagonal;
  std::vector<View> views;             // by edge, in the order of the plan
  std::vector<double> offset, change;  // b + γλ and Δλ, by row
  std::vector<double> right;           // r = -(JV + offset), by row
  std::vector<ConnectedPart> parts;    // by root
  // Of rows with bounds:
  std::vector<char> active;     // by row: whether it is solved; empty if all are
  PerBlock<M, BlockOf> masked;  // bounded blocks without their inactive rows
  std::vector<Velocity<M>> velocity_before;
  std::vector<double> lambda_before;
  Prepared<M> prepared;  // for sweeps
};

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
inline long long direct_row_solves(const Direct& solver, const Elimination& plan, long long rows, int dof) {
  const long long dense = rows * rows * rows / 6 + rows * rows;
  return (solver.factorisation == Factorisation::dense ? dense : plan.multiplications) / (4 * dof) + 1;
}
/// The cost of `solve_again`.
inline long long row_solves_again(const Elimination& plan, int dof) {
  return plan.multiplications_again / (4 * dof) + 1;
}

}  // namespace byhand
