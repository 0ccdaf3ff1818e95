#include <gtest/gtest.h>

#include "lessons/exact/circle.hpp"
#include "lessons/exact/hanging_chain.hpp"
#include "lessons/scenes/chain.hpp"
#include "lessons/scenes/circle.hpp"
#include "lessons/scenes/slack_chain.hpp"
#include "tests/solver/law_motion.hpp"

namespace law_tensions_test {

using namespace byhand;
constexpr double g = 9.81;

template <class M>
using Circling = Simulation<M>;

/// What dR²/dt = h (v0 R0/R)² integrates to [m].
double grown_radius(double radius, double speed, double h, double time) {
  return radius * std::pow(1 + 2 * speed * speed * h * time / (radius * radius), 0.25);
}

template <class M>
class LawA5 : public testing::Test {};
using Particles = testing::Types<PlaneParticle, SpaceParticle>;
TYPED_TEST_SUITE(LawA5, Particles);

// The velocity is a tangent of the circle one step ago, so the pull that turns it is m v²/R with the new R,
// exactly.
TYPED_TEST(LawA5, LambdaOverTheStepIsTheCentripetalForce) {
  const double radius = 2, mass = 3;
  for (const double speed : {3.0, 10.0, 30.0})
    for (const double h : {1.0 / 60, 1.0 / 240, 1e-4}) {
      Circling<TypeParam> simulation{particle_on_a_circle<TypeParam>(radius, speed, mass),
                                     {Direct{}, NoDriftCure{}}};
      for (int i = 0; i < 100; ++i) {
        const double before = simulation.scene.bodies().velocity[1].norm();
        const double now = simulation.scene.bodies().pose[1].position.norm();
        simulation.step(h);
        const double expected = i == 0 ? 0 : circle_tension(mass, before, now);
        ASSERT_NEAR(-force(simulation.work, 0), expected, 1e-11 * circle_tension(mass, speed, radius)) << i;
      }
    }
}

TYPED_TEST(LawA5, WithoutACureSpeedTimesRadiusIsKeptAndTheRadiusGrowsWithTheFourthRoot) {
  for (const double radius : {1.0, 2.0})
    for (const double speed : {0.3, 3.0, 10.0, 30.0})
      for (const double h : {1.0 / 60, 1.0 / 240}) {
        Circling<TypeParam> simulation{particle_on_a_circle<TypeParam>(radius, speed, 3),
                                       {Direct{}, NoDriftCure{}}};
        const auto& bodies = simulation.scene.bodies();
        for (int i = 0; i < 240; ++i) {
          const double now = bodies.pose[1].position.norm();
          simulation.step(h);
          ASSERT_NEAR(bodies.velocity[1].norm() * now / (speed * radius), 1, 1e-13);
          const double grown = bodies.pose[1].position.norm();
          const double by = speed * radius / now * h;
          ASSERT_NEAR(grown * grown / (now * now + by * by), 1, 1e-14);
        }
        EXPECT_NEAR(bodies.pose[1].position.norm() / grown_radius(radius, speed, h, simulation.time), 1,
                    std::pow(speed * h / radius, 2));
      }
}

TYPED_TEST(LawA5, AfterASecondTheRadiusIsWhatTheAtlasSays) {
  const double speeds[] = {3, 10, 30}, atlas[] = {1.068, 1.443, 2.36}, h = 1.0 / 60;
  for (const int i : {0, 1, 2}) {
    EXPECT_NEAR(grown_radius(1, speeds[i], h, 1), atlas[i], i == 2 ? 5e-3 : 5e-4);
    Circling<TypeParam> simulation{particle_on_a_circle<TypeParam>(1, speeds[i], 1), {Direct{}, NoDriftCure{}}};
    run(simulation, 1, h);
    const double fourth = std::pow(simulation.scene.bodies().pose[1].position.norm(), 4);
    // Squaring R² + (hv)² leaves (hv)⁴ a step beside the law; summed up it is ½(h v0 R0)² ln(R/R0)⁴.
    const double beyond = std::pow(h * speeds[i], 2) / 2 * std::log(fourth);
    EXPECT_NEAR((fourth - beyond) / std::pow(grown_radius(1, speeds[i], h, 1), 4), 1, 2e-3) << speeds[i];
  }
}

constexpr double steps[] = {1.0 / 30, 1.0 / 60, 1.0 / 240, 1e-3};

TEST(LawA6, EveryRodOfAHangingChainCarriesTheWeightBelowIt) {
  const ChainOptions chain{.links = 12, .length = 0.5, .mass = 0.3, .end_mass = 7};
  std::vector<double> masses(chain.links, chain.mass);
  masses.back() = chain.end_mass;
  const std::vector<double> tensions = hanging_chain_tensions(masses, g);
  for (const double h : steps) {
    Simulation<PlaneParticle> squared{rod_chain<PlaneParticle>(chain), {Direct{}}};
    Simulation<SpaceParticle> in_space{rod_chain<SpaceParticle, NormalisedDistance>(chain),
                                       {GaussSeidel{.sweeps = 20'000}, NoDriftCure{}}};
    Simulation<PlaneBody> stiff{pinned_chain<PlaneBody>(chain), {Direct{}}};
    for (int step = 0; step < 3; ++step) {
      squared.step(h);
      stiff.step(h);
    }
    in_space.step(h);
    for (int i = 0; i < chain.links; ++i) {
      // (14) is not divided by |d|: its λ is the impulse over the rod's length.
      EXPECT_NEAR(-force(squared.work, i) * chain.length / tensions[i], 1, 1e-10) << "rod " << i << ", h " << h;
      EXPECT_NEAR(-force(in_space.work, i) / tensions[i], 1, 1e-10) << "rod " << i << ", h " << h;
      EXPECT_NEAR(force(stiff.work, i, 1) / tensions[i], 1, 1e-10) << "pin " << i << ", h " << h;
      EXPECT_NEAR(force(stiff.work, i, 0) / tensions[i], 0, 1e-10) << "pin " << i << ", h " << h;
    }
  }
}

/// Lets a scene come to rest: whenever it has begun to slow down, all motion is taken from it.
template <class M>
void come_to_rest(Simulation<M>& simulation, double h, int steps_at_most) {
  double before = 0;
  for (int i = 0; i < steps_at_most; ++i) {
    simulation.step(h);
    const double now = kinetic_energy(simulation.scene.bodies());
    if (now < before) {
      for (auto& v : simulation.scene.state().velocity) v.setZero();
      before = 0;
    } else {
      before = now;
    }
  }
}

/// Sag of a catenary of this length over this span [m]: y = a cosh(x/a) with 2a sinh(span/2a) = length.
double catenary_sag(double length, double span) {
  double low = 1e-3 * length, high = 1e3 * length;
  for (int i = 0; i < 200; ++i) {
    const double a = (low + high) / 2;
    (2 * a * std::sinh(span / (2 * a)) > length ? low : high) = a;
  }
  return low * (std::cosh(span / (2 * low)) - 1);
}

TEST(LawA6, ASlackChainTendsToTheCatenaryAsTheSquareOfItsLinks) {
  const double length = 2, span = 1.4, exact = catenary_sag(length, span);
  const auto error = [&](int links) {
    Simulation<PlaneParticle> simulation{slack_chain<PlaneParticle>(links, length, span),
                                         {Direct{}, Baumgarte{1}}};
    come_to_rest(simulation, 0.1 / links, 200 * links);
    EXPECT_LT(position_error(simulation).max, 1e-8);
    return -simulation.scene.bodies().pose[links / 2].position.y() - exact;
  };
  double coarse = error(8);
  for (const int links : {16, 32, 64}) {
    const double fine = error(links);
    EXPECT_NEAR(order(coarse, fine), 2, 0.05) << links;
    coarse = fine;
  }
}

}  // namespace law_tensions_test
