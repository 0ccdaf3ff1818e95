#pragma once

#include <algorithm>
#include <cmath>

#include "lessons/laws/spectral_radius.hpp"

// How the slowest mode of a step's rows goes on from step to step.
namespace byhand::doctor {

/// What a step does to a mode: its sweeps leave the share `left` of what λ lacks, the cure takes back `beta` of
/// its error C by a velocity and `share` of it by moving the poses, and gravity makes C grow by itself at
/// `tipping` σ, C'' = σ²C.
struct SlowMode {
  double left = 0;     // q in [0, 1)
  double beta = 0;     // β
  double share = 0;    // of the error that the poses are moved by
  double tipping = 0;  // σ [1/s]
  double step = 0;     // h [s]
  bool warm_start = true;
  bool only_pushes = false;  // a contact: λ >= 0, and a gap closes within a step
  double slop = 0;           // of a contact [m]

  /// The largest modulus of an eigenvalue of a step: above 1 the mode grows. Of rows that pull, too.
  double growth() const;
};

/// The error C of a mode [m], its rate [m/s], and λ as the change of rate that it makes [m/s].
struct ModeState {
  double C = 0, rate = 0, lambda = 0;

  /// A step in which the load changes the rate by `load` [m/s]. The warm start pays last step's λ; the sweeps
  /// leave q of what is then missing.
  void step(const SlowMode& mode, double load) {
    rate += mode.tipping * mode.tipping * mode.step * C - load;
    if (!mode.warm_start) lambda = 0;
    double wrong = C;  // of which the bias takes back β, or all of an open gap
    double beta = mode.beta;
    if (mode.only_pushes) {
      if (C > 0)
        beta = 1;
      else
        wrong = std::min(0.0, C + mode.slop);
    }
    const double residual = rate + lambda + beta / mode.step * wrong;
    lambda -= (1 - mode.left) * residual;
    if (mode.only_pushes) lambda = std::max(lambda, 0.0);
    rate += lambda;
    C += mode.step * rate;
    C -= mode.share * (1 - mode.left) * (mode.only_pushes ? std::min(0.0, C + mode.slop) : C);
  }
};

inline double SlowMode::growth() const {
  SlowMode linear = *this;
  linear.only_pushes = false;
  Eigen::Matrix3d step_of;  // of (C/h, rate, λ), column by column
  for (int k = 0; k < 3; ++k) {
    ModeState state{k == 0 ? step : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0};
    state.step(linear, 0);
    step_of.col(k) << state.C / step, state.rate, state.lambda;
  }
  return laws::spectral_radius(step_of);
}

}  // namespace byhand::doctor
