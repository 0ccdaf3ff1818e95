#pragma once

#include <limits>
#include <variant>

#include "solver/system.hpp"

// JV = 0 keeps a constraint's rate at zero, not its value: C drifts. A cure turns C into the bias b of (21), or
// corrects the poses after they have moved, or both. Baumgarte's, the article's, is here; each other is one file
// in methods/. `correction(cure, h)` gives the bias of a cure.
namespace byhand {

/// How a cure sets the bias: b = rate C.
struct Correction {
  double rate = 0;  // [1/s]
  // Of one-sided rows only: overlap that is left, so that resting contacts keep touching [m] >= 0, and the largest
  // speed at which the rest is pushed out [m/s] > 0.
  double slop = 0;
  double speed_cap = std::numeric_limits<double>::infinity();
};

/// No cure: b = 0, (4).
struct NoDriftCure {};

/// The unit of β. The article's (22), JV = -βC, lacks a time. Per step it is JV = -(β/h)C, with β unitless and
/// stable in [0, 2]; read literally β is in 1/s and stable in [0, 2/h].
enum class BetaReading { per_step, literal };

/// Baumgarte's correction (21)(22): each step removes a share β of the error by a velocity, whose energy remains.
struct Baumgarte {
  double beta = 0.2;  // per step in [0, 3], so that instability above 2 can be shown; literal >= 0 [1/s]
  BetaReading reading = BetaReading::per_step;
  double slop = 0;                                             // as in Correction
  double speed_cap = std::numeric_limits<double>::infinity();  // as in Correction
};

inline void require_valid_slop(double slop, double speed_cap) {
  require_in("slop", slop, 0, 1e300, "m");
  require(speed_cap > 0, "speed cap", speed_cap, "above zero [m/s]");
}
inline void require_valid(const NoDriftCure&) {}
inline void require_valid(const Baumgarte& cure) {
  const bool per_step = cure.reading == BetaReading::per_step;
  require_in("beta", cure.beta, 0, per_step ? 3 : 1e6, per_step ? "" : "1/s");
  require_valid_slop(cure.slop, cure.speed_cap);
}

//! [bias]
/// (22): b = (β/h) C over a time step h [s].
inline Correction correction(const Baumgarte& cure, double h) {
  return {cure.reading == BetaReading::per_step ? cure.beta / h : cure.beta, cure.slop, cure.speed_cap};
}
inline Correction correction(const NoDriftCure&, double /*h*/) { return {}; }
//! [bias]

/// Sets b of every row. A one-sided row that is open (C > 0) may close its gap within the step but not more: b =
/// C/h, whatever the cure.
template <class M>
void set_bias(const Correction& correction, double h, System<M>& system) {
  const auto [rate, slop, speed_cap] = correction;
  for (int i = 0; i < system.rows(); ++i) system.bias[i] = rate * system.C[i] + system.rate[i];
  if (!system.bounded) return;
  for_each_block(system, [&, rate = rate, slop = slop, cap = speed_cap]<int K, Bound B>(
                             const Block<M, K, B>& block, const Run&) {
    for (int k = 0; k < K; ++k) {
      if (!one_sided(system, block, k)) continue;
      const double C = system.C[block.row + k];
      const double b = C > 0 ? C / h : std::max(rate * std::min(C + slop, 0.0), -cap);
      system.bias[block.row + k] = b + system.rate[block.row + k];
    }
  });
}

}  // namespace byhand
