#pragma once

#include <vector>

#include "solver/support/finite.hpp"
#include "solver/support/require.hpp"

// A row solver is a struct of choices: one file of this folder, of direct/, or of a program that uses the library.
// The step asks of it
//
//   Solution solve(System<M>&, Bodies<M>&, Work<M>&, Begin) const
//                                       solves the rows for λ within their bounds and applies the impulses to the
//                                       velocities; λ and V change together
//   void require_valid(solver)          throws std::invalid_argument for a choice outside its range
//
// and, where the default does not fit:
//
//   template <class M> struct Work      what it keeps between steps. Default: nothing
//   static constexpr bool holds_bounds  false: the step refuses scenes with bounds. Default: true
//   Layout layout() const               the order in which it solves the rows. Default: natural
//   Layout layout(const Work<M>&) const,
//   std::vector<int> order(const Graph&, Work<M>&) const
//                                       instead of that, where the order is planned along the scene's graph
//
// RowSolver in step.hpp lists those of the library. A program gives its own to VelocitySteppingWith.
namespace byhand {

template <class M>
struct Bodies;
template <class M>
struct System;
struct Graph;

/// The order of the rows: of the constraints as they were added, the reverse, by colour, or of elimination.
enum class Layout { none, natural, reverse, coloured, elimination };

/// What one solve of the rows has reached, or all solves of a step together.
struct Solution {
  int passes = 0;            // over all rows
  int rounds = 0;            // direct solves
  double residual = 0;       // the largest [m/s]; NaN where a solver did not look: a fixed number of sweeps, or a
                             // direct solve without bounds, which is exact to rounding
  bool converged = true;     // whether it is within the solver's tolerance
  long long row_solves = 0;  // cost of direct solves: the row solves of as many multiplications

  Solution& operator+=(const Solution& other) {
    passes += other.passes;
    rounds += other.rounds;
    residual = larger(residual, other.residual);
    converged = converged && other.converged;
    row_solves += other.row_solves;
    return *this;
  }
};

/// Where a solve begins: at the start of a step, with no λ or with the last step's; or with the λ that the
/// velocities contain already.
enum class Begin { step, resume };

/// How rows that form a block are solved: with E of (17) the inverse of its whole K × K matrix, or of the lower
/// triangle, which solves them one after the other.
enum class BlockSolve { whole, row_by_row };

/// What a row solver keeps that keeps nothing.
struct NoWork {};

/// Throws std::invalid_argument for a tolerance outside [0, 1].
inline void require_valid_tolerance(double tolerance) { require_in("tolerance", tolerance, 0, 1); }

}  // namespace byhand
