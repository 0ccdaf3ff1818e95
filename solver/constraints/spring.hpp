#pragma once

#include "solver/constraints/normalised_distance.hpp"

// A spring: a rod whose impulse obeys Hooke's law with damping, evaluated at the end of the step.
//
//   C                C = |P2 - P1| - L, J as in NormalisedDistance                                       [m]
//   force            λ/h = -(k C₊ + c Ċ₊),   Ċ₊ = JV,   C₊ = C + h JV
//   gather JV        λ/h = -(k C + (c + hk) JV)
//   as a row         JV + k/(c + hk) C + γλ = 0,   γ = 1/(h (c + hk))
//
// So the bias is k/(c + hk) C and the softness γ: (17) becomes Δλ = -(JV + b + γλ)/(JM⁻¹Jᵀ + γ). A single spring
// is integrated by implicit Euler, stable for all k, c and h, unlike an explicit one. (Source of the two formulas:
// E. Catto, Soft constraints, GDC 2011.)
namespace byhand {

/// Hooke's law with damping: k [N/m or N m/rad] > 0 and c [N s/m or N m s/rad] >= 0.
struct Elastic {
  double stiffness = 0, damping = 0;

  /// γ and bias of a row at C, over a time step h [s].
  Soft soft(double C, double h) const {
    const double whole = damping + h * stiffness;
    return {1 / (h * whole), stiffness / whole * C};
  }
  void require_valid() const {
    require_positive("stiffness", stiffness, "N/m or N m/rad");
    require_in("damping", damping, 0, 1e300, "N s/m or N m s/rad");
  }
};

template <class M>
struct Spring {
  static constexpr int rows = 1, position_rows = 0;  // the row has its own bias

  Anchors<M> at;
  double length = 1;  // L, the length without force [m] > 0
  Elastic elastic = {};

  template <class T>
  Rows<1, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    return NormalisedDistance<M>{at, length}.template value<T>(pose1, pose2);
  }
  Jacobian<M, 1> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    return NormalisedDistance<M>{at, length}.jacobian(pose1, pose2);
  }
  Soft soft(const Pose<M>& pose1, const Pose<M>& pose2, double h) const {
    return elastic.soft(value<double>(pose1, pose2)[0], h);
  }

  void require_valid(const Bodies<M>& bodies) const {
    at.require_rod(length, bodies);
    elastic.require_valid();
  }
};

/// Stiffness and damping with which a row, alone and at the bodies' current poses, oscillates at `frequency` ω
/// [rad/s] > 0 with `damping_ratio` ζ >= 0: k = m ω², c = 2 m ζ ω with the effective mass m = 1/(JM⁻¹Jᵀ) of (19).
template <class M, class Kind>
Elastic tuned(const Bodies<M>& bodies, const Kind& row, double frequency, double damping_ratio) {
  static_assert(Kind::rows == 1);
  require_positive("frequency", frequency, "rad/s");
  require_in("damping ratio", damping_ratio, 0, 1e300);
  row.at.require_valid(bodies);
  const int body1 = row.at.body1, body2 = row.at.body2;
  const Pose<M>&pose1 = bodies.pose[body1], &pose2 = bodies.pose[body2];
  const Jacobian<M, 1> J = row.jacobian(pose1, pose2);
  const auto W = times_inverse_mass(J, bodies.inverse_mass[body1], pose1, bodies.inverse_mass[body2], pose2);
  const double inverse_mass = inverse_effective_mass(J, W)(0, 0);
  require_positive("inverse effective mass of the row", inverse_mass);
  return {frequency * frequency / inverse_mass, 2 * damping_ratio * frequency / inverse_mass};
}

BYHAND_STORES(extern, Spring);

}  // namespace byhand
