#include <gtest/gtest.h>

#include "lessons/scenes/balls.hpp"
#include "tests/solver/law_motion.hpp"

// What stands beside law 16, whose limit is among the laws' boundaries.
namespace {

using namespace byhand;
using M = PlaneBody;
constexpr double h = 1.0 / 60;

TEST(LawB16, WhatIsSeenInTimeStopsAtTheWallAndNotInIt) {
  Scene<M> scene = bouncing_ball<M>(0.15, 0);
  scene.set_margin(0.2);
  scene.state().velocity[1].y() = -100;
  Simulation<M> simulation{std::move(scene), {}};
  simulation.step(h);
  EXPECT_NEAR(simulation.scene.bodies().pose[1].position.y(), 0.5, 1e-14);
}

TEST(LawB16, AHalfSpaceIsNeverPassed) {
  for (const double speed : {10.0, 1e3, 1e5}) {
    Scene<M> scene = bouncing_ball<M>(1, 0);
    scene.state().velocity[1].y() = -speed;
    Simulation<M> simulation{std::move(scene), {}};
    run(simulation, 2, h);
    EXPECT_GE(simulation.scene.bodies().pose[1].position.y(), 0.5 - 1e-9);
  }
}

}  // namespace
