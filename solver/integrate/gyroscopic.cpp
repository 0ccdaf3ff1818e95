#include "solver/integrate/gyroscopic.hpp"

#include <algorithm>

namespace byhand {
namespace {

/// [v]×, the matrix of v × ….
Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
}

/// ½ h f. A turn of more than 2 rad in a step is too much for the tangent: beyond, f stays, which keeps energy and
/// the momentum's size but not its direction.
double half_step(const Eigen::Vector3d& spin, double h) {
  const double theta = std::min(h * spin.norm(), 2.0);
  if (theta < 1e-4) return h / 2 * (1 + theta * theta / 12);
  const auto [sin, cos] = sin_cos(theta / 2);
  return h * sin / (cos * theta);
}

}  // namespace

Eigen::Vector3d turn_with(Gyroscopic choice, const Eigen::Vector3d& spin, const Eigen::Vector3d& moments,
                          double h) {
  const Eigen::Vector3d momentum = moments.cwiseProduct(spin);
  if (choice == Gyroscopic::none) return spin;
  if (choice == Gyroscopic::explicit_) return spin + h * momentum.cross(spin).cwiseQuotient(moments);

  const auto error_of = [&](const Eigen::Vector3d& mean) {
    const Eigen::Vector3d mean_momentum = moments.cwiseProduct(mean);
    return Eigen::Vector3d(mean_momentum + half_step(mean, h) * mean.cross(mean_momentum) - momentum);
  };
  Eigen::Vector3d mean = spin, error = error_of(mean);
  double share = 1;  // of Newton's step: less where a whole one overshoots
  for (int i = 0; i < 50 && share > 1e-3; ++i) {
    // f changes so slowly with Ω that its derivative is left out.
    Eigen::Matrix3d slope = half_step(mean, h) *
                            (cross_matrix(mean) * moments.asDiagonal() - cross_matrix(moments.cwiseProduct(mean)));
    slope.diagonal() += moments;
    const Eigen::Vector3d next = mean - share * (slope.inverse() * error), next_error = error_of(next);
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

Eigen::Vector3d after_turn(Gyroscopic choice, const Eigen::Vector3d& spin, const Eigen::Vector3d& moments,
                           double h) {
  if (choice != Gyroscopic::implicit) return spin;
  const Eigen::Vector3d momentum = moments.cwiseProduct(spin);
  return spin + half_step(spin, h) * momentum.cross(spin).cwiseQuotient(moments);
}

}  // namespace byhand
