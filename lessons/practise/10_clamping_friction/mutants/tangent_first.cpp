// The tangent goes before the normal, so the bound is that of the pass before: solve the normal first.
#include <algorithm>

#include "practise.hpp"

double clamp_friction(double& accumulated, double delta, double mu, double normal) {
  const double before = accumulated;
  accumulated = std::clamp(before + delta, -mu * normal, mu * normal);
  return accumulated - before;
}

void solve_contact(Contact& c, Velocities& V) {
  V += clamp_friction(c.lambda_tangent, -dot(c.J_tangent, V) / c.K_tangent, c.mu, c.lambda_normal) * c.W_tangent;
  const double before = c.lambda_normal;
  c.lambda_normal = std::max(0.0, before - dot(c.J_normal, V) / c.K_normal);
  V += (c.lambda_normal - before) * c.W_normal;
}
