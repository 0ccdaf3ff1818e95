#pragma once

#include <limits>
#include <variant>

#include "solver/system.hpp"

// JV = 0 keeps a constraint's rate at zero, not its value: C drifts. A cure turns C into the bias b of (21), puts
// the poses back once they have moved, or both. Each is one file in methods/ but for Baumgarte's, the article's,
// which is here.
namespace byhand {

/// How a cure sets the bias: b = rate C.
struct Correction {
  double rate = 0;  // [1/s]
  // Of one-sided rows alone: how much overlap is left alone, so that contacts at rest stay touching [m] >= 0, and
  // how fast what is more is pushed out at most [m/s] > 0.
  double slop = 0;
  double speed_cap = std::numeric_limits<double>::infinity();
};

/// No cure: b = 0, (4).
struct NoDriftCure {};

/// What β means. The article's (22), JV = -βC, is dimensionally short of a time: read per step it is JV =
/// -(β/h)C, with β unitless and stable in [0, 2]; read as it is printed β carries 1/s and is stable in [0,
/// 2/h].
enum class BetaReading { per_step, literal };

/// Baumgarte's correction (21)(22): a share β of the error is removed in each step by a velocity, whose
/// energy stays.
struct Baumgarte {
  double beta = 0.2;  // in [0, 3] per step, so that the boundary at 2 can be crossed and seen; literal: >= 0 [1/s]
  BetaReading reading = BetaReading::per_step;
  // Of one-sided rows alone, as in Correction:
  double slop = 0;
  double speed_cap = std::numeric_limits<double>::infinity();
};

/// Throws std::invalid_argument for β, slop or speed cap outside the ranges above.
inline void require_valid(const NoDriftCure&) {}
void require_valid(const Baumgarte& cure);

//! [bias]
/// (22): b = (β/h) C over a time step h [s].
inline Correction correction(const Baumgarte& cure, double h) {
  return {cure.reading == BetaReading::per_step ? cure.beta / h : cure.beta, cure.slop, cure.speed_cap};
}
inline Correction correction(const NoDriftCure&, double /*h*/) { return {}; }
//! [bias]

/// Sets b of every row. A one-sided row that is still open (C > 0) may close its gap within the step and not more:
/// b = C/h, whatever the cure.
template <class M>
void set_bias(const Correction& correction, double h, System<M>& system);

/// Throws std::invalid_argument for a slop [m] < 0 or a speed cap [m/s] that is not positive.
void require_valid_slop(double slop, double speed_cap);

}  // namespace byhand
