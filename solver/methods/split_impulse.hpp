#pragma once

#include <limits>

#include "solver/require.hpp"

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
  require_in("slop", cure.slop, 0, 1e300, "m");
  require(cure.speed_cap > 0, "speed cap", cure.speed_cap, "above zero [m/s]");
}

}  // namespace byhand
