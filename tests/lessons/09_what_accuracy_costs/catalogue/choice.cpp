#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lessons/09_what_accuracy_costs/catalogue/chooser.hpp"

// Work against precision, and the choice that follows from it.
namespace {

using namespace byhand;
using testing::HasSubstr;
using testing::ThrowsMessage;

Configuration only(const std::string& name, int values) {
  Configuration configuration = configuration_named(name);
  configuration.values.resize(values);
  configuration.tunings = {0, 0.2};
  return configuration;
}

/// Ways that are quick to compare.
std::vector<Configuration> a_few() {
  return {only("Gauss–Seidel, sweeps", 6), only("Gauss–Seidel, substeps", 6), only("direct, substeps", 5)};
}

Problem short_chain() { return Problem("chain", {{"links", 4}, {"end_mass", 20}}); }

std::vector<Point> swept(const Problem& problem, const Configuration& configuration, double tuning) {
  std::vector<Point> points;
  for (const int knob : configuration.values) points.push_back(measure(problem, configuration, knob, tuning));
  return points;
}

Point point(const Configuration& configuration, double drift, double row_solves) {
  Point result;
  result.configuration = &configuration;
  result.error[static_cast<int>(Error::drift)] = drift;
  result.row_solves = row_solves;
  return result;
}

TEST(ParetoFront, HoldsWhatNothingBeatsInBoth) {
  const Configuration& any = configurations().front();
  Point failed = point(any, 1e-9, 1);
  failed.outcome = Outcome::failed;
  const std::vector<Point> points{point(any, 1, 10),    point(any, 0.1, 100), point(any, 0.5, 200), failed,
                                  point(any, 0.01, 50), point(any, NAN, 1),   point(any, 1, 10)};
  const auto front = pareto_front(points, Error::drift, Cost::row_solves);
  ASSERT_EQ(front.size(), 2u);
  EXPECT_EQ(front[0][Error::drift], 0.01);
  EXPECT_EQ(front[1][Error::drift], 1);
}

TEST(ParetoFront, OfARunIsBeatenByNoneOfItsPoints) {
  std::vector<Point> points;
  for (const Configuration& configuration : a_few())
    for (const Point& one : swept(short_chain(), configuration, 0.2)) points.push_back(one);
  for (const Error error : {Error::drift, Error::trajectory, Error::energy}) {
    const auto front = pareto_front(points, error, Cost::row_solves);
    ASSERT_FALSE(front.empty());
    for (std::size_t i = 1; i < front.size(); ++i) {
      EXPECT_LT(front[i - 1][error], front[i][error]);
      EXPECT_GT(front[i - 1].row_solves, front[i].row_solves);
    }
    for (const Point& one : points) {
      const bool on_it = std::any_of(front.begin(), front.end(), [&](const Point& best) {
        return best[error] <= one[error] && best.row_solves <= one.row_solves;
      });
      EXPECT_TRUE(on_it || !one.has(error)) << one.described();
    }
  }
}

TEST(FittedOrder, IsOneForTheTrajectoryOfSymplecticEuler) {
  const Configuration direct = only("direct, substeps", 7);
  EXPECT_NEAR(fitted_order(swept(Problem("compound_pendulum"), direct, 1), Error::trajectory), 1, 0.05);
  EXPECT_NEAR(fitted_order(swept(Problem("spherical_pendulum"), direct, 1), Error::trajectory), 1, 0.05);
}

TEST(FittedOrder, IsTwoForTheDriftThatBaumgarteLeaves) {
  // (ωh)²/2β, atlas B1
  EXPECT_NEAR(fitted_order(swept(Problem("pendulum"), only("direct, substeps", 6), 1), Error::drift), 2, 0.05);
}

TEST(FittedOrder, IsNoneWhereTheStepIsNotShortened) {
  EXPECT_TRUE(
      std::isnan(fitted_order(swept(short_chain(), only("Gauss–Seidel, sweeps", 4), 0.2), Error::trajectory)));
}

TEST(Measure, TellsStableFromAccurate) {
  // Atlas A1: XPBD keeps the rod's length to rounding, and loses nine tenths of the energy.
  const Point xpbd = measure(Problem("pendulum"), configuration_named("XPBD, substeps"), 1, 0);
  EXPECT_EQ(xpbd.outcome, Outcome::finished);
  EXPECT_LT(xpbd[Error::drift], 1e-9);
  EXPECT_NEAR(xpbd[Error::energy], 0.9, 0.05);
  EXPECT_NEAR(xpbd[Error::trajectory], 2 * std::sin(0.23 / 2), 0.02);
}

TEST(Measure, TellsTheSolversErrorFromTheSteps) {
  // More sweeps bring a chain to the direct solve of the same step, and no further: the rest is the step's.
  const Problem problem("chain", {{"links", 4}});
  const Configuration& sweeps = configuration_named("Gauss–Seidel, sweeps");
  const Point few = measure(problem, sweeps, 4, 0.2, {.algebraic = true}),
              many = measure(problem, sweeps, 256, 0.2, {.algebraic = true}),
              direct = measure(problem, configuration_named("direct, substeps"), 1, 0.2, {.algebraic = true});
  EXPECT_GT(few[Error::algebraic], 1e-3);
  EXPECT_LT(many[Error::algebraic], 1e-6);
  EXPECT_LT(direct[Error::algebraic], 1e-10);
  EXPECT_NEAR(many[Error::trajectory], direct[Error::trajectory], 1e-3 * direct[Error::trajectory]);
  EXPECT_GT(direct[Error::trajectory], 0.01);
}

TEST(Measure, KeepsAFailureAsAPointWithItsReason) {
  const Point blown = measure(short_chain(), configuration_named("Gauss–Seidel, substeps"), 32, 1);
  EXPECT_EQ(blown.outcome, Outcome::failed);
  EXPECT_THAT(blown.reason, HasSubstr("blew up after"));
  EXPECT_FALSE(blown.has(Error::drift));
}

TEST(Measure, GivesTheSameNumbersTwice) {
  const auto run = [] { return measure(short_chain(), configuration_named("Gauss–Seidel, substeps"), 8, 0.2); };
  const Point a = run(), b = run();
  for (const Error error : {Error::drift, Error::trajectory, Error::energy, Error::reaction})
    EXPECT_EQ(a[error], b[error]);
  EXPECT_EQ(a.row_solves, b.row_solves);
}

TEST(Chooser, RecommendsTheCheapestThatReachesTheAccuracy) {
  const Problem problem = short_chain();
  const auto among = a_few();
  const Wish wish{.error = Error::drift, .accuracy = 1e-2};
  const Choice choice = choose(problem, wish, among);
  ASSERT_TRUE(choice.reached);
  // It does when it is run again; the next smaller knob does not, with any tuning.
  const Point& best = choice.best;
  EXPECT_LE(measure(problem, *best.configuration, best.knob, best.tuning)[wish.error], wish.accuracy);
  const int cheaper = best.knob - std::max(1, best.knob / 7);
  if (cheaper >= 1) {
    for (const double tuning : best.configuration->tunings)
      EXPECT_GT(measure(problem, *best.configuration, cheaper, tuning)[wish.error], wish.accuracy) << tuning;
  }
  // No run of any other that costs less reaches it.
  for (const Configuration& configuration : among)
    for (const double tuning : configuration.tunings)
      for (const Point& one : swept(problem, configuration, tuning))
        EXPECT_TRUE(one.row_solves >= best.row_solves || !one.has(wish.error) || one[wish.error] > wish.accuracy)
            << one.described();
  ASSERT_TRUE(choice.finer);
  EXPECT_LE((*choice.finer)[wish.error], wish.accuracy / 10);
  EXPECT_GT(choice.finer->row_solves, best.row_solves);
}

TEST(Chooser, FindsTheMarginByRunning) {
  const Problem problem = short_chain();
  const Wish wish{.error = Error::drift, .accuracy = 1e-2};
  const std::vector<Configuration> among{only("direct, substeps", 5)};
  const Choice choice = choose(problem, wish, among);
  ASSERT_TRUE(choice.reached);
  ASSERT_TRUE(std::isfinite(choice.margin));
  const auto drift = [&](double factor) {
    const Point& best = choice.best;
    return measure(problem.with("end_mass", factor * 20), *best.configuration, best.knob, best.tuning)[wish.error];
  };
  EXPECT_GT(drift(choice.margin), wish.accuracy);
  EXPECT_GT(choice.margin, 1);
  for (double factor = 1; factor < choice.margin / 1.05; factor *= std::sqrt(2.0))
    EXPECT_LE(drift(factor), wish.accuracy) << factor;
}

TEST(Chooser, LooksForTheMarginUpToTheEndOfTheRangeAndNotBeyond) {
  // 1e6/30 · 30 is above 1e6 by rounding.
  const Problem problem("chain", {{"links", 1}, {"end_mass", 30}});
  Point point;
  point.configuration = &configuration_named("direct, substeps");
  point.knob = 1;
  point.tuning = 0.2;
  EXPECT_EQ(margin(problem, point, Error::drift, 1e9), INFINITY);
}

TEST(Chooser, SpendsABudgetOnTheMostAccurate) {
  const Problem problem = short_chain();
  const Wish wish{.error = Error::trajectory, .budget = 400};
  const auto among = a_few();
  const Choice choice = choose(problem, wish, among);
  ASSERT_TRUE(choice.reached);
  EXPECT_LE(choice.best.row_solves, 400);
  for (const Configuration& configuration : among)
    for (const double tuning : configuration.tunings)
      for (const Point& one : swept(problem, configuration, tuning))
        EXPECT_TRUE(one.row_solves > 400 || !one.has(wish.error) || one[wish.error] >= choice.best[wish.error])
            << one.described();
}

TEST(Chooser, SaysThatAnErrorIsOutOfReachAndWhatCameNearest) {
  const Problem problem = short_chain();
  const std::vector<Configuration> among{only("Gauss–Seidel, sweeps", 5), only("direct, substeps", 3)};
  const Choice choice = choose(problem, {.error = Error::trajectory, .accuracy = 1e-9}, among);
  EXPECT_FALSE(choice.reached);
  EXPECT_GT(choice.best[Error::trajectory], 1e-9);
  for (const Configuration& configuration : among)
    for (const double tuning : configuration.tunings)
      for (const Point& one : swept(problem, configuration, tuning))
        EXPECT_TRUE(!one.has(Error::trajectory) || one[Error::trajectory] >= choice.best[Error::trajectory]);
}

TEST(Chooser, RefusesAWishThatIsNone) {
  const Problem problem = short_chain();
  EXPECT_THAT([&] { choose(problem, {}); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("either an accuracy or a budget")));
  EXPECT_THAT([&] { choose(problem, {.accuracy = 0}); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("accuracy is 0")));
  EXPECT_THAT([&] { choose(problem, {.error = Error::momentum, .accuracy = 1}); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("error is momentum")));
}

}  // namespace
