#include "lessons/exact/double_pendulum.hpp"

#include <cmath>

#include "lessons/exact/certified_integration.hpp"
#include "solver/support/require.hpp"

namespace byhand {

DoublePendulum::DoublePendulum(const State& start, const Eigen::Vector2d& lengths, const Eigen::Vector2d& masses,
                               double gravity)
    : start_(start), lengths_(lengths), masses_(masses), gravity_(gravity) {
  for (int i = 0; i < 2; ++i) {
    require_finite("an angle of the double pendulum", start.angles[i], "rad");
    require_finite("an angular velocity of the double pendulum", start.angular_velocities[i], "rad/s");
    require_positive("a length of the double pendulum", lengths[i], "m");
    require_positive("a mass of the double pendulum", masses[i], "kg");
  }
  require_positive("gravity", gravity, "m/s²");
}

// Lagrange's equations divided by m2: with δ = θ1 − θ2 and M = (m1 + m2)/m2,
//   M·l1²·θ̈1 + l1·l2·cosδ·θ̈2 = −l1·l2·sinδ·θ̇2² − M·g·l1·sinθ1
//   l1·l2·cosδ·θ̈1 + l2²·θ̈2   =  l1·l2·sinδ·θ̇1² − g·l2·sinθ2
DoublePendulum::State DoublePendulum::at(double time) const {
  const long double l1 = lengths_[0], l2 = lengths_[1], g = gravity_;
  const long double M = 1 + static_cast<long double>(masses_[0]) / masses_[1];
  const auto rate = [=](const ExtendedState& x, ExtendedState& dxdt) {
    const long double sine = std::sin(x[0] - x[1]), cosine = std::cos(x[0] - x[1]);
    const long double f1 = -l2 * sine * x[3] * x[3] - M * g * std::sin(x[0]);
    const long double f2 = l1 * sine * x[2] * x[2] - g * std::sin(x[1]);
    const long double determinant = M - cosine * cosine;
    dxdt = {x[2], x[3], (f1 - cosine * f2) / (l1 * determinant), (M * f2 - cosine * f1) / (l2 * determinant)};
  };
  const Certified end = certified_integration(
      rate, {start_.angles[0], start_.angles[1], start_.angular_velocities[0], start_.angular_velocities[1]},
      time);
  return {{end.state[0], end.state[1]}, {end.state[2], end.state[3]}, end.uncertainty};
}

double DoublePendulum::energy(const State& state) const {
  const auto turn = [](double theta) { return Eigen::Vector2d(std::cos(theta), std::sin(theta)); };
  const Eigen::Vector2d v1 = lengths_[0] * state.angular_velocities[0] * turn(state.angles[0]);
  const Eigen::Vector2d v2 = v1 + lengths_[1] * state.angular_velocities[1] * turn(state.angles[1]);
  const double y1 = -lengths_[0] * std::cos(state.angles[0]), y2 = y1 - lengths_[1] * std::cos(state.angles[1]);
  return masses_[0] * (v1.squaredNorm() / 2 + gravity_ * y1) + masses_[1] * (v2.squaredNorm() / 2 + gravity_ * y2);
}

}  // namespace byhand
