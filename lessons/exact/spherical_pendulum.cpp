#include "lessons/exact/spherical_pendulum.hpp"

#include <algorithm>
#include <boost/math/special_functions/ellint_1.hpp>
#include <cmath>
#include <numbers>

#include "solver/support/require.hpp"

namespace byhand {
namespace {

/// The roots of u̇² beside u0, those of u² + c·(u + u0) − 1 with c = (φ̇0·sinθ0)²·L/(2g).
struct Roots {
  double other, beyond;  // the other cone, and one below −1 that is no angle
};
Roots roots(double u0, double c) {
  const double half_width = std::sqrt(c * c / 4 - c * u0 + 1), beyond = -c / 2 - half_width;
  return {(c * u0 - 1) / beyond, beyond};
}

}  // namespace

SphericalPendulum::SphericalPendulum(double angle, double azimuth_rate, double length, double gravity)
    : angle_(angle), azimuth_rate_(azimuth_rate), length_(length), gravity_(gravity) {
  require(0 < angle && angle < std::numbers::pi, "the pendulum's first angle", angle, "above 0 and below π [rad]");
  require(std::isfinite(azimuth_rate) && azimuth_rate != 0, "the pendulum's rate about the vertical", azimuth_rate,
          "a finite number other than 0 [rad/s]");
  require_positive("the pendulum's length", length, "m");
  require_positive("gravity", gravity, "m/s²");
}

double SphericalPendulum::other_angle() const {
  const double sideways = azimuth_rate_ * std::sin(angle_);
  return std::acos(roots(std::cos(angle_), sideways * sideways * length_ / (2 * gravity_)).other);
}

// u̇² = 2(g/L)·(u − beyond)·(u − low)·(high − u), whose integral over a swing is a complete elliptic one.
double SphericalPendulum::nutation_period() const {
  const double u0 = std::cos(angle_), sideways = azimuth_rate_ * std::sin(angle_);
  const auto [other, beyond] = roots(u0, sideways * sideways * length_ / (2 * gravity_));
  const double span = std::max(u0, other) - beyond;
  return 4 * std::sqrt(length_ / (2 * gravity_ * span)) *
         boost::math::ellint_1(std::sqrt(std::abs(u0 - other) / span));
}

long double SphericalPendulum::momentum() const {
  const long double sine = std::sin(static_cast<long double>(angle_));
  return sine * sine * azimuth_rate_;
}

// θ̈ = φ̇²·sinθ·cosθ − (g/L)·sinθ with φ̇ from the angular momentum.
Rate SphericalPendulum::rate() const {
  const long double g_over_l = static_cast<long double>(gravity_) / length_, momentum = this->momentum();
  return [=](const ExtendedState& x, ExtendedState& dxdt) {
    const long double sine = std::sin(x[0]), azimuth_rate = momentum / (sine * sine);
    dxdt = {x[2], azimuth_rate, sine * (azimuth_rate * azimuth_rate * std::cos(x[0]) - g_over_l)};
  };
}

SphericalPendulum::State SphericalPendulum::at(double time) const {
  const Certified end = certified_integration(rate(), {angle_, 0, 0}, time);
  const double sine = std::sin(end.state[0]);
  return {end.state[0], end.state[1], end.state[2], static_cast<double>(momentum()) / (sine * sine),
          end.uncertainty};
}

std::vector<double> SphericalPendulum::angles(double end, int parts) const {
  std::vector<double> all;
  for (const auto& state : integrated_path(rate(), {angle_, 0, 0}, end, parts)) all.push_back(state[0]);
  return all;
}

double SphericalPendulum::energy(double mass) const {
  require_positive("mass", mass, "kg");
  const double speed = length_ * azimuth_rate_ * std::sin(angle_);
  return mass * (speed * speed / 2 - gravity_ * length_ * std::cos(angle_));
}

double SphericalPendulum::angular_momentum(double mass) const {
  require_positive("mass", mass, "kg");
  const double radius = length_ * std::sin(angle_);
  return mass * radius * radius * azimuth_rate_;
}

}  // namespace byhand
