#include <gtest/gtest.h>

#include <cmath>

#include "lessons/laws/buckling.hpp"
#include "lessons/laws/closed_forms.hpp"
#include "lessons/laws/column.hpp"
#include "lessons/laws/creep.hpp"
#include "lessons/laws/hopping.hpp"
#include "lessons/laws/law.hpp"
#include "lessons/laws/numbers.hpp"
#include "lessons/laws/pop.hpp"
#include "lessons/laws/record.hpp"
#include "lessons/laws/spin.hpp"
#include "lessons/laws/sweeps.hpp"
#include "lessons/laws/transverse.hpp"
#include "lessons/laws/warm_start.hpp"
#include "lessons/scenes/chain.hpp"
#include "solver/rows/gauss_seidel.hpp"
#include "solver/step.hpp"

// Each law of lesson 8: where it says, on both sides of that, and where its experiment finds it.
namespace laws_test {

using namespace byhand::laws;
using byhand::SweepOrder;

const Law& law(int number) {
  static const std::vector<Law> laws = all();
  for (const Law& candidate : laws)
    if (candidate.number == number) return candidate;
  throw std::out_of_range("no such law");
}

/// A run at either side of each boundary, and the boundary itself.
void expect_law(int number) {
  ASSERT_GE(law(number).boundaries.size(), 2U) << "one point is no law";
  for (const Boundary& boundary : law(number).boundaries) {
    SCOPED_TRACE(boundary.quantity + ", " + boundary.setting);
    const double law_says = boundary.predicted, within = boundary.tolerance;
    if (boundary.holds) {
      EXPECT_TRUE(boundary.holds(law_says * (1 - within)));
      EXPECT_FALSE(boundary.holds(law_says * (1 + within)));
    }
    EXPECT_NEAR(boundary.measured() / law_says, 1, within);
  }
}

TEST(Law1, ACorrectionOvershootsBeyondOneAndDivergesBeyondTwo) { expect_law(1); }
TEST(Law2, AContactPopsOffTheGroundBeyondTheCriticalOverlap) { expect_law(2); }
TEST(Law3, WithoutACureTheDistanceGrowsToItsFourthRoot) { expect_law(3); }
TEST(Law4, ADigitCostsTheSquareOfTheLinksInSweeps) { expect_law(4); }
// The experiment answers for a relaxation of 2 and more without a run, as a single row diverges there: every
// boundary, and the side of it that is tried, has to lie below.
TEST(Law5, JacobiDivergesBeyondTwoOverTheLargestEigenvalue) {
  expect_law(5);
  for (const Boundary& boundary : law(5).boundaries) {
    EXPECT_LT(boundary.predicted * (1 + boundary.tolerance), 2) << boundary.setting;
    EXPECT_LT(boundary.measured(), 1.99) << boundary.setting;
  }
}
TEST(Law6, WarmStartRingsBeyondOneMinusQOverQ) { expect_law(6); }
TEST(Law7, AnExactlySolvedChainExplodesWhereItsFastestSwingTimesTheStepIsTwo) { expect_law(7); }
TEST(Law8, PullsOfConflictingRodsGrowAsTheirLengthsDifferUnlessTheyAreSoft) { expect_law(8); }
TEST(Law9, NothingHeavierThanAboutThreeTimesTheSweepsSettles) { expect_law(9); }
TEST(Law10, FrictionInASquareStopsADiagonalSlideEarly) { expect_law(10); }
TEST(Law11, ExplicitSpringsAndSoftChainsHaveALargestFrequency) { expect_law(11); }
TEST(Law12, SubstepsGainTheirSquareAndSweepsEndAtTheStepsOwnError) { expect_law(12); }
TEST(Law13, AHingeIsOffByTheArcsDistanceFromItsTangentAndAnExplicitTopWobblesMore) { expect_law(13); }
TEST(Law14, AStaleJacobianSlowsWhatTurnsAndAFreshOneDoesNot) { expect_law(14); }
TEST(Law15, RowByRowAPinOnALongArmRingsBeyondOneMinusQOverQ) { expect_law(15); }
TEST(Law16, WhatGoesFurtherInAStepThanItIsSeenPassesAWall) { expect_law(16); }
TEST(Law17, AColumnOnSoftContactsBucklesAsGreenhillsDoes) { expect_law(17); }
TEST(Law18, AColumnLeansWhereGravityIsFasterThanTheSweeps) { expect_law(18); }
TEST(Law19, ContactsHopBeforeRodsRingForAnOpenOneClosesInAStep) { expect_law(19); }
TEST(Law20, SolvedExactlyOnlyARegularisationMakesAColumnLean) { expect_law(20); }

TEST(Law21, AStepAndItsHalvesDifferHoweverShortTheyAre) { expect_law(21); }

TEST(Laws, AllAreThereInOrder) {
  const std::vector<Law> laws = all();
  ASSERT_EQ(laws.size(), 21U);
  for (int i = 0; i < 21; ++i) EXPECT_EQ(laws[i].number, i + 1);
}

TEST(Law2, TheAtlasCriticalOverlaps) {
  EXPECT_NEAR(popping_overlap(0.2, 1.0 / 60), 0.1226, 1e-4);
  EXPECT_NEAR(popping_overlap(0.1, 1.0 / 60), 0.518, 1e-3);
}

TEST(Bisection, FindsWhereAPropertyChanges) {
  for (const double at : {1e-3, 0.7, 42.0}) {
    EXPECT_NEAR(bisect([=](double x) { return x < at; }, 0.1 * at, 3 * at, 1e-6) / at, 1, 1e-6);
    EXPECT_NEAR(bisect([=](double x) { return x > at; }, 0.1 * at, 3 * at, 1e-6) / at, 1, 1e-6);
  }
  EXPECT_THROW(bisect([](double) { return true; }, 1, 2, 1e-3), std::invalid_argument);
  EXPECT_TRUE(std::isnan(bisected({"", "", "", 1, 0.1, {}, [](double) { return true; }}).measured()));
}

TEST(Record, TellsFourOutcomesApart) {
  const auto outcome = [](auto x) {
    Record record(1, 1e6);
    for (int i = 0; i < 3000 && record.note(x(i)); ++i) {
    }
    return record.outcome();
  };
  const auto sign = [](int i) { return i % 2 == 0 ? 1.0 : -1.0; };
  EXPECT_EQ(outcome([](int i) { return std::pow(0.999, i); }), Outcome::settles);
  EXPECT_EQ(outcome([&](int i) { return sign(i) * std::pow(0.9999, i); }), Outcome::settles);
  EXPECT_EQ(outcome([](int i) { return i < 10 ? 1.0 : 0.0; }), Outcome::settles);
  EXPECT_EQ(outcome([](int) { return 1.0; }), Outcome::drifts);
  EXPECT_EQ(outcome([](int i) { return 1 + 1e-3 * i; }), Outcome::drifts);
  EXPECT_EQ(outcome([&](int i) { return sign(i); }), Outcome::rings);
  EXPECT_EQ(outcome([&](int i) { return sign(i) * (i < 2500 ? 1e5 : 1e3); }), Outcome::rings) << "it has grown";
  EXPECT_EQ(outcome([&](int i) { return sign(i) * std::pow(1.01, i); }), Outcome::explodes);
  EXPECT_EQ(outcome([](int i) { return i < 100 ? 0.1 : std::nan(""); }), Outcome::explodes);
}

TEST(Law6, AColdStartIsStableToTwo) {
  for (const auto& [links, sweeps] : {std::pair{3, 1}, {10, 1}, {10, 10}})
    for (const double beta : {0.03, 0.2, 1.0, 1.8, 2.1})
      EXPECT_EQ(
          run(WarmChain{.links = links, .sweeps = sweeps, .beta = beta, .warm_start = false}) == Outcome::settles,
          beta < 2)
          << links << " links, " << sweeps << " sweeps, beta " << beta;
}

TEST(Law6, TheLimitHoldsForEveryOrderOfSolving) {
  const double limit = largest_beta(left_by_sweeps(8, 3));
  for (const auto order : {SweepOrder::natural, SweepOrder::reverse, SweepOrder::coloured}) {
    WarmChain chain{.links = 8, .sweeps = 3, .beta = 0.97 * limit, .order = order};
    EXPECT_EQ(run(chain), Outcome::settles);
    chain.beta = 1.03 * limit;
    EXPECT_NE(run(chain), Outcome::settles);
  }
}

TEST(Law6, TheAtlasLimitsOfTenLinks) {
  const auto limit = [](int sweeps) { return largest_beta(left_by_sweeps(10, sweeps)); };
  EXPECT_NEAR(limit(1), 0.0251, 5e-5);
  EXPECT_NEAR(limit(10), 0.281, 5e-4);
  EXPECT_NEAR(limit(30), 1.103, 5e-3);
}

TEST(Law7, HalvingTheStepAllowsFourTimesTheMass) {
  // The tension also holds the links' own weight, which does not grow.
  const TautChain coarse, fine{.step = coarse.step / 2};
  EXPECT_NEAR((heaviest_end(fine) + fine.links) / (heaviest_end(coarse) + coarse.links), 4, 0.1);
}

TEST(Law7, MoreSweepsCannotHelpButSmallerStepsCan) {
  TautChain chain;
  chain.end_mass = 1.2 * heaviest_end(chain);
  for (const int sweeps : {0, 100, 3000}) {
    chain.sweeps = sweeps;
    EXPECT_NE(run(chain), Outcome::settles) << sweeps;
  }
  chain.sweeps = 0;
  chain.substeps = 2;
  EXPECT_EQ(run(chain), Outcome::settles);
}

TEST(Law7, TheTensionAtTheLimitIsAboutTheLinksMassTimesLengthOverTheStepSquared) {
  for (const double step : {1.0 / 30, 1.0 / 60, 1.0 / 240})
    EXPECT_NEAR(heaviest_end({.step = step}) * 9.81 * step * step, 1, 0.1);
}

/// How far a hanging chain of pinned rods swings to the side in a thousand steps, over how far it was off at
/// first, where T h²/(ml) at its end is `number`.
double swung(double number) {
  using M = byhand::PlaneBody;
  const int links = 30;
  const double h = 1.0 / 60, off = 1e-8;
  byhand::Scene<M> scene = byhand::pinned_chain<M>({.links = links, .end_mass = number / (9.81 * h * h)});
  for (int i = 1; i <= links; ++i) scene.set_position(i, {off * uneven(i), scene.bodies().pose[i].position.y()});
  byhand::Simulation<M> simulation{std::move(scene), {byhand::Direct{}, byhand::Baumgarte{}}};
  double farthest = 0;
  for (int i = 0; i < 1000; ++i) {
    simulation.step(h);
    for (const auto& pose : simulation.scene.bodies().pose)
      farthest = std::max(farthest, std::abs(pose.position.x()));
  }
  return farthest / off;
}

// The end carries nearly all of the tension. The links' own weight adds 30 g to it at the top.
TEST(Law7, OfPinnedRodsTheLimitIsAThird) {
  const double weight = 30 * 9.81 / 3600;
  EXPECT_LE(swung(0.95 * limit_of_rods - weight), 1000);
  EXPECT_GE(swung(1.15 * limit_of_rods), 1e6);
}

TEST(Law17, ItIsGreenhillsColumn) {
  for (const double base : {1.0, 2.0}) EXPECT_NEAR(buckling_load(1000, base) * 1e9, 7.837, 0.03);
  EXPECT_NEAR(buckling_load(1, 1), 2, 1e-9);  // one box on one joint: κ = ½ mg
}

TEST(Law17, NeitherSweepsNorSubstepsHelp) {
  for (const auto& [sweeps, substeps] : {std::pair{0, 1}, {0, 4}, {100, 1}, {20, 4}}) {
    const Column column{.boxes = 10,
                        .sweeps = sweeps,
                        .substeps = substeps,
                        .frequency = 0.8 * softest_contacts(10),
                        .steps = 1000};
    EXPECT_NE(buckle(column), Outcome::settles) << sweeps << " sweeps, " << substeps << " substeps";
  }
}

TEST(Law18, TheRateTendsToTheCantilevers) {
  EXPECT_NEAR((1 - bending_left_by_a_sweep(10)) * 1e4, 2.06, 1e-3);
  EXPECT_NEAR(gravity_that_sweeps_hold(10, 2, 1.0 / 60), 9.45, 0.01);
}

TEST(Law19, TheFactorOfTheAtlasIsWhatTheKinkMakesOfLaw6) {
  for (const double q : {0.88, 0.92, 0.95, 0.98}) {
    const double factor = largest_beta_of_contacts(q) * q / (1 - q);
    EXPECT_GT(factor, 0.34) << q;
    EXPECT_LT(factor, 0.42) << q;
  }
}

TEST(Law13, ImplicitlyAWobbleStays) {
  for (const int axis : {0, 2}) EXPECT_NEAR(wobble_growth(axis, 30, 1.0 / 60, 10, true), 1, 1e-3) << axis;
}

}  // namespace laws_test
