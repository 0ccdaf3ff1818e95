#pragma once

#include "solver/laws/law.hpp"

namespace byhand::laws {

/// A column of N boxes of unit height on joints that give way: each face answers a turn of θ by a moment κθ, the
/// lowest by base × κθ. To second order in what the boxes lean, θ_1 … θ_N, it has the energy
///
///   ½κ [base θ_1² + Σ (θ_i - θ_{i-1})²] - ½mg Σ (N - i + ½) θ_i²,
///
/// which has no minimum at rest once mg/κ exceeds the smallest μ at which T - μD is singular: this μ. For many
/// boxes it is 7.837/N³, the height at which a column buckles under its own weight.
///
/// A. G. Greenhill, "Determination of the greatest height consistent with stability that a vertical pole or mast
/// can be made", Proceedings of the Cambridge Philosophical Society 4, 1881.
inline double buckling_load(int boxes, double base) {
  const auto upright = [&](double load) {
    double pivot = 1;
    for (int i = 1; i <= boxes; ++i) {
      const double stiffness = (i == 1 ? base : 1) + (i == boxes ? 0 : 1);
      pivot = stiffness - load * (boxes - i + 0.5) - (i == 1 ? 0 : 1 / pivot);
      if (pivot <= 0) return false;
    }
    return true;
  };
  return bisect(upright, 1e-12, 1e12, 1e-12);
}

}  // namespace byhand::laws
