#include "lessons/exact/simple_pendulum.hpp"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>

#include "solver/support/require.hpp"

namespace byhand {
namespace {

struct Jacobi {
  double sn, cn;
};
Jacobi jacobi(double modulus, double u) {
  Jacobi at{};
  at.sn = boost::math::jacobi_elliptic<double, double, double>(modulus, u, &at.cn, nullptr);
  return at;
}

}  // namespace

SimplePendulum::SimplePendulum(double angle, double length, double gravity)
    : angle_(angle), length_(length), gravity_(gravity) {
  require_in("the pendulum's first angle", angle, -3.14, 3.14, "rad");
  require_positive("the pendulum's length", length, "m");
  require_positive("gravity", gravity, "m/s²");
}

double SimplePendulum::period() const {
  return 4 * std::sqrt(length_ / gravity_) * boost::math::ellint_1(std::abs(std::sin(angle_ / 2)));
}

// With u = √(g/L)·t, sn(K − u) = cn(u)/dn(u), cn(K − u) = k'·sn(u)/dn(u) and dn(K − u) = k'/dn(u) give sine
// and cosine of θ/2 and its rate without the cancellation in K − u.
double SimplePendulum::angle(double time) const {
  require_finite("time", time, "s");
  const double k = std::sin(angle_ / 2), k_prime = std::cos(angle_ / 2);
  return 2 * std::atan2(k * jacobi(std::abs(k), std::sqrt(gravity_ / length_) * time).cn, k_prime);
}

// Boost 1.74 loses the digits of dn near a quarter period; as √(k'² + k²·cn²) it keeps them.
double SimplePendulum::angular_velocity(double time) const {
  require_finite("time", time, "s");
  const double k = std::sin(angle_ / 2), k_prime = std::cos(angle_ / 2), rate = std::sqrt(gravity_ / length_);
  const Jacobi at = jacobi(std::abs(k), rate * time);
  return -2 * k * k_prime * rate * at.sn / std::hypot(k_prime, k * at.cn);
}

double SimplePendulum::tension(double time, double mass) const {
  require_positive("mass", mass, "kg");
  const double omega = angular_velocity(time);
  return mass * (gravity_ * std::cos(angle(time)) + length_ * omega * omega);
}

double SimplePendulum::energy(double mass) const {
  require_positive("mass", mass, "kg");
  return -mass * gravity_ * length_ * std::cos(angle_);
}

}  // namespace byhand
