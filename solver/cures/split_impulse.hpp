#pragma once

#include "solver/cures/correction.hpp"

// Baumgarte's correction is a velocity and remains one: an overlap d is left with speed βd/h, so a box jumps.
// Split impulse keeps V free of it, JV = 0, and moves the poses with V + P. The pseudo-velocities P satisfy
//
//   J(V + P) = -(β/h) C      (22)
//
// and are discarded after the move, so the correction adds no energy. P is what a second solve of the rows, with
// that bias, adds to the V and λ of the first; so bounds, softness and motors act alike in both.
//
// The impulses of P warm start those of the next step. Unlike Baumgarte's such a memory does not ring: if the
// sweeps of a step leave the share q of an error in their slowest mode, then with p = -hJP
//
//   p' = qp + (1 - q)βC,   C' = C - p'      so      z² - (1 + q - (1 - q)β)z + q = 0,
//
// whose roots lie within the unit circle for β < 2(1 + q)/(1 - q): for every β up to 2. (Derived here.)
//
// Source: E. Guendelman, R. Bridson, R. Fedkiw, "Nonconvex rigid bodies with stacking", ACM Transactions on
// Graphics 22, 2003; named so in E. Coumans' Bullet. Cost: the rows solved twice.
namespace byhand {

/// Corrects poses without changing velocities.
struct SplitImpulse {
  double beta = 0.2;       // share of C removed per step, in [0, 3]
  bool warm_start = true;  // start from the last step's P while the constraints are the same
  double slop = 0;         // as in Correction
  double speed_cap = std::numeric_limits<double>::infinity();  // as in Correction, of P

  /// J(V + P) = -(β/h)C is for `after_move`; V keeps open contacts apart alone.
  Correction correction(double /*h*/) const { return {0, slop, speed_cap}; }
  template <class M>
  void after_move(Stage<M>& stage) const;
};

/// What it keeps.
template <class M>
struct SplitImpulseWork {
  std::vector<double> pseudo_impulses;  // of P, by row
  std::uint64_t layout = 0;             // the layout they belong to
  std::vector<double> lambda;           // λ and V of the first solve
  std::vector<Velocity<M>> velocity;
};

inline void require_valid(const SplitImpulse& cure) {
  require_in("beta", cure.beta, 0, 3);
  require_valid_slop(cure.slop, cure.speed_cap);
}

}  // namespace byhand
