#pragma once

#include "practise.hpp"

namespace plain {
/// One contact point: the row along its normal and the row along its tangent. W = M⁻¹Jᵀ, K = J M⁻¹ Jᵀ.
struct Contact {
  BodyRow J_normal, W_normal;
  double K_normal = 0;
  BodyRow J_tangent, W_tangent;
  double K_tangent = 0;
  double mu = 0;                                 // coefficient of friction
  double lambda_normal = 0, lambda_tangent = 0;  // accumulated impulses [N s]
};
}  // namespace plain

/// Keeps the accumulated friction impulse within ±μ times the normal impulse. Adds what it may of `delta` to
/// `accumulated` and returns the impulse that is then applied to V. All in N s.
double clamp_friction(double& accumulated, double delta, double mu, double normal);

/// One pass over the contact: first the normal row (b = 0, clamped as in exercise 9), then the tangent row.
void solve_contact(Contact& contact, Velocities& V);

#define FUNCTIONS clamp_friction, solve_contact
