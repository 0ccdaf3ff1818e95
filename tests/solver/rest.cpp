#include <gtest/gtest.h>

#include "lessons/scenes/card_house.hpp"
#include "lessons/scenes/dominoes.hpp"
#include "tests/solver/law_motion.hpp"

// What stands stays: a minute of it, by how fast anything is in its second half and how far anything has gone.
namespace rest_test {

using namespace byhand;
constexpr double h = 1.0 / 60;

struct Unrest {
  double speed = 0, shift = 0;  // [m/s, rad/s], [m]
};
Unrest unrest(const Scene<PlaneBody>& scene, const VelocityStepping& method) {
  Simulation<PlaneBody> simulation{scene, method};
  Unrest result;
  run(simulation, 30, h);
  run(simulation, 30, h, [&] {
    for (const auto& V : simulation.scene.bodies().velocity)
      result.speed = std::max(result.speed, V.cwiseAbs().maxCoeff());
  });
  for (int i = 0; i < scene.bodies().size(); ++i)
    result.shift = std::max(result.shift,
                            (simulation.scene.bodies().pose[i].position - scene.bodies().pose[i].position).norm());
  return result;
}

const Baumgarte with_slop{.beta = 0.2, .slop = 0.001};

TEST(Rest, OfAStackSolvedDirectlyIsExact) {
  const Unrest left = unrest(stack(10), {ByGraph{}});
  EXPECT_LE(left.speed, 1e-12);
  EXPECT_LE(left.shift, 1e-12);
}

TEST(Rest, OfStandingDominoesIsExact) {
  for (const RowSolver& solver : {RowSolver(ByGraph{}), RowSolver(GaussSeidel{})}) {
    const Unrest left = unrest(dominoes(10, 0.5), {solver});
    EXPECT_LE(left.speed, 1e-12);
    EXPECT_LE(left.shift, 1e-12);
  }
}

TEST(Rest, OfAStackAndAPyramidBySweepsIsExactOnceTheyHaveSunkIntoTheSlop) {
  for (const Scene<PlaneBody>& scene : {stack(10), pyramid(10)}) {
    const Unrest left = unrest(scene, {GaussSeidel{26}, with_slop});
    EXPECT_LE(left.speed, 1e-12);
    EXPECT_LE(left.shift, 0.004);
  }
}

// Sweeps that stop early leave some multiple of what they stopped at, 1e-6 of the largest push.
TEST(Rest, OfAPyramidByGraphIsWithinWhatItsSweepsStopAt) {
  const Unrest left = unrest(pyramid(10), {ByGraph{}, with_slop});
  EXPECT_LE(left.speed, 1e-6);
  EXPECT_LE(left.shift, 0.004);
}

TEST(Rest, WithoutSlopTheCorrectionKeepsATallStackAwake) {
  EXPECT_GT(unrest(stack(10), {GaussSeidel{}, Baumgarte{}}).speed, 0.1);
  EXPECT_LE(unrest(stack(3), {GaussSeidel{}, Baumgarte{}}).speed, 1e-12);
}

TEST(Rest, OfAHouseOfCardsIsFrictionsWork) {
  for (const int storeys : {1, 3}) {
    const Unrest left = unrest(card_house(storeys), {ByGraph{}, with_slop});
    EXPECT_LE(left.speed, 1e-5) << storeys;
    EXPECT_LE(left.shift, 0.004) << storeys;
  }
  EXPECT_GT(unrest(card_house(1, 0.3, {0.1}), {ByGraph{}, with_slop}).shift, 0.1) << "on ice it slides apart";
}

TEST(Dominoes, FallOneAfterTheOtherWhenTheFirstIsTipped) {
  Simulation<PlaneBody> simulation{dominoes(8, 0.5, 1.5), {ByGraph{}, with_slop}};
  double last = 0;
  for (int i = 1; i <= 8; ++i) {
    while (simulation.scene.bodies().pose[i].rotation.sin > -0.2 && simulation.time < 10) simulation.step(h);
    EXPECT_GT(simulation.time, last) << i;
    EXPECT_LT(simulation.time, 5) << i;
    last = simulation.time;
  }
  Simulation<PlaneBody> apart{dominoes(3, 1.5, 1.5), {ByGraph{}, with_slop}};
  run(apart, 5, h);
  EXPECT_LT(apart.scene.bodies().pose[1].rotation.sin, -0.9);
  EXPECT_NEAR(apart.scene.bodies().pose[2].rotation.sin, 0, 1e-9) << "too far to be reached";
}

}  // namespace rest_test
