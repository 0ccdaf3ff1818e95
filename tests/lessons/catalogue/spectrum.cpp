#include "lessons/catalogue/spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lessons/catalogue/methods.hpp"
#include "lessons/laws/transverse.hpp"

namespace byhand {
namespace spectrum_test {

constexpr double h = 1.0 / 60, passes_one = 1 + 1e-4;

Method method_of(const char* name, Cure cure = Cure::none) {
  return family_named(name).setting(with_cure({}, cure)).method;
}
ChainOptions with_end(double mass) { return {.links = 6, .end_mass = mass}; }

// Law 7 finds the same end mass from the pivots of the chain's stiffness, without any step.
TEST(Spectrum, OfTheDirectSolvePassesOneAtLaw7sEnd) {
  const Method direct = method_of("direct", Cure::baumgarte);
  const double law = laws::heaviest_end({.links = 6, .step = h});
  EXPECT_LT(spectral_radius(with_end(0.99 * law), direct, h), passes_one);
  EXPECT_GT(spectral_radius(with_end(1.01 * law), direct, h), passes_one);
  EXPECT_TRUE(stays(with_end(0.97 * law), direct, h));
  EXPECT_FALSE(stays(with_end(1.03 * law), direct, h));
}

TEST(Spectrum, OfASymplecticMethodIsOneWhileItIsStable) {
  for (const char* name : {"RATTLE", "direct"})
    EXPECT_NEAR(spectral_radius(with_end(10), method_of(name), h), 1, 1e-6) << name;
}

// |R(iy)| ≤ 1 up to y = 2√2, where symplectic Euler has 2.
TEST(Spectrum, LetsRk4StepRootTwoTimesAsFar) {
  const auto limit = [](const Method& method) {
    return longest_step([&](double step) { return spectral_radius(with_end(100), method, step) < passes_one; },
                        0.1);
  };
  EXPECT_NEAR(limit(method_of("RK4")) / limit(method_of("direct", Cure::baumgarte)), std::sqrt(2), 0.01);
}

// |1 + iωh| = √(1 + (ωh)²): a bob's ω² is g/L.
TEST(Spectrum, OfExplicitEulerIsKnownForOneBob) {
  const ChainOptions bob{.links = 1};
  EXPECT_NEAR(spectral_radius(bob, method_of("explicit Euler"), h), std::sqrt(1 + 9.81 * h * h), 1e-8);
}

TEST(LongestStep, IsWhereAMethodStopsBeingStable) {
  EXPECT_NEAR(longest_step([](double step) { return step < 0.0123; }, 0.1), 0.0123, 2e-5);
  EXPECT_TRUE(std::isinf(longest_step([](double) { return true; }, 0.1)));
}

}  // namespace spectrum_test
}  // namespace byhand
