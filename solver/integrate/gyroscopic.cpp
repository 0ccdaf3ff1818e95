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
  Vector inverse_moments, moments;
  double largest_turn;  // [rad]

  /// With a larger turn Newton's method may fail. The ratios |I₂ - I₃|/I₁, … are at most 1 for any real body.
  explicit Turning(const Vector& inverse) : inverse_moments(inverse), moments(inverse.cwiseInverse()) {
    const double x = std::abs(inverse[1] - inverse[2]) * inverse[0] * inverse[0],
                 y = std::abs(inverse[2] - inverse[0]) * inverse[1] * inverse[1],
                 z = std::abs(inverse[0] - inverse[1]) * inverse[2] * inverse[2], product = inverse.prod();
    largest_turn = product / std::max({product, x, y, z});
  }

  /// The part of a time h [s] that one axis serves.
  double part(const Vector& spin, double h) const {
    return h * spin.norm() > largest_turn ? largest_turn / spin.norm() : h;
  }

  struct Share {
    double value, slope;  // slope by ½|Ω|²
  };
  /// ½ h f for that part of h.
  Share half_step(const Vector& spin, double h) const {
    const double square = spin.squaredNorm(), z = h * h * square;  // θ²
    if (z < 1e-2 && largest_turn > 0.1) {                          // the series of the tangent
      constexpr double a = 1 / 12.0, b = 1 / 120.0, c = 17 / 20160.0, d = 31 / 362880.0, e = 691 / 79833600.0;
      return {h / 2 * (1 + z * (a + z * (b + z * (c + z * (d + z * e))))),
              h * h * h * (a + z * (2 * b + z * (3 * c + z * 4 * d)))};
    }
    const double rate = std::sqrt(square), theta = h * rate;
    const bool whole = theta <= largest_turn;
    const auto [sin, cos] = sin_cos(std::min(theta, largest_turn) / 2);
    const double tan = sin / cos, value = tan / rate;
    return {value, ((whole ? h / 2 * (1 + tan * tan) : 0) - value) / square};
  }

  Vector explicit_turn(const Vector& spin, double h) const {
    return spin + h * moments.cwiseProduct(spin).cross(spin).cwiseProduct(inverse_moments);
  }

  /// Ω [rad/s] from Ω₀.
  Vector mean(const Vector& spin, double h) const {
    const Vector momentum = moments.cwiseProduct(spin);
    const auto error_of = [&](const Vector& mean) {
      const Vector mean_momentum = moments.cwiseProduct(mean);
      return Vector(mean_momentum + half_step(mean, h).value * mean.cross(mean_momentum) - momentum);
    };
    const auto energy_of = [&](const Vector& change) { return change.dot(change.cwiseProduct(inverse_moments)); };
    const double rounding = 1e-32 * energy_of(momentum);
    Vector mean = spin, error = error_of(mean);
    double size = energy_of(error), share = 1;  // of Newton's step: reduced when a whole step overshoots
    for (int i = 0; i < 50 && size > rounding && share > 1e-3; ++i) {
      const Share half = half_step(mean, h);
      const Vector mean_momentum = moments.cwiseProduct(mean);
      Eigen::Matrix3d slope =
          half.value * (cross_matrix(mean) * moments.asDiagonal() - cross_matrix(mean_momentum));
      slope += half.slope * mean.cross(mean_momentum) * mean.transpose();
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
    return spin + half_step(spin, h).value * moments.cwiseProduct(spin).cross(spin).cwiseProduct(inverse_moments);
  }
};

/// Calls change(moments, Ω, pose, ω) for each body that moves and for which Ω × IΩ is not zero.
template <class F>
void for_each_turning(Bodies<SpaceBody>& bodies, F&& change) {
  for (int i = 0; i < bodies.size(); ++i) {
    const Vector& inverse = bodies.inverse_mass[i].angular;
    const double x = inverse.y() - inverse.z(), y = inverse.z() - inverse.x(), z = inverse.x() - inverse.y();
    if ((x == 0 && y == 0 && z == 0) || !moves(bodies.inverse_mass[i])) continue;
    auto& q = bodies.pose[i].rotation;
    auto omega = bodies.velocity[i].tail<3>();
    const Vector spin = rotate(byhand::inverse(q), omega);
    if (x * spin.y() * spin.z() == 0 && y * spin.z() * spin.x() == 0 && z * spin.x() * spin.y() == 0) continue;
    change(Turning(inverse), spin, q, omega);
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
      if (!(angle <= 1e5)) throw NotFinite("a step turns a body by " + text_of(angle) + " rad, more than 100000");
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
