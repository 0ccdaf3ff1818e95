// The floor pulls: the normal impulse is not clamped, and a contact that separates is held back.
#include "practise.hpp"

double clamp_friction(double& accumulated, double delta, double mu, double normal) {
  const double before = accumulated;
  accumulated = std::fmin(std::fmax(before + delta, -mu * normal), mu * normal);
  return accumulated - before;
}

void solve_contact(Contact& c, Velocities& V) {
  const double push = -dot(c.J_normal, V) / c.K_normal;
  c.lambda_normal += push;
  V += push * c.W_normal;
  const double delta = -dot(c.J_tangent, V) / c.K_tangent;
  V += clamp_friction(c.lambda_tangent, delta, c.mu, c.lambda_normal) * c.W_tangent;
}
