#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "lessons/scenes/box_on_contacts.hpp"
#include "lessons/scenes/chain.hpp"
#include "tests/solver/law_motion.hpp"

namespace {

using namespace byhand;
constexpr double pi = std::numbers::pi;
using Chain = Scene<PlaneParticle>;

/// A straight chain without weight whose bobs fly up and down at random: sweeps have everything to stop.
Chain disturbed_chain(int links, double end_mass = 1, bool anchored = true) {
  Chain scene = rod_chain<PlaneParticle, NormalisedDistance>({.links = links, .end_mass = end_mass});
  scene.gravity.setZero();
  if (!anchored) scene.set_mass(0, with_mass<PlaneParticle>(1));
  std::mt19937 random(20261121);
  std::normal_distribution<double> speed;
  for (int i = anchored ? 1 : 0; i <= links; ++i) scene.state().velocity[i].y() = speed(random);
  return scene;
}

/// The factor by which one cold sweep shrinks the error in the long run: a power iteration. The time step is so
/// short that nothing moves, so that one step is one sweep.
template <class M>
double rate(Scene<M> scene, const RowSolver& one_sweep, int settle, int measure) {
  Simulation simulation{std::move(scene), {one_sweep, NoDriftCure{}}};
  double log_sum = 0;
  for (int i = 0; i < settle + measure; ++i) {
    simulation.step(1e-200);
    // What a further sweep would find wrong: after the last row of a sweep that row itself is right.
    const double error = residual(simulation.work.system, simulation.scene.bodies().velocity);
    if (error == 0) return 0;
    for (auto& v : simulation.scene.state().velocity) v /= error;
    if (i >= settle) log_sum += std::log(error);
  }
  return std::exp(log_sum / measure);
}
GaussSeidel one_sweep(SweepOrder order = SweepOrder::natural, double relaxation = 1) {
  return {.sweeps = 1, .warm_start = false, .order = order, .relaxation = relaxation};
}

const SweepOrder orders[] = {SweepOrder::natural, SweepOrder::reverse, SweepOrder::coloured};

TEST(LawB4, OnAnAnchoredChainASweepLeavesCosineSquaredOfPiOverTwiceItsLinks) {
  for (const int links : {2, 3, 4, 5, 7, 10, 20, 35, 50, 100}) {
    const double law = std::pow(std::cos(pi / (2 * links)), 2);
    for (const SweepOrder order : orders) {
      const double measured = rate(disturbed_chain(links), one_sweep(order), 40 + links * links, 50);
      EXPECT_NEAR((1 - measured) / (1 - law), 1, 0.01) << links << " links, order " << static_cast<int>(order);
    }
  }
}

TEST(LawB4, OneMoreDigitCostsAboutTheSquareOfTheLinks) {
  for (const int links : {10, 20, 50, 100}) {
    const double sweeps =
        -std::log(10) / std::log(rate(disturbed_chain(links), one_sweep(), 40 + links * links, 50));
    EXPECT_NEAR(sweeps / (0.933 * links * links), 1, 0.01) << links;
  }
}

TEST(LawB4, OnAFreeChainASweepLeavesCosineSquaredOfPiOverItsBodies) {
  for (const int links : {2, 3, 5, 10, 20, 50}) {
    const double law = std::pow(std::cos(pi / (links + 1)), 2);
    for (const SweepOrder order : orders) {
      const double measured = rate(disturbed_chain(links, 1, false), one_sweep(order), 15 + links * links / 4, 10);
      EXPECT_NEAR((1 - measured) / (1 - law), 1, 0.01) << links << " links, order " << static_cast<int>(order);
    }
  }
}

// 1 - ρ is 1/(r(N - 1)) up to terms in 1/r.
TEST(LawB4, AHeavyEndSlowsASweepInProportion) {
  for (const int links : {2, 5, 10, 30})
    for (const double end_mass : {30.0, 100.0, 1000.0}) {
      const double measured = rate(disturbed_chain(links, end_mass), one_sweep(), 40 + 4 * links * links, 50);
      EXPECT_NEAR((1 - measured) * end_mass * (links - 1), 1, links / end_mass) << links << " links, " << end_mass;
    }
}

TEST(LawB4, ALightBobAboveAHeavyOneLeavesTheHeavyOnesShare) {
  for (const double r : {0.01, 0.3, 1.0, 3.0, 10.0, 1000.0})
    for (const SweepOrder order : orders)
      EXPECT_NEAR(rate(disturbed_chain(2, r), one_sweep(order), 5, 20), r / (1 + r), 1e-10) << r;
}

/// Largest eigenvalue of Jacobi on a chain of `links`, anchored.
double jacobi_rate(int links) { return std::cos(pi / (2 * links)); }

TEST(LawB4, JacobiTakesTwoSweepsForOneOfGaussSeidel) {
  for (const int links : {3, 10, 50})
    EXPECT_NEAR(
        rate(disturbed_chain(links), Jacobi{.sweeps = 1, .warm_start = false}, 100 + 2 * links * links, 100),
        jacobi_rate(links), 1e-5);
}

TEST(LawB4, TheBestRelaxationLeavesOmegaMinusOne) {
  for (const int links : {3, 10, 30, 100}) {
    const double best = 2 / (1 + std::sqrt(1 - std::pow(jacobi_rate(links), 2)));
    const auto measured = [&](double omega) {
      return rate(disturbed_chain(links), one_sweep(SweepOrder::natural, omega), 4000, 2000);
    };
    // At the best ω two eigenvalues meet, and k sweeps leave k (ω - 1)^k.
    EXPECT_NEAR(measured(best), best - 1, 1e-3) << links;
    EXPECT_GT(measured(1 + 0.9 * (best - 1)), measured(best)) << links;
    const double beyond = best + 0.5 * (2 - best);
    EXPECT_NEAR(measured(beyond), beyond - 1, 1e-3) << links;  // the same for every eigenvalue
  }
}

TEST(LawB4, ADirectSolveLeavesNothing) {
  for (const int links : {2, 10, 100, 1000})
    for (const double end_mass : {1.0, 1e4}) {
      Simulation<PlaneParticle> simulation{disturbed_chain(links, end_mass), {Direct{}, NoDriftCure{}}};
      simulation.step(1e-200);
      // A's condition is (2N/π)² with equal masses, and the heavy end's λ is rounded in the light bob above it.
      EXPECT_LT(residual(simulation.work.system, simulation.scene.bodies().velocity),
                1e-14 + 1e-15 * (links * links + end_mass))
          << links << " links, " << end_mass;
    }
}

/// The rows of a box on k contacts without their bounds: rods of unit length, straight down from the same points.
Scene<PlaneBody> box_on_stilts(int contacts) {
  using M = PlaneBody;
  Scene<M> scene = box_on_contacts(contacts);
  while (scene.count() > 0) scene.remove(scene.entries()[0].id);
  scene.gravity.setZero();
  for (int i = 0; i < contacts; ++i) {
    const Linear<M> top(static_cast<double>(i) / (contacts - 1) - 0.5, 0), foot = top - Linear<M>(0, 1);
    scene.add(NormalisedDistance<M>{between<M>(scene.bodies(), 0, foot, 1, top), 1});
  }
  scene.state().velocity[1] = {0, -1, 0.3};
  return scene;
}
Jacobi one_jacobi_sweep(double relaxation = 1) {
  return {.sweeps = 1, .warm_start = false, .relaxation = relaxation};
}

struct Eigenvalue {
  int contacts;
  double largest;  // of D⁻¹A
};
const Eigenvalue eigenvalues[] = {{2, 1.2}, {3, 1.8}, {4, 2.51}, {8, 5.44}};

TEST(LawB5, JacobiOnCollinearContactsHasTheAtlasEigenvalues) {
  for (const auto [contacts, largest] : eigenvalues)
    EXPECT_NEAR(rate(box_on_stilts(contacts), one_jacobi_sweep(), 100, 100), largest - 1, 0.006) << contacts;
}

TEST(LawB5, JacobiConvergesIffTheRelaxedEigenvalueIsBelowTwo) {
  for (const auto [contacts, _] : eigenvalues) {
    const double largest = rate(box_on_stilts(contacts), one_jacobi_sweep(), 100, 100) + 1;
    for (const double side : {0.9, 0.99, 1.01, 1.1}) {
      const double relaxation = side * 2 / largest;
      if (relaxation >= 2) continue;
      const double factor = rate(box_on_stilts(contacts), one_jacobi_sweep(relaxation), 1000, 100);
      EXPECT_EQ(factor < 1, side < 1) << contacts << " contacts, relaxation " << relaxation;
    }
  }
}

/// What Jacobi leaves of the fall of a box on real contacts in one cold step.
double fall_left(int contacts, double relaxation) {
  Simulation<PlaneBody> simulation{box_on_contacts(contacts),
                                   {Jacobi{.sweeps = 2000, .relaxation = relaxation}, NoDriftCure{}}};
  simulation.step(1.0 / 60);
  return residual(simulation.work.system, simulation.scene.bodies().velocity) / (9.81 / 60);
}

TEST(LawB5, FourContactsNeedARelaxationBelowEightTenths) {
  for (const double relaxation : {0.3, 0.6, 0.785}) EXPECT_LT(fall_left(4, relaxation), 1e-6) << relaxation;
  for (const double relaxation : {0.805, 0.9, 1.0, 1.5}) EXPECT_GT(fall_left(4, relaxation), 0.01) << relaxation;
  double stable = 0.5, unstable = 1;
  for (int i = 0; i < 20; ++i) {
    const double middle = (stable + unstable) / 2;
    (rate(box_on_stilts(4), one_jacobi_sweep(middle), 2000, 100) < 1 ? stable : unstable) = middle;
  }
  EXPECT_NEAR(stable, 0.795, 1e-3);
}

TEST(LawB5, TwoAndThreeContactsConvergeAndEightDoNot) {
  EXPECT_LT(fall_left(2, 1), 1e-12);
  EXPECT_LT(fall_left(3, 1), 1e-12);
  EXPECT_GT(fall_left(8, 1), 0.01);
}

}  // namespace
