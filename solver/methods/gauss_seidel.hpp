#pragma once

#include "solver/methods/prepared.hpp"

namespace byhand {

/// In which order the rows of a sweep are solved: as the constraints were added, the other way round, colour by
/// colour, which is red–black on a chain, or as they were added and then back, which counts as two sweeps.
enum class SweepOrder { natural, reverse, coloured, symmetric };

/// How many sweeps one in this order is.
inline int ways(SweepOrder order) { return order == SweepOrder::symmetric ? 2 : 1; }

/// Projected Gauss–Seidel, which is sequential impulses: each block of rows is solved by (17) with what the
/// blocks before it have already changed, over and over. A choice, not a state: λ is kept in the System.
struct GaussSeidel {
  int sweeps = 10;         // >= 1; of symmetric ones each is two
  bool warm_start = true;  // begin with the λ of the last step
  SweepOrder order = SweepOrder::natural;
  BlockSolve block_solve = BlockSolve::whole;
  double relaxation = 1;  // in (0, 2); other than 1 this is SOR
  double tolerance = 0;   // >= 0: no further sweep once one changes no velocity by more [m/s, rad/s]
};

/// Throws std::invalid_argument for a choice outside the ranges above.
void require_valid(const GaussSeidel& solver);

/// Solves the system's rows for λ and puts the impulses into the velocities. `prepared` is scratch that is
/// kept only so that no step allocates. Returns how many sweeps it took.
template <class M>
int solve(const GaussSeidel& solver, System<M>& system, std::vector<Velocity<M>>& velocities,
          Prepared<M>& prepared, Begin begin = Begin::step);

/// One sweep over prepared rows in the order in which they are laid out, and one back where there are two `ways`.
template <class M>
void sweep(const System<M>& system, const Prepared<M>& prepared, double* lambda, double* V, int ways = 1);

/// One sweep, and by how much it changed any velocity at most [m/s, rad/s].
template <class M>
double watched_sweep(System<M>& system, Prepared<M>& prepared, std::vector<Velocity<M>>& velocities, int ways = 1);

}  // namespace byhand
