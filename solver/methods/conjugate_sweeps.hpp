#pragma once

#include "solver/gauss_seidel.hpp"

namespace byhand {

/// Nonlinear conjugate gradients on sweeps (NNCG): what a sweep of projected Gauss–Seidel changes is taken for a
/// gradient, and after each sweep λ moves on along the direction of those before, by the share that Fletcher and
/// Reeves give. Where a sweep changes more than the one before, the direction is forgotten. A sweep always comes
/// last, so that λ keeps its bounds. Sweeps reach a large system's slow modes as the square of their number this
/// way.
///
/// The tolerance is tight because that is cheap: a wall of boxes that is left rocking by 1e-5 m/s rocks for ever,
/// and takes more sweeps a step than one that has come to rest.
///
/// After M. Silcowitz-Hansen, S. Niebe, K. Erleben, "A nonsmooth nonlinear conjugate gradient method for
/// interactive contact force problems", The Visual Computer 26, 2010.
struct ConjugateSweeps {
  int sweeps = 50;                          // >= 1
  bool warm_start = true;                   // begin with the λ of the last step
  SweepOrder order = SweepOrder::coloured;  // the same in every sweep, or there is no gradient
  double tolerance = 3e-8;  // >= 0: no further sweep once one changes no velocity by more [m/s, rad/s]
};

/// Throws std::invalid_argument for a choice outside the ranges above.
void require_valid(const ConjugateSweeps& solver);

/// Scratch, kept so that no step allocates.
template <class M>
struct ConjugateWork {
  std::vector<double> before, direction;  // of λ, by row
  std::vector<Velocity<M>> V_direction;   // what it does to V
};

/// Solves the system's rows for λ and puts the impulses into the velocities. Returns how many sweeps it took.
template <class M>
int solve(const ConjugateSweeps& solver, System<M>& system, std::vector<Velocity<M>>& velocities,
          Prepared<M>& prepared, ConjugateWork<M>& work, Begin begin = Begin::step);

}  // namespace byhand
