#pragma once

#include "solver/drift.hpp"
#include "solver/methods/row_solvers.hpp"

// Baumgarte's correction is a velocity, and stays one: an overlap d leaves at βd/h, and a box jumps. Split impulse
// keeps the two apart. V obeys JV = 0 alone. Poses move with V and then with pseudo-velocities P, which make up
// for what is missing in
//
//   J(V + P) = -(β/h) C      (22)
//
// and never reach V: no energy of the correction is left.
//
// The rows are solved twice. The second time they go on from the λ and V of the first, with the bias of (22), so
// that bounds, softness and motors stand as they do in the first; what that adds to V is P. Then V and λ are what
// they were, and only that λ begins the next step. What P's own impulses were begins the next P. Such a memory is
// what makes Baumgarte's ring, but not here, where it ends in a pose and not in a velocity: with q left of an
// error by the sweeps of a step, and p = -hJP in their slowest mode,
//
//   p' = qp + (1 - q)βC,   C' = C - p'      so      z² - (1 + q - (1 - q)β)z + q = 0,
//
// whose roots lie within the unit circle for β < 2(1 + q)/(1 - q), that is for every β up to 2 however few the
// sweeps. (The stability is derived here.)
//
// Source of the idea: E. Guendelman, R. Bridson, R. Fedkiw, "Nonconvex rigid bodies with stacking", ACM
// Transactions on Graphics 22, 2003; under this name in E. Coumans' Bullet. Cost: the rows twice.
namespace byhand {

/// Corrections that poses keep and velocities do not.
struct SplitImpulse {
  double beta = 0.2;       // in [0, 3]: the share of C that a step takes back
  bool warm_start = true;  // begin P with that of the last step, as long as no constraints come or go
  // Of one-sided rows alone, as in Baumgarte:
  double slop = 0;                                             // [m] >= 0
  double speed_cap = std::numeric_limits<double>::infinity();  // of P [m/s] > 0
};

/// Throws std::invalid_argument for a choice outside the ranges above.
inline void require_valid(const SplitImpulse& cure) {
  require_in("beta", cure.beta, 0, 3);
  require_valid_slop(cure.slop, cure.speed_cap);
}

/// V obeys JV = 0: no bias.
inline Correction correction(const SplitImpulse& cure, double /*h*/) { return {0, cure.slop, cure.speed_cap}; }

/// The impulses of the pseudo-velocities, by row, and the layout they belong to; λ and V while P is found.
template <class M>
struct SplitImpulseWork {
  std::vector<double> pushes;
  std::uint64_t layout = 0;
  std::vector<double> lambda;
  std::vector<Velocity<M>> velocity;
};

/// The second half of the step: poses move with what (22) adds to the velocities, which stay as they are.
template <class M>
void push_poses(const SplitImpulse& cure, const RowSolver& solver, double h, Bodies<M>& bodies, RowWork<M>& rows,
                SplitImpulseWork<M>& work);

}  // namespace byhand
