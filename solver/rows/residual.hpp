#pragma once

#include "solver/system.hpp"

// The residual of a row is the Δλ of its natural map,
//
//   Δλ = Π(λ - D⁻¹(JV + b + γλ)) - λ,
//
// where Π holds λ within its bounds and D is the diagonal of JM⁻¹Jᵀ + γ. It vanishes just where the row is solved:
// within its bounds λ leaves no error, at a bound only an error that drives it off counts. As a speed it is
//
//   |Δλ| √(D (m₁⁻¹ + m₂⁻¹))   [m/s].
//
// For a rod between two particles this is the speed at which its ends still part. Any other row is scaled to the
// same JM⁻¹Jᵀ = m₁⁻¹ + m₂⁻¹, so that rows in m, m² and rad are alike, whatever the unit of length. The scale is
// the largest |λ| in the same measure: a tolerance is a share of it. Gauss–Seidel's own Δλ is the residual of each
// row at its turn, so that a sweep yields it nearly free. V is no measure: where four contacts share a face it
// returns to itself while λ still changes.
namespace byhand {

/// The largest residual of all rows, and what it is compared with [m/s].
struct Residual {
  double largest = 0;
  double largest_lambda = 0;  // as a speed

  /// Whether it is at most this share of the largest λ, or only rounding beside the `speed` of the fastest
  /// body.
  bool within(double tolerance, double speed) const {
    return largest <= tolerance * largest_lambda || (tolerance > 0 && largest <= 1e-14 * speed);
  }
};

/// D of the natural map and the factor that makes a speed of Δλ, by row. Both tangents of friction in space get
/// the larger D of theirs, so that Π stays a disc's.
struct RowScales {
  std::vector<double> D, speed;
};

/// m₁⁻¹ + m₂⁻¹ of a block's bodies.
template <class M>
double inverse_mass(const System<M>& system, const BlockHeader& block) {
  return system.inverse_mass[block.body1].linear + system.inverse_mass[block.body2].linear;
}

template <class M>
void find_scales(const System<M>& system, RowScales& scales);

/// The residual of λ whose errors JV + b + γλ are these.
template <class M>
Residual residual(const System<M>& system, const std::vector<double>& lambda, const std::vector<double>& error,
                  const RowScales& scales);

/// The speed of the fastest body, turning included: √(v² + ω²I/m) [m/s].
template <class M>
double fastest(const System<M>& system, const std::vector<Velocity<M>>& velocities);

}  // namespace byhand
