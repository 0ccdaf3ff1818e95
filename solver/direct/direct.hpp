#pragma once

#include <array>
#include <stdexcept>

#include "solver/direct/graph.hpp"
#include "solver/gauss_seidel.hpp"

namespace byhand {

/// How the matrix of all rows is factored: along the scene's graph, in time proportional to its size on
/// chains, trees and stars; or as one dense matrix, the reference.
enum class Factorisation { structured, dense };

/// All rows at once and exactly: (JM⁻¹Jᵀ + γ)λ = -(JV + b).
///
/// With bounds, by an active set: the rows that are not held at a bound are solved, what then breaks a bound is
/// held, and one sweep of Gauss–Seidel tells what else has to change; over again until a sweep finds nothing to
/// do, or after `rounds` by sweeps alone.
struct Direct {
  Factorisation factorisation = Factorisation::structured;
  double regularisation = 0;  // >= 0: this share of each row's own JM⁻¹Jᵀ is added to its γ
  int rounds = 20;            // >= 1, with bounds
  double tolerance = 1e-5;    // > 0, with bounds: what a last sweep may still change [m/s, rad/s]
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
  template <int K, Bound B>
  using BlockOf = Block<M, K, B>;
  struct View {
    const double *J, *W;  // rows × 2 dof, row-major
    int row, body1, body2;
    bool folded1, folded2;
  };
  /// Of each type of block, where the J of the first stands.
  using FirstJ = std::array<const double*, std::tuple_size_v<PerBlock<M, BlockOf>>>;

  Elimination plan;
  std::vector<double> values, unknowns, diagonal;
  std::vector<View> views;             // by node
  std::uint64_t layout = 0;            // that they belong to
  FirstJ viewed{};                     // the blocks that they look at
  int size = 0;                        // that all edges have, or 0
  int answered = 0;                    // rows of all edges that can move something; the others follow
  std::vector<double> offset, change;  // b + γλ and Δλ, by row
  // Of rows with bounds:
  std::vector<char> active;     // by row: whether it takes part; empty while all do
  PerBlock<M, BlockOf> masked;  // bounded blocks without their inactive rows
  std::vector<Velocity<M>> velocity_before;
  std::vector<double> lambda_before;  // a way back
};

/// Solves the system's rows for λ and puts the impulses into the velocities; without bounds, what λ was before a
/// step does not matter. The system must be laid out in the order of `work.plan`. Throws SingularSystem, and
/// leaves the velocities alone then if there are no bounds. Returns how often all rows were solved.
template <class M>
int solve(const Direct& solver, System<M>& system, Bodies<M>& bodies, Prepared<M>& prepared, DirectWork<M>& work,
          Begin begin = Begin::step);

/// One exact solve: `change` becomes x of (JM⁻¹Jᵀ + γ)x = -(JV + offset), with a row x = 0 where `work.active` is
/// set and says so.
template <class M>
void solve_equations(const Direct& solver, const System<M>& system, const std::vector<double>& offset,
                     const Bodies<M>& bodies, DirectWork<M>& work, std::vector<double>& change);

/// The structured solve once more for another right-hand side, with the factor that `solve_equations` has left in
/// `work`: `change` becomes x of (JM⁻¹Jᵀ + γ)x = -offset, at a part of the cost.
template <class M>
void solve_again(const std::vector<double>& offset, DirectWork<M>& work, std::vector<double>& change);

/// What a direct solve costs in row-solves: one of those multiplies 2 dof numbers for JV (8) and 2 dof for (20).
long long direct_row_solves(const Direct& solver, const Elimination& plan, long long rows, int dof);
/// What `solve_again` does.
long long row_solves_again(const Elimination& plan, int dof);

}  // namespace byhand
