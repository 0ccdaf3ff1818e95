#pragma once

#include "solver/cures/correction.hpp"

// Each row becomes a damped spring of the same angular frequency ω and damping ratio ζ, whatever the masses. With
// the row's effective mass m = 1/A of (19), A = JM⁻¹Jᵀ, and the spring row of constraints/spring.hpp,
//
//   k = mω²,   c = 2mζω,   JV + k/(c + hk) C + γλ = 0,   γ = 1/(h(c + hk))
//   c + hk = mω(2ζ + hω) = mω a₁                             a₁ = 2ζ + hω
//   bias   = k/(c + hk) C = (ω/a₁) C
//   γ      = 1/(h m ω a₁) = A/a₂                             a₂ = hω a₁
//
// A single row is stable for every hω and ζ. Under a constant pull T it sags by T/(mω²): at rest λ/h = T, JV = 0
// and C = -(a₁/ω) γλ. Its correction adds velocity, so the rows are relaxed once the poses have moved: solved
// again, hard and without bias, from the current λ. Then JV = 0 and the λ of the next warm start contains no
// correction.
//
// Source: E. Catto, "Soft constraints", GDC 2011, and "Solver2D", 2024; used in Box2D 3. Cost: the rows solved
// twice, and written twice if refreshed.
namespace byhand {

/// Springs of one frequency, then relaxed.
struct SoftConstraints {
  double frequency = 90;     // ω [rad/s] > 0
  double damping_ratio = 1;  // ζ >= 0
  bool relax = true;         // solve the rows again, hard and without bias
  bool refresh = true;       // with rows written at the new poses, so that V is tangent to C = 0 there
  double slop = 0;           // as in Correction
  double speed_cap = std::numeric_limits<double>::infinity();  // as in Correction

  /// b = (ω/a₁) C.
  Correction correction(double h) const {
    return {frequency / (2 * damping_ratio + h * frequency), slop, speed_cap};
  }
  template <class M>
  void begin(Stage<M>& stage) const;
  template <class M>
  void after_move(Stage<M>& stage) const;
};

inline void require_valid(const SoftConstraints& cure) {
  require_positive("frequency", cure.frequency, "rad/s");
  require_in("damping ratio", cure.damping_ratio, 0, 1e300);
  require_valid_slop(cure.slop, cure.speed_cap);
}

}  // namespace byhand
