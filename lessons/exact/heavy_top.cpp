#include "lessons/exact/heavy_top.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "solver/support/require.hpp"

namespace byhand {
namespace {

void require_valid(const HeavyTop& top, double angle) {
  require_positive("mass", top.mass, "kg");
  require_positive("the top's arm", top.arm, "m");
  require_positive("the top's moment along its axis", top.moment_along, "kg m²");
  require_finite("spin", top.spin, "rad/s");
  require_positive("gravity", top.gravity, "m/s²");
  require(top.moment_across > top.mass * top.arm * top.arm, "the top's moment across its axis", top.moment_across,
          "above m a² [kg m²], for it is about the tip");
  require_in("the top's lean", angle, 0, std::numbers::pi, "rad");
}

}  // namespace

double HeavyTop::least_spin(double angle) const {
  require_valid(*this, angle);
  const double turning = 4 * moment_across * mass * gravity * arm * std::cos(angle);
  return std::sqrt(std::max(turning, 0.0)) / moment_along;
}

// The two roots as 2c/(b ± √(b² - 4ac)) and (b ± √…)/(2a): each without cancellation.
std::array<double, 2> HeavyTop::precession(double angle) const {
  const double least = least_spin(angle);
  require(std::abs(spin) >= least && spin != 0, "spin", spin,
          fmt::format("at least {} in size and not zero, or the top falls [rad/s]", least));
  const double a = moment_across * std::cos(angle), b = moment_along * spin, c = mass * gravity * arm;
  const double q = (b + std::copysign(std::sqrt(std::max(b * b - 4 * a * c, 0.0)), b)) / 2;
  const double level = 1e-12 * moment_across;
  return {c / q, std::abs(a) > level ? q / a : std::copysign(std::numeric_limits<double>::infinity(), b)};
}

}  // namespace byhand
