#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <numbers>
#include <random>

#include "solver/exact/hanging_chain.hpp"
#include "solver/scenes/chain.hpp"
#include "tests/solver/law_motion.hpp"

namespace {

using namespace byhand;
constexpr double g = 9.81, h = 1.0 / 60;
using Chain = Scene<PlaneParticle, NormalisedDistance>;

/// The largest x in [low, high] at which `stable(x)` holds, if it holds up to there and not beyond.
template <class F>
double boundary(double low, double high, int halvings, F&& stable) {
  for (int i = 0; i < halvings; ++i) {
    const double middle = (low + high) / 2;
    (stable(middle) ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// A straight chain without weight whose bobs are off by about `size` [m] along it.
Simulation<Chain> disturbed(int links, const GaussSeidel& solver, double beta, double size) {
  Simulation<Chain> simulation{rod_chain<PlaneParticle, NormalisedDistance>({.links = links}),
                               {solver, Baumgarte{beta}}};
  simulation.scene.gravity.setZero();
  std::mt19937 random(20261121);
  std::normal_distribution<double> error(0, size);
  for (int i = 1; i <= links; ++i) simulation.scene.bodies.pose[i].position.y() += error(random);
  return simulation;
}

/// Whether they die out.
bool errors_die_out(int links, const GaussSeidel& solver, double beta) {
  const double size = 1e-7;
  Simulation<Chain> simulation = disturbed(links, solver, beta, size);
  const int window = 1500;
  double sums[3] = {};
  for (double& sum : sums)
    for (int i = 0; i < window; ++i) {
      simulation.step(h);
      const double rms = position_error(simulation.scene).rms;
      if (!(rms < 0.3)) return false;
      sum += rms * rms;
    }
  // Once all errors are small beside the first ones, what is left is rounding, which neither grows nor dies out.
  return sums[2] < std::max(sums[1], window * std::pow(1e-3 * size, 2));
}

struct Sweeping {
  int links, sweeps;
  double q() const { return std::pow(std::cos(std::numbers::pi / (2 * links)), 2 * sweeps); }
};

TEST(LawB6, WarmStartedBaumgarteIsStableBelowOneMinusQOverQAndBelowTwo) {
  const Sweeping cases[] = {{3, 1},   {5, 1},   {5, 4},   {10, 1}, {10, 4},
                            {10, 10}, {10, 30}, {20, 10}, {3, 8},  {10, 60}};
  for (const Sweeping& chain : cases) {
    const double law = std::min(2.0, (1 - chain.q()) / chain.q());
    const double measured = boundary(0.5 * law, std::min(1.5 * law, 2.5), 9, [&](double beta) {
      return errors_die_out(chain.links, {.sweeps = chain.sweeps}, beta);
    });
    EXPECT_NEAR(measured / law, 1, 0.01) << chain.links << " links, " << chain.sweeps << " sweeps";
  }
}

TEST(LawB6, TheAtlasLimitsOfTenLinks) {
  const auto limit = [](int sweeps) { return (1 - Sweeping{10, sweeps}.q()) / Sweeping{10, sweeps}.q(); };
  EXPECT_NEAR(limit(1), 0.0251, 5e-5);
  EXPECT_NEAR(limit(10), 0.281, 5e-4);
  EXPECT_NEAR(limit(30), 1.103, 5e-3);
}

TEST(LawB6, TheLimitHoldsForEveryOrderOfSolving) {
  const double law = (1 - Sweeping{8, 3}.q()) / Sweeping{8, 3}.q();
  for (const SweepOrder order : {SweepOrder::natural, SweepOrder::reverse, SweepOrder::coloured}) {
    EXPECT_TRUE(errors_die_out(8, {.sweeps = 3, .order = order}, 0.97 * law));
    EXPECT_FALSE(errors_die_out(8, {.sweeps = 3, .order = order}, 1.03 * law));
  }
}

TEST(LawB6, AColdStartIsStableToTwo) {
  for (const Sweeping& chain : {Sweeping{3, 1}, Sweeping{10, 1}, Sweeping{10, 10}, Sweeping{20, 4}})
    for (const double beta : {0.03, 0.2, 0.5, 1.0, 1.5, 1.8, 1.9, 2.1, 2.2})
      EXPECT_EQ(errors_die_out(chain.links, {.sweeps = chain.sweeps, .warm_start = false}, beta), beta < 2)
          << chain.links << " links, " << chain.sweeps << " sweeps, beta " << beta;
}

// Half of the eigenvalues of a sweep are zero and share one eigenvector, so that an error that overshoots is
// passed on along the chain, and grows with every link, before it dies out: stable is not harmless.
TEST(LawB6, AColdSingleSweepMultipliesErrorsBeforeTheyDieOutIfBetaIsAboveOne) {
  const auto growth = [](int links, double beta) {
    Simulation<Chain> simulation = disturbed(links, {.sweeps = 1, .warm_start = false}, beta, 1e-9);
    const double first = position_error(simulation.scene).rms;
    double largest = first;
    run(simulation, 200 * h, h, [&] { largest = std::max(largest, position_error(simulation.scene).rms); });
    return largest / first;
  };
  for (const int links : {5, 10, 20}) EXPECT_EQ(growth(links, 1), 1) << links;
  EXPECT_GT(growth(10, 1.5), 5);
  EXPECT_GT(growth(20, 1.5), 1000);
  EXPECT_GT(growth(20, 1.5), 10 * growth(10, 1.5));
}

TEST(LawB6, WithoutBaumgarteAWarmStartIsStable) {
  for (const Sweeping& chain : {Sweeping{10, 1}, Sweeping{20, 1}}) {
    Simulation<Chain> simulation{rod_chain<PlaneParticle, NormalisedDistance>({.links = chain.links}),
                                 {GaussSeidel{.sweeps = chain.sweeps}, NoDriftCure{}}};
    run(simulation, 100, h);
    EXPECT_LT(kinetic_energy(simulation.scene.bodies), 1e-12) << chain.links;
  }
}

constexpr int links = 6;

/// The largest rate at which a hanging chain of unit links swings sideways [rad/s]: a string of bobs under
/// tension.
double fastest_swing(double end_mass) {
  std::vector<double> masses(links, 1.0);
  masses.back() = end_mass;
  const std::vector<double> tension = hanging_chain_tensions(masses, g);
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(links, links);
  for (int i = 0; i < links; ++i) {
    K(i, i) = tension[i] / masses[i];
    if (i == links - 1) continue;
    K(i, i) += tension[i + 1] / masses[i];
    K(i, i + 1) = K(i + 1, i) = -tension[i + 1] / std::sqrt(masses[i] * masses[i + 1]);
  }
  return std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K).eigenvalues()[links - 1]);
}

bool stays_straight(const RowSolver& solver, double end_mass, double step) {
  Simulation<Chain> simulation{
      rod_chain<PlaneParticle, NormalisedDistance>({.links = links, .end_mass = end_mass}),
      {solver, Baumgarte{0.2}}};
  std::mt19937 random(20261121);
  std::normal_distribution<double> sideways(0, 1e-8);
  for (int i = 1; i <= links; ++i) simulation.scene.bodies.pose[i].position.x() = sideways(random);
  for (int i = 0; i < 1000; ++i) {
    simulation.step(step);
    for (int body = 1; body <= links; ++body)
      if (!(std::abs(simulation.scene.bodies.pose[body].position.x()) < 1e-5)) return false;
  }
  return true;
}

/// The heaviest end whose fastest swing keeps ω_max h below 2.
double law_of_the_end_mass(double step) {
  return boundary(1, 1e5, 60, [&](double end_mass) { return fastest_swing(end_mass) * step < 2; });
}

TEST(LawB7, AnExactlySolvedChainExplodesWhereItsFastestSwingTimesTheStepIsTwo) {
  for (const double step : {1.0 / 30, 1.0 / 60, 1.0 / 120}) {
    const double law = law_of_the_end_mass(step);
    for (const double below : {0.01, 0.1, 0.5, 0.9, 0.99})
      EXPECT_TRUE(stays_straight(Direct{}, below * law, step));
    for (const double beyond : {1.01, 1.1, 2.0, 10.0}) EXPECT_FALSE(stays_straight(Direct{}, beyond * law, step));
  }
}

TEST(LawB7, TheTensionAtTheLimitIsAboutTheLinksMassTimesLengthOverTheStepSquared) {
  EXPECT_NEAR(law_of_the_end_mass(h) * g * h * h, 1, 0.1);
}

TEST(LawB7, HalvingTheStepAllowsFourTimesTheMass) {
  const auto heaviest = [](double step, double guess) {
    return boundary(guess / 2, guess * 2, 10, [&](double mass) { return stays_straight(Direct{}, mass, step); });
  };
  const double coarse = heaviest(h, 400), fine = heaviest(h / 2, 1600);
  EXPECT_NEAR(coarse / law_of_the_end_mass(h), 1, 0.005);
  // The tension also holds the links' own weight, which does not grow.
  EXPECT_NEAR((fine + links) / (coarse + links), 4, 0.1);
}

TEST(LawB7, MoreSweepsCannotHelp) {
  const double law = law_of_the_end_mass(h);
  for (const int sweeps : {100, 1000, 10'000}) EXPECT_FALSE(stays_straight(GaussSeidel{sweeps}, 1.2 * law, h));
  for (const int substeps : {2, 4}) EXPECT_TRUE(stays_straight(Direct{}, 1.2 * law, h / substeps));
}

}  // namespace
