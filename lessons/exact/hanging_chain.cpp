#include "lessons/exact/hanging_chain.hpp"

#include <numeric>

#include "solver/support/require.hpp"

namespace byhand {

std::vector<double> hanging_chain_tensions(std::span<const double> masses, double gravity) {
  require_positive("gravity", gravity, "m/s²");
  for (const double mass : masses) require_positive("the mass of a link", mass, "kg");
  std::vector<double> tensions(masses.begin(), masses.end());
  std::partial_sum(tensions.rbegin(), tensions.rend(), tensions.rbegin());
  for (double& tension : tensions) tension *= gravity;
  return tensions;
}

}  // namespace byhand
