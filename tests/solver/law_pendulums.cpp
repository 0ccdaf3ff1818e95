#include <gtest/gtest.h>

#include <numbers>

#include "lessons/exact/compound_pendulum.hpp"
#include "lessons/exact/double_pendulum.hpp"
#include "lessons/exact/simple_pendulum.hpp"
#include "lessons/scenes/chain.hpp"
#include "lessons/scenes/conical_pendulum.hpp"
#include "tests/solver/swing.hpp"

namespace law_pendulums_test {

using namespace byhand;
constexpr double pi = std::numbers::pi, g = 9.81;

VelocityStepping with(const DriftCure& cure) { return {Direct{}, cure}; }

TEST(LawA1, WithoutACureThePendulumErrsAsTheAtlasSays) {
  expect_row(swing<NormalisedDistance>(with(NoDriftCure{}), 1.0 / 60), {1.1e-2, 0.14, 0.47, -0.86});
}
TEST(LawA1, WithAFifthOfTheErrorPerStepItErrsAsTheAtlasSays) {
  expect_row(swing<NormalisedDistance>(with(Baumgarte{0.2}), 1.0 / 60), {3.0e-3, 6.4e-3, 1.3e-2, -0.10});
}
TEST(LawA1, WithTheWholeErrorPerStepItErrsAsTheAtlasSays) {
  expect_row(swing<NormalisedDistance>(with(Baumgarte{1}), 1.0 / 60), {1.1e-3, -1.2e-2, 2.7e-3, -0.016});
}
TEST(LawA1, OffTheRodsLengthTheSquaredFormDiffers) {
  const double squared = swing<Distance>(with(Baumgarte{0.2}), 1.0 / 60).angle_error;
  expect_two_digits(squared, 6.6e-3, "angle after 1 s");
  EXPECT_GT(squared - swing<NormalisedDistance>(with(Baumgarte{0.2}), 1.0 / 60).angle_error, 1e-4);
}

TEST(LawA1, TheAngleAtAFixedTimeConvergesWithOrderOne) {
  for (const DriftCure& cure : {DriftCure{NoDriftCure{}}, DriftCure{Baumgarte{0.2}}, DriftCure{Baumgarte{1}}}) {
    const double coarse = swing<NormalisedDistance>(with(cure), 1.0 / 1920).angle_error;
    const double fine = swing<NormalisedDistance>(with(cure), 1.0 / 3840).angle_error;
    EXPECT_NEAR(order(coarse, fine), 1, 0.05);
  }
}

// From one passage of the bottom to another the half step by which v runs ahead of x drops out.
TEST(LawA1, ThePeriodConvergesWithOrderTwo) {
  for (const DriftCure& cure : {DriftCure{NoDriftCure{}}, DriftCure{Baumgarte{0.2}}, DriftCure{Baumgarte{1}}}) {
    const double coarse = swing<NormalisedDistance>(with(cure), 1.0 / 1920).period_error;
    const double fine = swing<NormalisedDistance>(with(cure), 1.0 / 3840).period_error;
    EXPECT_NEAR(order(coarse, fine), 2, 0.05);
  }
}

TEST(LawA1, ErrorsScaleAsDimensionsSay) {
  const SwingErrors small = swing<NormalisedDistance>(with(Baumgarte{0.2}), 1.0 / 60);
  const Simulation<PlaneParticle> start{pendulum<PlaneParticle, NormalisedDistance>(pi / 2, 4, 3),
                                        {Direct{}, Baumgarte{0.2}}};
  auto tall = start;
  double stretch = 0;
  run(tall, 20, 1.0 / 30, [&] { stretch = std::max(stretch, position_error(tall).max); });
  EXPECT_NEAR(stretch, 4 * small.stretch, 1e-12);
  EXPECT_NEAR((energy(tall.scene) - energy(start.scene)) / (3 * g * 4), small.energy_gain, 1e-12);
}

// In small swings, where the drift of the rod is of second order, symplectic Euler only lets the energy of the
// sideways oscillation ripple by ωh, where explicit Euler would multiply it by 1 + (ωh)² a step.
TEST(LawA1, SymplecticEulerOnlyLetsTheEnergyRipple) {
  const double length = 2, omega = std::sqrt(g / length), h = 1.0 / 60;
  Simulation<PlaneParticle> simulation{pendulum<PlaneParticle, NormalisedDistance>(1e-5, length, 3),
                                       {Direct{}, NoDriftCure{}}};
  const Bodies<PlaneParticle>& bodies = simulation.scene.bodies();
  const auto sideways = [&] {
    return std::pow(bodies.velocity[1].x(), 2) + std::pow(omega * bodies.pose[1].position.x(), 2);
  };
  const double start = sideways();
  for (int i = 0; i < 300; ++i) simulation.step(h);
  EXPECT_NEAR(sideways() / start, 1, omega * h);
}

template <class M>
class LawA2 : public testing::Test {};
using BodyModels = testing::Types<PlaneBody, SpaceBody>;
TYPED_TEST_SUITE(LawA2, BodyModels);

TYPED_TEST(LawA2, ReleasedLevelTheHingeCarriesAQuarterOfTheWeightAtOnce) {
  for (const double h : {1.0 / 30, 1.0 / 60, 1e-4}) {
    Simulation<TypeParam> simulation{hinged_rod<TypeParam>(pi / 2, 2, 3), {Direct{}, NoDriftCure{}}};
    simulation.step(h);
    EXPECT_NEAR(force(simulation.work, 0, 1) / (3 * g), 0.25, 1e-13);
    EXPECT_NEAR(force(simulation.work, 0, 0) / (3 * g), 0, 1e-13);
  }
}

TYPED_TEST(LawA2, AHingedRodSwingsAsAPointAtTwoThirdsOfIt) {
  const CompoundPendulum exact(pi / 2, 2, 3, g);
  EXPECT_EQ(exact.period(), SimplePendulum(pi / 2, 4.0 / 3, g).period());
  const auto errors = [&](double h) {
    Simulation<TypeParam> simulation{hinged_rod<TypeParam>(pi / 2, 2, 3), {Direct{}, Baumgarte{1}}};
    ZeroCrossings bottom(pi / 2);
    double angle = 0, pull = 0;
    run(simulation, 4, h, [&] {
      bottom.add(angle_from_down(simulation.scene.bodies().pose[1].position), simulation.time, h);
      if (std::abs(simulation.time - 1) < h / 2) {
        angle = angle_from_down(simulation.scene.bodies().pose[1].position);
        pull = force(simulation.work, 0, 1);
      }
    });
    return std::array{(bottom.times.at(2) - bottom.times.at(0)) / exact.period() - 1, angle - exact.angle(1),
                      (pull - exact.pivot_force(1).y()) / (3 * g)};
  };
  const auto coarse = errors(1.0 / 1000), fine = errors(1.0 / 2000);
  EXPECT_LT(std::abs(fine[0]), 1e-5);
  for (const int i : {1, 2}) {
    EXPECT_LT(std::abs(fine[i]), 3e-3);
    EXPECT_NEAR(order(coarse[i], fine[i]), 1, 0.1);
  }
}

TEST(LawA3, AConicalPendulumCirclesAtItsRateAndPullsItsTension) {
  for (const double angle : {0.2, 0.8, pi / 3, 1.3}) {
    const double length = 2, mass = 3;
    const ConicalPendulum exact(angle, length, g);
    const auto errors = [&](double h) {
      Simulation<SpaceParticle> simulation{conical_pendulum(angle, length, mass), {Direct{}, Baumgarte{0.2}}};
      ZeroCrossings front(1e-300);
      double pull = 0;
      int samples = 0;
      run(simulation, 6 * exact.period(), h, [&] {
        front.add(simulation.scene.bodies().pose[1].position.z(), simulation.time, h);
        pull -= force(simulation.work, 0);
        ++samples;
      });
      const double turn = (front.times.back() - front.times.front()) * 2 / (front.times.size() - 1);
      return std::array{turn / exact.period() - 1, pull / samples / exact.tension(mass) - 1};
    };
    const auto coarse = errors(exact.period() / 500), fine = errors(exact.period() / 1000);
    for (const int i : {0, 1}) {
      EXPECT_LT(std::abs(fine[i]), 3e-3) << angle << (i == 0 ? " period" : " tension");
      EXPECT_GT(order(coarse[i], fine[i]), 0.9) << angle << (i == 0 ? " period" : " tension");
    }
  }
}

TEST(LawA4, ADoublePendulumConvergesWithOrderOneToTheCertifiedAnswer) {
  const DoublePendulum exact({{pi / 2, pi / 2}, {0, 0}}, {1, 1}, {1, 1}, g);
  for (const double time : {1.0, 2.0}) {
    const auto error = [&](double h) -> Eigen::Vector2d {
      Simulation<PlaneParticle> simulation{
          rod_chain<PlaneParticle, NormalisedDistance>({.links = 2, .angle = pi / 2}), {Direct{}, Baumgarte{1}}};
      run(simulation, time, h);
      const Eigen::Vector2d angles(rod_angle(simulation.scene, 0, 1), rod_angle(simulation.scene, 1, 2));
      return angles - exact.at(time).angles;
    };
    const Eigen::Vector2d coarse = error(1.0 / 8000), fine = error(1.0 / 16000);
    for (const int i : {0, 1}) {
      EXPECT_LT(std::abs(fine[i]), 2e-3) << "angle " << i << " at " << time;
      EXPECT_NEAR(order(coarse[i], fine[i]), 1, 0.05) << "angle " << i << " at " << time;
      EXPECT_LT(std::abs(2 * fine[i] - coarse[i]), 1e-5) << "extrapolated, angle " << i << " at " << time;
    }
  }
}

}  // namespace law_pendulums_test
