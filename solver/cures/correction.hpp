#pragma once

#include <limits>

#include "solver/system.hpp"

// JV = 0 keeps a constraint's rate at zero, not its value: C drifts. A cure turns C into the bias b of (21), or
// corrects the poses after they have moved, or both. Each cure is one file of this folder; `correction(cure, h)`
// gives its bias.
namespace byhand {

/// How a cure sets the bias: b = rate C.
struct Correction {
  double rate = 0;  // [1/s]
  // Of one-sided rows only: overlap that is left, so that resting contacts keep touching [m] >= 0, and the largest
  // speed at which the rest is pushed out [m/s] > 0.
  double slop = 0;
  double speed_cap = std::numeric_limits<double>::infinity();
};

inline void require_valid_slop(double slop, double speed_cap) {
  require_in("slop", slop, 0, 1e300, "m");
  require(speed_cap > 0, "speed cap", speed_cap, "above zero [m/s]");
}

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
