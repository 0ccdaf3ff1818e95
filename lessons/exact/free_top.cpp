#include "lessons/exact/free_top.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "lessons/exact/certified_integration.hpp"
#include "solver/support/require.hpp"

namespace byhand {
namespace {

Rate eulers_equations(const Eigen::Vector3d& moments) {
  const long double I1 = moments[0], I2 = moments[1], I3 = moments[2];
  return [=](const ExtendedState& w, ExtendedState& dwdt) {
    dwdt = {(I2 - I3) / I1 * w[1] * w[2], (I3 - I1) / I2 * w[2] * w[0], (I1 - I2) / I3 * w[0] * w[1]};
  };
}

}  // namespace

FreeTop::FreeTop(const Eigen::Vector3d& moments, const Eigen::Vector3d& spin) : moments_(moments), spin_(spin) {
  for (const double moment : moments) require_positive("moment of inertia", moment, "kg m²");
  for (const double rate : spin) require_finite("spin", rate, "rad/s");
  require(!spin.isZero(0), "spin", spin.norm(), "other than zero [rad/s]");
  require(2 * moments.maxCoeff() <= moments.sum() * (1 + 1e-12), "largest moment of inertia", moments.maxCoeff(),
          "at most the sum of the other two [kg m²]");
  require(moments[0] != moments[1] && moments[1] != moments[2] && moments[2] != moments[0], "moment of inertia",
          moments[1], "different from the other two [kg m²]");
}

// The period of the middle axis's sine is 4K(k) √(I1 I2 I3 / ((I3 - I2)(L² - 2E I1))), k² = (I2 - I1)(2E I3 - L²)
// /
// ((I3 - I2)(L² - 2E I1)), where the spin goes round the axis of I3; else I1 and I3 change places. Both brackets
// are sums of squares: L² - 2E I1 = I2(I2 - I1)Ω2² + I3(I3 - I1)Ω3².
double FreeTop::period() const {
  std::array<int, 3> axis = {0, 1, 2};
  std::sort(axis.begin(), axis.end(), [&](int a, int b) { return moments_[a] < moments_[b]; });
  const double I1 = moments_[axis[0]], I2 = moments_[axis[1]], I3 = moments_[axis[2]];
  const double w1 = spin_[axis[0]], w2 = spin_[axis[1]], w3 = spin_[axis[2]];
  const double above_least = I2 * (I2 - I1) * w2 * w2 + I3 * (I3 - I1) * w3 * w3;  // L² - 2E I1
  const double below_most = I1 * (I3 - I1) * w1 * w1 + I2 * (I3 - I2) * w2 * w2;   // 2E I3 - L²
  const double larger = std::max((I3 - I2) * above_least, (I2 - I1) * below_most);
  // 1 - k², in which Ω2 cancels before it is rounded: near the middle axis all the digits are there.
  const double k_prime2 = (I3 - I1) * std::abs(I3 * (I3 - I2) * w3 * w3 - I1 * (I2 - I1) * w1 * w1) / larger;
  if (k_prime2 == 0) return std::numeric_limits<double>::infinity();
  double mean = 1, geometric = std::sqrt(k_prime2);  // K = π/2 over Gauss's mean of 1 and k'
  while (std::abs(mean - geometric) > 1e-15 * mean) {
    const double product = mean * geometric;
    mean = (mean + geometric) / 2;
    geometric = std::sqrt(product);
  }
  return 2 * std::numbers::pi / mean * std::sqrt(I1 * I2 * I3 / larger);
}

FreeTop::Spin FreeTop::at(double time) const {
  const Certified end = certified_integration(eulers_equations(moments_), {spin_[0], spin_[1], spin_[2]}, time);
  return {{end.state[0], end.state[1], end.state[2]}, end.uncertainty};
}

std::vector<Eigen::Vector3d> FreeTop::path(double end, int parts) const {
  std::vector<Eigen::Vector3d> spins;
  for (const auto& state : integrated_path(eulers_equations(moments_), {spin_[0], spin_[1], spin_[2]}, end, parts))
    spins.emplace_back(state[0], state[1], state[2]);
  return spins;
}

}  // namespace byhand
