#include "solver/integrate/gyroscopic.hpp"

#include <algorithm>

namespace byhand {
namespace {

using Vector = Eigen::Vector3d;

/// [v]×, the matrix of v × ….
Eigen::Matrix3d cross_matrix(const Vector& v) {
  Eigen::Matrix3d matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
}

/// ½ h f. The tangent diverges at θ = π, so f is constant above θ = 2 rad: that keeps energy and the size of the
/// momentum but not its direction.
double half_step(const Vector& spin, double h) {
  const double theta = std::min(h * spin.norm(), 2.0);
  if (theta < 1e-4) return h / 2 * (1 + theta * theta / 12);
  const auto [sin, cos] = sin_cos(theta / 2);
  return h * sin / (cos * theta);
}

/// Ω [rad/s] from Ω₀, with principal `moments` [kg m²], all in the body's axes.
Vector turn_with(Gyroscopic choice, const Vector& spin, const Vector& moments, double h) {
  const Vector momentum = moments.cwiseProduct(spin);
  if (choice == Gyroscopic::explicit_) return spin + h * momentum.cross(spin).cwiseQuotient(moments);

  const auto error_of = [&](const Vector& mean) {
    const Vector mean_momentum = moments.cwiseProduct(mean);
    return Vector(mean_momentum + half_step(mean, h) * mean.cross(mean_momentum) - momentum);
  };
  Vector mean = spin, error = error_of(mean);
  double share = 1;  // of Newton's step: reduced when a whole step overshoots
  for (int i = 0; i < 50 && share > 1e-3; ++i) {
    // f changes so slowly with Ω that its derivative is left out.
    Eigen::Matrix3d slope = half_step(mean, h) *
                            (cross_matrix(mean) * moments.asDiagonal() - cross_matrix(moments.cwiseProduct(mean)));
    slope.diagonal() += moments;
    const Vector next = mean - share * (slope.inverse() * error), next_error = error_of(next);
    if (next_error.squaredNorm() < error.squaredNorm()) {
      mean = next;
      error = next_error;
      share = 1;
    } else {
      share /= 4;
    }
  }
  return mean;
}

/// Ω₁ [rad/s] from Ω.
Vector after_turn(const Vector& spin, const Vector& moments, double h) {
  const Vector momentum = moments.cwiseProduct(spin);
  return spin + half_step(spin, h) * momentum.cross(spin).cwiseQuotient(moments);
}

/// Replaces the Ω of each body that moves by change(Ω, moments).
template <class F>
void change_spins(Bodies<SpaceBody>& bodies, F&& change) {
  for (int i = 0; i < bodies.size(); ++i) {
    if (!moves(bodies.inverse_mass[i])) continue;
    const Eigen::Quaterniond& q = bodies.pose[i].rotation;
    auto omega = bodies.velocity[i].tail<3>();
    const Vector moments = bodies.inverse_mass[i].angular.cwiseInverse();
    const Vector spin = rotate(inverse(q), omega);
    omega += rotate(q, change(spin, moments) - spin);  // only the change, or rounding of |q| accumulates
  }
}

}  // namespace

void begin_turn(Gyroscopic choice, Bodies<SpaceBody>& bodies, double h) {
  if (choice == Gyroscopic::none) return;
  change_spins(bodies, [&](const Vector& spin, const Vector& I) { return turn_with(choice, spin, I, h); });
}

void end_turn(Gyroscopic choice, Bodies<SpaceBody>& bodies, double h) {
  if (choice != Gyroscopic::implicit) return;
  change_spins(bodies, [&](const Vector& spin, const Vector& I) { return after_turn(spin, I, h); });
}

}  // namespace byhand
