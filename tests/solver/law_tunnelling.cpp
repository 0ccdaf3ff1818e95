#include <gtest/gtest.h>

#include "lessons/scenes/balls.hpp"
#include "tests/solver/law_motion.hpp"

// What stands beside law 16, whose limit is among the laws' boundaries.
namespace law_tunnelling_test {

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

// With the lookahead a wall is seen however thin it is and however fast what flies at it, straight or aslant.
TEST(LawB16, WhatLooksAheadStopsAtAnyWall) {
  for (const double thickness : {0.001, 0.1})
    for (const double speed : {1.0, 30.0, 1e3, 1e5})
      for (const double slope : {0.0, 0.5})
        for (const double phase : {0.0, 0.3, 0.7}) {
          Scene<M> scene;
          scene.gravity.setZero();
          scene.set_shape(scene.add_body({0, 0}, fixed<M>()), Box<M>{{thickness, 1e7}}, {0, 0});
          const Velocity<M> v(speed, slope * speed, 0);
          scene.set_shape(scene.add_body({-2.0 - phase * speed * h, 0}, ball<M>(1, 0.05), v), Ball<M>{0.05},
                          {0, 0});
          Simulation<M> simulation{std::move(scene), {}};
          for (double time = 0; time < 4 / speed + 5 * h; time += h) simulation.step(h);
          const auto& ball = simulation.scene.bodies();
          EXPECT_NEAR(ball.pose[1].position.x(), -0.05 - thickness / 2, 1e-9) << speed << ' ' << slope;
          EXPECT_NEAR(ball.velocity[1].y(), slope * speed, 1e-9 * speed);
        }
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

}  // namespace law_tunnelling_test
