#include "solver/integrate/gyroscopic.hpp"

#include <algorithm>

#include "solver/support/require.hpp"

namespace byhand {
namespace {

using Vector = Eigen::Vector3d;

/// [v]×, the matrix of v × ….
Eigen::Matrix3d cross_matrix(const Vector& v) {
  Eigen::Matrix3d matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
}

/// A body's principal moments [kg m²], in whose axes all vectors below are, and the largest turn about one axis.
struct Turning {
  Vector moments;
  double largest_turn;  // [rad]

  /// With a larger turn Newton's method may fail. The ratios are at most 1 for any real body.
  explicit Turning(const Vector& I)
      : moments(I),
        largest_turn(1 / std::max({1.0, std::abs(I[1] - I[2]) / I[0], std::abs(I[2] - I[0]) / I[1],
                                   std::abs(I[0] - I[1]) / I[2]})) {}

  /// The part of a time h [s] that one axis serves.
  double part(const Vector& spin, double h) const {
    return h * spin.norm() > largest_turn ? largest_turn / spin.norm() : h;
  }

  struct Share {
    double value, slope;  // slope by |Ω|
  };
  /// ½ h f for that part of h.
  Share half_step(const Vector& spin, double h) const {
    const double rate = spin.norm(), theta = h * rate;
    const bool whole = theta <= largest_turn;
    if (whole && theta < 1e-4) return {h / 2 * (1 + theta * theta / 12), h * h * theta / 12};
    const auto [sin, cos] = sin_cos(std::min(theta, largest_turn) / 2);
    const double tan = sin / cos, value = whole ? h * sin / (cos * theta) : tan / rate;
    return {value, ((whole ? h / 2 * (1 + tan * tan) : 0) - value) / rate};
  }

  Vector explicit_turn(const Vector& spin, double h) const {
    return spin + h * moments.cwiseProduct(spin).cross(spin).cwiseQuotient(moments);
  }

  /// Ω [rad/s] from Ω₀.
  Vector mean(const Vector& spin, double h) const {
    const Vector momentum = moments.cwiseProduct(spin);
    const auto error_of = [&](const Vector& mean) {
      const Vector mean_momentum = moments.cwiseProduct(mean);
      return Vector(mean_momentum + half_step(mean, h).value * mean.cross(mean_momentum) - momentum);
    };
    const auto energy_of = [&](const Vector& change) { return change.dot(change.cwiseQuotient(moments)); };
    const double rounding = 1e-32 * energy_of(momentum);
    Vector mean = spin, error = error_of(mean);
    double size = energy_of(error), share = 1;  // of Newton's step: reduced when a whole step overshoots
    for (int i = 0; i < 50 && size > rounding && share > 1e-3; ++i) {
      const Share half = half_step(mean, h);
      const Vector mean_momentum = moments.cwiseProduct(mean);
      Eigen::Matrix3d slope =
          half.value * (cross_matrix(mean) * moments.asDiagonal() - cross_matrix(mean_momentum));
      slope += half.slope / mean.norm() * mean.cross(mean_momentum) * mean.transpose();
      slope.diagonal() += moments;
      const Vector next = mean - share * (slope.inverse() * error), next_error = error_of(next);
      const double next_size = energy_of(next_error);
      if (next_size < size) {
        mean = next;
        error = next_error;
        size = next_size;
        share = 1;
      } else {
        share /= 4;
      }
    }
    return mean;
  }

  /// Ω₁ [rad/s] from Ω.
  Vector after(const Vector& spin, double h) const {
    return spin + half_step(spin, h).value * moments.cwiseProduct(spin).cross(spin).cwiseQuotient(moments);
  }
};

/// Calls change(body's moments and its Ω, pose, ω) for each body that moves and has such a term.
template <class F>
void for_each_turning(Bodies<SpaceBody>& bodies, F&& change) {
  for (int i = 0; i < bodies.size(); ++i) {
    const Vector& inverse_moments = bodies.inverse_mass[i].angular;
    if (!moves(bodies.inverse_mass[i]) || (inverse_moments.array() == inverse_moments[0]).all()) continue;
    Eigen::Quaterniond& q = bodies.pose[i].rotation;
    auto omega = bodies.velocity[i].tail<3>();
    change(Turning(inverse_moments.cwiseInverse()), rotate(inverse(q), omega), q, omega);
  }
}

}  // namespace

void begin_turn(Gyroscopic choice, Bodies<SpaceBody>& bodies, double h) {
  if (choice == Gyroscopic::none) return;
  for_each_turning(bodies, [&](const Turning& body, const Vector& spin, const auto& q, auto omega) {
    const Vector next = choice == Gyroscopic::implicit ? body.mean(spin, h) : body.explicit_turn(spin, h);
    omega += rotate(q, next - spin);  // only the change, or rounding of |q| accumulates
  });
}

void end_turn(Gyroscopic choice, Bodies<SpaceBody>& bodies, double h) {
  if (choice != Gyroscopic::implicit) return;
  for_each_turning(bodies, [&](const Turning& body, const Vector& spin, auto& q, auto omega) {
    Vector now = body.after(spin, h), before = spin;
    if (double left = h - body.part(spin, h); left > 0) {
      const double angle = h * spin.norm();
      require(angle <= 1e5, "turn of a body in a step", angle, "at most 100000 rad: take a smaller step");
      const auto turn = [&](const Vector& by, double time) { q = rotated_by(q, Vector(rotate(q, time * by))); };
      turn(spin, -left);  // the poses have moved for the whole of h
      while (left > 0) {
        const Vector mean = body.mean(now, left);
        const double part = body.part(mean, left);
        turn(mean, part);
        now = body.after(mean, left);
        left -= part;
      }
      before = rotate(inverse(q), omega);
    }
    omega += rotate(q, now - before);
  });
}

}  // namespace byhand
