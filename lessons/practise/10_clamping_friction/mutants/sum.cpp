// clamp_friction returns the sum of all impulses so far; V needs what is new, accumulated − before.
#include <algorithm>

#include "practise.hpp"

double clamp_friction(double& accumulated, double delta, double mu, double normal) {
  accumulated = std::clamp(accumulated + delta, -mu * normal, mu * normal);
  return accumulated;
}

void solve_contact(Contact& c, Velocities& V) {
  const double before = c.lambda_normal;
  c.lambda_normal = std::max(0.0, before - dot(c.J_normal, V) / c.K_normal);
  V += (c.lambda_normal - before) * c.W_normal;
  const double delta = -dot(c.J_tangent, V) / c.K_tangent;
  V += clamp_friction(c.lambda_tangent, delta, c.mu, c.lambda_normal) * c.W_tangent;
}
