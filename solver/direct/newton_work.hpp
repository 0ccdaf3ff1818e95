#pragma once

#include "solver/direct/envelope.hpp"
#include "solver/direct/equations.hpp"
#include "solver/rows/prepared.hpp"

namespace byhand {

/// The matrix of the last layout, and scratch that is kept so that no step allocates.
template <class M>
struct NewtonWork {
  Envelope<M> matrix;
  Prepared<M> prepared;
  RowScales scales;
  // By row: its bodies, e, h and R of x = h - R ΔV, λ°, and λ before a step and at its best.
  std::vector<std::pair<int, int>> bodies_of;
  std::vector<double> error, h, centre, before, best, change;
  std::vector<Packed<double, 1, 2 * M::dof>> R;
  std::vector<Velocity<M>> velocity_before, velocity_best;
};

/// What ByGraph keeps.
template <class M>
struct ByGraphWork {
  DirectWork<M> direct;
  NewtonWork<M> newton;
  bool loopless = false;  // whether the graph has no loops
  bool directly = false;  // whether it is solved directly, loops or not
  // Of loops with bounds:
  std::uint64_t laid_out = 0;        // the layout for which the following holds
  bool unlike = false;               // whether masses that touch differ much
  bool by_newton = false;            // whether sweeps have stalled, or would
  std::vector<Velocity<M>> without;  // of the bodies without λ
  std::vector<double> still;         // b without what rows push with
};

}  // namespace byhand
