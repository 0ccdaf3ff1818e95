#include "lessons/laws/sweeps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lessons/laws/closed_forms.hpp"

// Laws 4 and 5 at more settings than the laws' own boundaries have.
namespace sweeps_test {

using namespace byhand;
using namespace byhand::laws;

const SweepOrder orders[] = {SweepOrder::natural, SweepOrder::reverse, SweepOrder::coloured};

TEST(Law4, ASweepInAnyOrderLeavesCosineSquaredOfPiOverTwiceTheLinks) {
  for (const int links : {2, 3, 4, 5, 7, 10, 20, 35, 50, 100})
    for (const SweepOrder order : orders)
      EXPECT_NEAR((1 - left_by_a_sweep({.links = links, .order = order})) / (1 - left_by_a_sweep(links)), 1, 0.01)
          << links << " links, order " << static_cast<int>(order);
}

TEST(Law4, ASweepOfAFreeChainInAnyOrderLeavesCosineSquaredOfPiOverItsBodies) {
  for (const int links : {2, 3, 5, 10, 20, 50})
    for (const SweepOrder order : orders) {
      const double law = std::pow(std::cos(std::numbers::pi / (links + 1)), 2);
      // In few sweeps: each makes the speed of the whole, which nothing stops, larger beside the error.
      const double left = left_by_a_sweep(scene_of({.links = links, .anchored = false}),
                                          GaussSeidel{.sweeps = 1, .warm_start = false, .order = order},
                                          15 + links * links / 4, 10);
      EXPECT_NEAR((1 - left) / (1 - law), 1, 0.01) << links << " links, order " << static_cast<int>(order);
    }
}

TEST(Law4, ADigitCostsAboutTheSquareOfTheLinks) {
  for (const int links : {10, 20, 50, 100})
    EXPECT_NEAR(-std::log(10) / std::log(left_by_a_sweep(links)) / (0.933 * links * links), 1, 0.005);
}

TEST(Law4, OfAHeavyEndASweepLeavesTheMore) {
  for (const double r : {0.01, 0.3, 1.0, 3.0, 10.0, 1000.0})
    for (const SweepOrder order : orders)
      EXPECT_NEAR(left_by_a_sweep({.links = 2, .end_mass = r, .order = order}), left_above_a_heavy_end(2, r),
                  1e-10);
  for (const int links : {5, 10, 30})
    for (const double r : {30.0, 100.0, 1000.0}) {
      const double left = left_by_a_sweep({.links = links, .end_mass = r});
      EXPECT_NEAR((1 - left) / (1 - left_above_a_heavy_end(links, r)), 1, links / r) << links << " links, " << r;
    }
}

TEST(Law4, JacobiTakesTwoSweepsForOneOfGaussSeidel) {
  for (const int links : {3, 10, 50})
    EXPECT_NEAR(left_by_a_sweep(scene_of({.links = links}), Jacobi{.sweeps = 1, .warm_start = false},
                                100 + 2 * links * links, 100),
                std::sqrt(left_by_a_sweep(links)), 1e-5);
}

TEST(Law4, TheBestRelaxationLeavesOmegaMinusOne) {
  for (const int links : {3, 10, 30, 100}) {
    const double best = 2 / (1 + std::sqrt(1 - left_by_a_sweep(links))), beyond = best + 0.5 * (2 - best);
    const auto left = [&](double omega) {
      return left_by_a_sweep(scene_of({.links = links}),
                             GaussSeidel{.sweeps = 1, .warm_start = false, .relaxation = omega}, 4000, 2000);
    };
    // At the best ω two eigenvalues meet, and k sweeps leave k (ω - 1)^k.
    EXPECT_NEAR(left(best), best - 1, 1e-3) << links;
    EXPECT_GT(left(1 + 0.9 * (best - 1)), left(best)) << links;
    EXPECT_NEAR(left(beyond), beyond - 1, 1e-3) << links;  // the same for every eigenvalue
  }
}

TEST(Law4, ADirectSolveLeavesNothing) {
  for (const int links : {2, 10, 100, 1000})
    for (const double end_mass : {1.0, 1e4}) {
      Simulation<PlaneParticle> simulation{scene_of({.links = links, .end_mass = end_mass}),
                                           {Direct{}, NoDriftCure{}}};
      simulation.step(1e-200);
      // A's condition is (2N/π)² with equal masses, and the heavy end's λ is rounded in the light bob above it.
      EXPECT_LT(residual(simulation.work.system, simulation.scene.bodies().velocity),
                1e-14 + 1e-15 * (links * links + end_mass))
          << links << " links, " << end_mass;
    }
}

TEST(Law5, TheAtlasEigenvaluesOfCollinearContacts) {
  for (const auto& [contacts, largest] : {std::pair{2, 1.2}, {3, 1.8}, {4, 2.51}, {8, 5.44}})
    EXPECT_NEAR(largest_eigenvalue(contacts), largest, 0.006) << contacts;
}

}  // namespace sweeps_test
