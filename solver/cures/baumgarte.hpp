#pragma once

#include <limits>

#include "solver/cures/correction.hpp"

namespace byhand {

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

  //! [bias]
  /// (22): b = (β/h) C over a time step h [s].
  Correction correction(double h) const {
    return {reading == BetaReading::per_step ? beta / h : beta, slop, speed_cap};
  }
  //! [bias]
};

inline void require_valid(const NoDriftCure&) {}
inline void require_valid(const Baumgarte& cure) {
  const bool per_step = cure.reading == BetaReading::per_step;
  require_in("beta", cure.beta, 0, per_step ? 3 : 1e6, per_step ? "" : "1/s");
  require_valid_slop(cure.slop, cure.speed_cap);
}

}  // namespace byhand
