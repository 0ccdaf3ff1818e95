#include <gtest/gtest.h>

#include <numbers>

#include "lessons/exact/simple_pendulum.hpp"
#include "lessons/scenes/circle.hpp"
#include "lessons/scenes/pendulum.hpp"
#include "tests/solver/law_motion.hpp"

namespace {

using namespace byhand;
constexpr double g = 9.81, h = 1.0 / 60, length = 2, mass = 3;

/// A bob at rest in weightlessness, `error` [m] too far from its anchor.
template <class M, template <class> class Rod>
Simulation<M> stretched(double error, const Baumgarte& cure) {
  Simulation<M> simulation{pendulum<M, Rod>(0.4, length, mass), {GaussSeidel{}, cure}};
  simulation.scene.gravity.setZero();
  simulation.scene.state().pose[1].position *= 1 + error / length;
  return simulation;
}
template <class M>
double stretch(const Simulation<M>& simulation) {
  return simulation.scene.bodies().pose[1].position.norm() - length;
}

/// What share of the error is left after some steps.
double left_after(int steps, const Baumgarte& cure, double step = h) {
  auto simulation = stretched<PlaneParticle, NormalisedDistance>(0.1, cure);
  for (int i = 0; i < steps; ++i) simulation.step(step);
  return stretch(simulation) / 0.1;
}

template <class M>
class LawB1InEveryModel : public testing::Test {};
using Models = testing::Types<PlaneParticle, PlaneBody, SpaceParticle, SpaceBody>;
TYPED_TEST_SUITE(LawB1InEveryModel, Models);

TYPED_TEST(LawB1InEveryModel, AStepLeavesOneMinusBetaOfTheError) {
  for (int tenth = 0; tenth <= 30; ++tenth)
    for (const double error : {0.1, -0.1}) {
      const double beta = tenth / 10.0;
      auto simulation = stretched<TypeParam, NormalisedDistance>(error, {beta});
      for (int i = 1; i <= 4; ++i) {
        simulation.step(h);
        EXPECT_NEAR(stretch(simulation), std::pow(1 - beta, i) * error, 1e-13) << "beta " << beta;
      }
    }
}

// ½(d² − L²) is L e to first order, and so is its J: the same β, up to terms in e/L.
TYPED_TEST(LawB1InEveryModel, TheSquaredFormCorrectsAtNearlyTheSameRate) {
  for (int tenth = 1; tenth <= 20; ++tenth)
    for (const double error : {1e-2, -1e-4}) {
      const double beta = tenth / 10.0;
      auto simulation = stretched<TypeParam, Distance>(error, {beta});
      simulation.step(h);
      EXPECT_NEAR(stretch(simulation) / error, 1 - beta, beta * std::abs(error) / length) << "beta " << beta;
    }
}

template <class M>
class LawB1OfPins : public testing::Test {};
using BodyModels = testing::Types<PlaneBody, SpaceBody>;
TYPED_TEST_SUITE(LawB1OfPins, BodyModels);

TYPED_TEST(LawB1OfPins, ABlockOfRowsLeavesOneMinusBetaOfEach) {
  for (int tenth = 0; tenth <= 25; ++tenth) {
    const double beta = tenth / 10.0;
    Simulation<TypeParam> simulation{hinged_rod<TypeParam>(0.7, length, mass), {GaussSeidel{}, Baumgarte{beta}}};
    simulation.scene.gravity.setZero();
    const Linear<TypeParam> error = 1e-6 * (Linear<TypeParam>::Unit(0) - 2 * Linear<TypeParam>::Unit(1));
    simulation.scene.state().pose[1].position += error;
    simulation.step(h);
    const auto left = simulation.scene.template all<Pin>()[0].template value<double>(
        simulation.scene.bodies().pose[0], simulation.scene.bodies().pose[1]);
    // The rod also turns by about e/l, whose square is what (21) does not see.
    EXPECT_LT((left - (1 - beta) * error).norm(), 1e-11) << "beta " << beta;
  }
}

TEST(LawB1, TheErrorFallsMonotonouslyToBetaOneAndChangesSidesBeyond) {
  for (int hundredth = 1; hundredth < 300; ++hundredth) {
    if (hundredth == 100) continue;
    const double beta = hundredth / 100.0, first = left_after(1, {beta}), second = left_after(2, {beta});
    EXPECT_EQ(first > 0, beta < 1) << beta;
    EXPECT_GT(second, 0) << beta;
    if (hundredth == 200) continue;
    EXPECT_EQ(std::abs(second) < std::abs(first), beta < 2) << beta;
  }
  EXPECT_NEAR(left_after(1, {1}), 0, 1e-14);
}

TEST(LawB1, OvershootDivergesBeyondTwo) {
  EXPECT_NEAR(left_after(50, {1.99}), 0.605, 5e-4);
  EXPECT_NEAR(left_after(50, {2.00}), 1.000, 1e-9);
  EXPECT_NEAR(left_after(50, {2.01}), 1.645, 5e-4);
}

TEST(LawB1, ReadLiterallyBetaIsARateWithItsLimitAtTwoOverTheStep) {
  for (const double step : {1.0 / 60, 1.0 / 240, 0.1}) {
    const auto left = [&](double beta_h) { return left_after(50, {beta_h / step, BetaReading::literal}, step); };
    EXPECT_NEAR(left(1.99), 0.605, 5e-4);
    EXPECT_NEAR(left(2.00), 1.000, 1e-9);
    EXPECT_NEAR(left(2.01), 1.645, 5e-4);
    EXPECT_NEAR(left_after(static_cast<int>(std::lround(10 / step)), {0.2, BetaReading::literal}, step),
                std::exp(-2), 0.2 * 0.2 * step * 10 * std::exp(-2));
  }
  EXPECT_NEAR(left_after(600, {0.2, BetaReading::literal}), 0.135, 5e-4);
}

TEST(LawB1, PerStepTheHalfTimeFollowsTheStep) {
  for (const double step : {1.0 / 60, 1.0 / 120}) {
    const int steps = 30;
    const double half_time = steps * step * std::log(0.5) / std::log(left_after(steps, {0.2}, step));
    EXPECT_NEAR(half_time, 3.106 * step, 1e-3 * step);
  }
}

// In the steady state a step's tangent leaves the circle by as much as β takes back.
TEST(LawB1, ASpinningRodStaysTooLongByItsTurnSquaredOverTwoBeta) {
  for (const double beta : {0.1, 0.2, 0.3, 0.5, 1.0, 1.5})
    for (const double turn : {0.01, 0.03, 0.1}) {
      const double speed = turn / h * length;
      Simulation<PlaneParticle> simulation{particle_on_a_circle<PlaneParticle>(length, speed, mass),
                                           {GaussSeidel{}, Baumgarte{beta}}};
      run(simulation, 300 * h, h);
      const Eigen::Vector2d before = simulation.scene.bodies().pose[1].position;
      simulation.step(h);
      const Eigen::Vector2d after = simulation.scene.bodies().pose[1].position;
      const double settled = std::asin(cross(before, after)[0] / (before.norm() * after.norm()));
      const double law = settled * settled / (2 * beta);
      // Next in the expansion are ½β(C/L)² and ⅓(ωh)⁴ beside (ωh)².
      EXPECT_NEAR((after.norm() / length - 1) / law, 1, settled * settled * (0.5 + 1 / beta))
          << beta << ' ' << turn;
    }
}

TEST(LawB3, WithoutACureTheErrorGrowsByHalfTheStepTimesTheCentripetalAcceleration) {
  for (const double radius : {0.5, 1.0, 2.0})
    for (const double speed : {1.0, 3.0, 10.0})
      for (const double step : {1.0 / 60, 1.0 / 480}) {
        Simulation<PlaneParticle> simulation{particle_on_a_circle<PlaneParticle>(radius, speed, mass),
                                             {GaussSeidel{}, NoDriftCure{}}};
        const double growth = 2 * speed * speed * step / (radius * radius);  // of (R/R0)⁴ per second
        for (const int steps : {1, 2, 10}) {
          while (simulation.time < (steps - 0.5) * step) simulation.step(step);
          const double C = simulation.scene.bodies().pose[1].position.norm() - radius;
          EXPECT_NEAR(C / simulation.time / (step * speed * speed / (2 * radius)), 1, growth * simulation.time)
              << "R " << radius << ", v " << speed << ", h " << step << ", steps " << steps;
        }
      }
}

TEST(LawB3, TheErrorGrowsLinearlyAtFirstAndWithTheFourthRootLater) {
  Simulation<PlaneParticle> simulation{particle_on_a_circle<PlaneParticle>(1, 3, mass),
                                       {GaussSeidel{}, NoDriftCure{}}};
  const auto radius_at = [&](double time) {
    while (simulation.time < time - h / 2) simulation.step(h);
    return simulation.scene.bodies().pose[1].position.norm();
  };
  const double first = radius_at(0.1), second = radius_at(0.2);
  EXPECT_NEAR(order(second - 1, first - 1), 1, 0.05);
  const double late = radius_at(1500), later = radius_at(3000);
  EXPECT_NEAR(order(later, late), 0.25, 1e-3);
}

TEST(LawB3, ProjectionTakesEnergyAwayInEveryStep) {
  Simulation<PlaneParticle> circling{particle_on_a_circle<PlaneParticle>(1, 10, mass),
                                     {GaussSeidel{}, NoDriftCure{}}};
  circling.step(h);
  for (int i = 0; i < 600; ++i) {
    const double before = energy(circling.scene);
    circling.step(h);
    ASSERT_LT(energy(circling.scene), before);
  }
}

/// Mean energy of a pendulum of 90° in each of `periods` swings [J]; heights are taken half way through a step,
/// where the velocities of symplectic Euler belong, or their phase would look like energy.
std::vector<double> mean_energies(const DriftCure& cure, int steps_a_period, int periods) {
  const SimplePendulum exact(std::numbers::pi / 2, length, g);
  Simulation<PlaneParticle> simulation{
      pendulum<PlaneParticle, NormalisedDistance>(std::numbers::pi / 2, length, mass), {GaussSeidel{}, cure}};
  std::vector<double> means(periods, 0.0);
  for (double& mean : means)
    for (int i = 0; i < steps_a_period; ++i) {
      const double before = potential_energy(simulation.scene);
      simulation.step(exact.period() / steps_a_period);
      mean += (kinetic_energy(simulation.scene.bodies()) + (before + potential_energy(simulation.scene)) / 2) /
              steps_a_period;
    }
  return means;
}

TEST(LawB3, APendulumLosesEnergyWhateverItsBeta) {
  for (const int steps : {100, 200, 800}) {
    std::vector<DriftCure> cures{NoDriftCure{}};
    for (const double beta : {0.05, 0.1, 0.2, 0.3, 0.5, 1.0, 1.5, 1.9}) cures.emplace_back(Baumgarte{beta});
    for (const DriftCure& cure : cures) {
      const std::vector<double> means = mean_energies(cure, steps, 4);
      for (int i = 1; i < 4; ++i) EXPECT_LT(means[i], means[i - 1]) << steps << " steps, cure " << cure.index();
    }
  }
}

// The settled stretch h²u/(2β), u = v²/L, lags behind u by h(2 - β)/(2β), so that over a period the tension T does
// work on it: h³(2 - β)/(4β²) ∮ Ṫ u̇ dt. On the pendulum Ṫ u̇ = 6 m g² sin²θ θ̇².
TEST(LawB3, BaumgarteTakesEnergyAsTheCubeOfTheStep) {
  const SimplePendulum exact(std::numbers::pi / 2, length, g);
  double integral = 0;
  const int samples = 1000;
  for (int i = 0; i < samples; ++i) {
    const double time = exact.period() * i / samples;
    integral += 6 * mass * std::pow(g * std::sin(exact.angle(time)) * exact.angular_velocity(time), 2);
  }
  integral *= exact.period() / samples;
  for (const int steps : {1500, 3000})
    for (const double beta : {0.2, 0.3, 0.5, 1.0, 1.5, 1.9}) {
      const std::vector<double> means = mean_energies(Baumgarte{beta}, steps, 2);
      const double law = std::pow(exact.period() / steps, 3) * (2 - beta) / (4 * beta * beta) * integral;
      EXPECT_NEAR((means[0] - means[1]) / law, 1, 0.005) << "beta " << beta << ", " << steps << " steps";
    }
}

}  // namespace
