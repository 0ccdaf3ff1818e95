#pragma once

#include "solver/constraints/normalised_distance.hpp"
#include "solver/row.hpp"

// A spring is a rod that gives way: a row whose impulse obeys Hooke's law with damping, at the end of the step.
//
//   C                C = |P2 - P1| - L, J as in NormalisedDistance                                       [m]
//   force            λ/h = -(k C₊ + c Ċ₊),   Ċ₊ = JV,   C₊ = C + h JV
//   gather JV        λ/h = -(k C + (c + hk) JV)
//   as a row         JV + k/(c + hk) C + γλ = 0,   γ = 1/(h (c + hk))
//
// So the bias is k/(c + hk) C and the softness γ: (17) becomes Δλ = -(JV + b + γλ)/(JM⁻¹Jᵀ + γ). Alone it is
// implicit Euler on a spring, stable for every k, c and h, which an explicit spring is not. (Source of the two
// formulas: E. Catto, Soft constraints, GDC 2011.)
namespace byhand {

/// Hooke's law with damping: k [N/m or N m/rad] and c [N s/m or N m s/rad].
struct Elastic {
  double stiffness = 0, damping = 0;

  /// γ and bias of a row at C, over a time step h [s].
  Soft soft(double C, double h) const {
    const double whole = damping + h * stiffness;
    return {1 / (h * whole), stiffness / whole * C};
  }
};

/// Throws std::invalid_argument unless k > 0 and c >= 0.
inline void require_valid(const Elastic& elastic) {
  require_positive("stiffness", elastic.stiffness, "N/m or N m/rad");
  require_in("damping", elastic.damping, 0, 1e300, "N s/m or N m s/rad");
}

template <class M>
struct Spring {
  static constexpr int rows = 1;
  static constexpr Bound bound = Bound::none;
  static constexpr int position_rows = 0;  // the row brings its own bias

  Anchors<M> at;
  double length = 1;  // L, where it pulls and pushes nothing [m] > 0
  Elastic elastic = {};

  /// |P2 - P1| - L at two poses [m], for any scalar.
  template <class T>
  Rows<1, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    return rod().template value<T>(pose1, pose2);
  }

  Soft soft(const Pose<M>& pose1, const Pose<M>& pose2, double h) const {
    return elastic.soft(value<double>(pose1, pose2)[0], h);
  }

  /// J at two poses [1, and m where a body turns].
  Jacobian<M, 1> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    return rod().jacobian(pose1, pose2);
  }

  /// Throws std::invalid_argument for length, stiffness or damping out of range, or points that coincide.
  void require_valid(const Bodies<M>& bodies) const {
    rod().require_valid(bodies);
    byhand::require_valid(elastic);
  }

 private:
  NormalisedDistance<M> rod() const { return {at, length}; }
};

/// The stiffness and damping with which a row of these bodies, alone, swings at `frequency` ω [rad/s] > 0 and is
/// damped by `damping_ratio` ζ >= 0: k = m ω², c = 2 m ζ ω with the effective mass m = 1/(JM⁻¹Jᵀ) of (19), as they
/// now stand.
template <class M, class Kind>
Elastic tuned(const Bodies<M>& bodies, const Kind& row, double frequency, double damping_ratio) {
  static_assert(Kind::rows == 1);
  require_positive("frequency", frequency, "rad/s");
  require_in("damping ratio", damping_ratio, 0, 1e300);
  const int body1 = row.at.body1, body2 = row.at.body2;
  require_body(bodies, body1);
  require_body(bodies, body2);
  const Pose<M>&pose1 = bodies.pose[body1], &pose2 = bodies.pose[body2];
  const Jacobian<M, 1> J = row.jacobian(pose1, pose2);
  const Jacobian<M, 1> W =
      times_inverse_mass(J, bodies.inverse_mass[body1], pose1, bodies.inverse_mass[body2], pose2);
  const double inverse_mass = inverse_effective_mass(J, W)(0, 0);
  require_positive("inverse effective mass of the row", inverse_mass);
  return {frequency * frequency / inverse_mass, 2 * damping_ratio * frequency / inverse_mass};
}

BYHAND_STORES_IN_LIBRARY(Spring);

}  // namespace byhand
