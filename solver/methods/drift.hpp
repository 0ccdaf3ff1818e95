#pragma once

#include <algorithm>
#include <limits>
#include <variant>

#include "solver/methods/projection.hpp"
#include "solver/methods/soft_constraints.hpp"
#include "solver/methods/split_impulse.hpp"
#include "solver/system.hpp"

// JV = 0 keeps a constraint's rate at zero, not its value: C drifts. A cure turns C into the bias b of (21).
namespace byhand {

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
  // Of one-sided rows alone: how much overlap is left alone, so that contacts at rest stay touching [m] >= 0, and
  // how fast what is more is pushed out at most [m/s] > 0.
  double slop = 0;
  double speed_cap = std::numeric_limits<double>::infinity();
};

using DriftCure = std::variant<NoDriftCure, Baumgarte, Projection, SplitImpulse, SoftConstraints>;

/// Throws std::invalid_argument for β outside the range above.
inline void require_valid(const NoDriftCure&) {}
inline void require_valid(const Baumgarte& cure) {
  if (cure.reading == BetaReading::per_step)
    require_in("beta", cure.beta, 0, 3);
  else
    require_in("beta", cure.beta, 0, 1e6, "1/s");
  require_in("slop", cure.slop, 0, 1e300, "m");
  require(cure.speed_cap > 0, "speed cap", cure.speed_cap, "above zero [m/s]");
}

//! [bias]
/// b of (21) for C of one row at time step h: by (22), b = (β/h) C. Cures that leave velocities alone have none.
template <class Cure>
inline double bias(const Cure&, double /*C*/, double /*h*/) {
  return 0;
}
inline double bias(const Baumgarte& cure, double C, double h) {
  return cure.reading == BetaReading::per_step ? cure.beta / h * C : cure.beta * C;
}
inline double bias(const SoftConstraints& cure, double C, double h) { return softness_of(cure, h).rate * C; }
//! [bias]

/// b of a one-sided row that overlaps, C <= 0.
template <class Cure>
inline double bias_of_overlap(const Cure& cure, double C, double h) {
  if constexpr (requires { cure.speed_cap; })
    return std::max(bias(cure, std::min(C + cure.slop, 0.0), h), -cure.speed_cap);
  else
    return bias(cure, C, h);
}

/// Sets the bias of every row. A one-sided row that is still open (C > 0) may close its gap within the step
/// and not more: b = C/h, whatever the cure.
template <class M>
void set_bias(const DriftCure& cure, double h, System<M>& system);

}  // namespace byhand
