#include <gtest/gtest.h>

#include <random>

#include "lessons/scenes/chain.hpp"
#include "tests/solver/law_motion.hpp"

// What stands beside law 6, whose limit is among the laws' boundaries: where it does not bind, and what it does
// not say.
namespace law_stability_test {

using namespace byhand;
constexpr double h = 1.0 / 60;
using Chain = Scene<PlaneParticle>;

/// A straight chain without weight whose bobs are off by about `size` [m] along it.
Simulation<PlaneParticle> disturbed(int links, const GaussSeidel& solver, double beta, double size) {
  Simulation<PlaneParticle> simulation{rod_chain<PlaneParticle, NormalisedDistance>({.links = links}),
                                       {solver, Baumgarte{beta}}};
  simulation.scene.gravity.setZero();
  std::mt19937 random(20261121);
  std::normal_distribution<double> error(0, size);
  for (int i = 1; i <= links; ++i) simulation.scene.state().pose[i].position.y() += error(random);
  return simulation;
}

// Half of the eigenvalues of a sweep are zero and share one eigenvector, so that an error that overshoots is
// passed on along the chain, and grows with every link, before it dies out: stable is not harmless.
TEST(LawB6, AColdSingleSweepMultipliesErrorsBeforeTheyDieOutIfBetaIsAboveOne) {
  const auto growth = [](int links, double beta) {
    Simulation<PlaneParticle> simulation = disturbed(links, {.sweeps = 1, .warm_start = false}, beta, 1e-9);
    const double first = position_error(simulation).rms;
    double largest = first;
    run(simulation, 200 * h, h, [&] { largest = std::max(largest, position_error(simulation).rms); });
    return largest / first;
  };
  for (const int links : {5, 10, 20}) EXPECT_EQ(growth(links, 1), 1) << links;
  EXPECT_GT(growth(10, 1.5), 5);
  EXPECT_GT(growth(20, 1.5), 1000);
  EXPECT_GT(growth(20, 1.5), 10 * growth(10, 1.5));
}

TEST(LawB6, WithoutBaumgarteAWarmStartIsStable) {
  for (const int links : {10, 20}) {
    Simulation<PlaneParticle> simulation{rod_chain<PlaneParticle, NormalisedDistance>({.links = links}),
                                         {GaussSeidel{.sweeps = 1}, NoDriftCure{}}};
    run(simulation, 100, h);
    EXPECT_LT(kinetic_energy(simulation.scene.bodies()), 1e-12) << links;
  }
}

}  // namespace law_stability_test
