#pragma once

#include <array>

namespace byhand {

/// A symmetric top that spins on its tip (Lagrange's): with the spin s about its own axis, moment C along the axis
/// and A across it, both about the tip, it keeps its lean θ from straight up while it precesses at a rate Ω with
/// A Ω² cosθ - C s Ω + m g a = 0 (Goldstein, Classical Mechanics, §5.7).
struct HeavyTop {
  double mass = 1;           // m [kg]
  double arm = 1;            // a, from the tip to the centre of mass [m]
  double moment_along = 1;   // C [kg m²]
  double moment_across = 2;  // A, about the tip [kg m²] > m a²
  double spin = 20;          // s: ω along the axis, which stays [rad/s]
  double gravity = 9.81;     // [m/s²]

  /// The slow and the fast rate of steady precession about the upward vertical at a lean in [0, π] [rad/s]; a
  /// level top has only the slow one, and the fast is infinite. Throws std::invalid_argument for numbers out of
  /// range and a spin too slow to carry the top.
  std::array<double, 2> precession(double angle) const;
  /// The least spin with which it precesses steadily at that lean [rad/s]; 0 from the level downwards.
  double least_spin(double angle) const;
};

}  // namespace byhand
