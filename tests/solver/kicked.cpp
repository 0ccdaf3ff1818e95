#include <gtest/gtest.h>

#include "lessons/scenes/boxes.hpp"
#include "solver/measure.hpp"
#include "tests/solver/random.hpp"

// What stands only as long as nobody looks is unmasked by a kick: sideways, at random between nothing and 0.02 m/s
// times the height over the topmost one's, from twenty seeds.
namespace kicked_test {

using namespace byhand;

constexpr double h = 1.0 / 60;

Simulation<PlaneBody> kicked(Scene<PlaneBody> scene, Random& random) {
  const double top = scene.bodies().pose.back().position.y();
  for (int i = 1; i < scene.bodies().size(); ++i)
    scene.state().velocity[i].x() = random.uniform(-0.02, 0.02) * scene.bodies().pose[i].position.y() / top;
  return {scene, VelocityStepping{ByGraph{}, Baumgarte{.beta = 0.2, .slop = 0.001, .speed_cap = 3}}};
}

/// How far the topmost box has gone [m].
double shift(const Simulation<PlaneBody>& simulation, const Scene<PlaneBody>& begin) {
  return (simulation.scene.bodies().pose.back().position - begin.bodies().pose.back().position).norm();
}

TEST(Kicked, AStackOfThirtyStandsAlsoUnderTenAndAHundredTimesItsBoxes) {
  Random random;
  for (const double top_mass : {1.0, 10.0, 100.0}) {
    const Scene<PlaneBody> begin = stack(30, top_mass);
    for (int seed = 0; seed < 20; ++seed) {
      auto simulation = kicked(begin, random);
      for (int i = 0; i < 1800; ++i) simulation.step(h);
      ASSERT_LT(shift(simulation, begin), 0.02) << top_mass << ", seed " << seed;
      ASSERT_LT(position_error(simulation).max, 1e-4) << top_mass << ", seed " << seed;
    }
  }
}

TEST(Kicked, AWallOfTwoHundredAndTenBoxesKeepsItsTopWithinFourMillimetres) {
  Random random;
  const Scene<PlaneBody> begin = pyramid(20);
  for (int seed = 0; seed < 20; ++seed) {
    auto simulation = kicked(begin, random);
    double deepest = 0;
    for (int i = 0; i < 300; ++i) {
      simulation.step(h);
      if (i % 10 == 0) deepest = std::max(deepest, position_error(simulation).max);
    }
    ASSERT_LT(shift(simulation, begin), 0.004) << "seed " << seed;
    ASSERT_LT(deepest, 0.001) << "seed " << seed;
  }
}

}  // namespace kicked_test
