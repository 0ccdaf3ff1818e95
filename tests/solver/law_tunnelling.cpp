#include <gtest/gtest.h>

#include "solver/scenes/balls.hpp"
#include "tests/solver/law_motion.hpp"

// Atlas B16: contacts are looked for once a step, so that what is fast enough passes a wall between two looks. A
// ball of radius r is turned back by a wall of thickness w if it is seen before its centre has passed the middle
// of the wall: from `margin` before they touch. That way is r + margin + w/2 long, and safe is what goes no
// further in a step.
namespace {

using namespace byhand;
using M = PlaneBody;
constexpr double h = 1.0 / 60, radius = 0.05, wall = 0.1;

/// How many of a hundred balls that fly at `speed` [m/s], each a hundredth of a step ahead of the one before, end
/// behind the wall.
int how_many_pass(double speed, double margin) {
  int passed = 0;
  for (int i = 0; i < 100; ++i) {
    Scene<M, Contact> scene;
    scene.gravity.setZero();
    scene.colliders.margin = margin;
    scene.set_shape(scene.add_body({0, 0}, fixed<M>()), Box<M>{{0.5 * wall, 10}});
    const double start = -2 - (i + 0.5) / 100 * speed * h;
    scene.set_shape(scene.add_body({start, 0}, ball<M>(1, radius), {speed, 0, 0}), Ball<M>{radius});
    Simulation<Scene<M, Contact>> simulation{std::move(scene), {}};
    run(simulation, 1, h);
    passed += simulation.scene.bodies.pose[1].position.x() > 0;
  }
  return passed;
}

TEST(LawB16, NothingPassesAWallThatGoesNoFurtherInAStepThanItIsSeen) {
  for (const double margin : {0.02, 0.2}) {
    const double seen = radius + margin + wall / 2;
    EXPECT_EQ(how_many_pass(0.98 * seen / h, margin), 0) << margin;
    EXPECT_GT(how_many_pass(1.05 * seen / h, margin), 0) << margin;
  }
}

TEST(LawB16, FasterThanThatTheShareThatPassesIsWhatTheStepExceeds) {
  for (const double margin : {0.02, 0.2})
    for (const double times : {1.25, 2.0, 5.0}) {
      const double seen = radius + margin + wall / 2;
      EXPECT_NEAR(how_many_pass(times * seen / h, margin), 100 * (1 - 1 / times), 2) << margin << ", " << times;
    }
}

TEST(LawB16, WhatIsSeenInTimeStopsAtTheWallAndNotInIt) {
  Scene<M, Contact> scene = bouncing_ball<M>(0.15, 0);
  scene.colliders.margin = 0.2;
  scene.bodies.velocity[1].y() = -100;
  Simulation<Scene<M, Contact>> simulation{std::move(scene), {}};
  simulation.step(h);
  EXPECT_NEAR(simulation.scene.bodies.pose[1].position.y(), 0.5, 1e-14);
}

TEST(LawB16, AHalfSpaceIsNeverPassed) {
  for (const double speed : {10.0, 1e3, 1e5}) {
    Scene<M, Contact> scene = bouncing_ball<M>(1, 0);
    scene.bodies.velocity[1].y() = -speed;
    Simulation<Scene<M, Contact>> simulation{std::move(scene), {}};
    run(simulation, 2, h);
    EXPECT_GE(simulation.scene.bodies.pose[1].position.y(), 0.5 - 1e-9);
  }
}

}  // namespace
