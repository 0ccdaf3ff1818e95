#include <gtest/gtest.h>

#include "lessons/scenes/balls.hpp"
#include "tests/solver/law_motion.hpp"

// What stands beside law 16, whose limit is among the laws' boundaries.
namespace law_tunnelling_test {

using namespace byhand;
constexpr double h = 1.0 / 60;

TEST(LawB16Balls, WhatIsSeenInTimeStopsAtTheWallAndNotInIt) {
  using M = PlaneBody;
  Scene<M> scene = bouncing_ball<M>(0.15, 0);
  scene.set_margin(0.2);
  scene.state().velocity[1].y() = -100;
  Simulation<M> simulation{std::move(scene), {}};
  simulation.step(h);
  EXPECT_NEAR(simulation.scene.bodies().pose[1].position.y(), 0.5, 1e-14);
}

// With the lookahead a wall is seen however thin it is and however fast what flies at it, straight or aslant.
TEST(LawB16Balls, WhatLooksAheadStopsAtAnyWall) {
  using M = PlaneBody;
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

TEST(LawB16Balls, AHalfSpaceIsNeverPassed) {
  using M = PlaneBody;
  for (const double speed : {10.0, 1e3, 1e5}) {
    Scene<M> scene = bouncing_ball<M>(1, 0);
    scene.state().velocity[1].y() = -speed;
    Simulation<M> simulation{std::move(scene), {}};
    run(simulation, 2, h);
    EXPECT_GE(simulation.scene.bodies().pose[1].position.y(), 0.5 - 1e-9);
  }
}

/// A bar of 1 m that flies at a plate 20 mm thick.
template <class M>
Simulation<M> bar_at_plate(double speed, double tilt, double phase) {
  const Linear<M> along = Linear<M>::UnitX(), plate_half = Linear<M>::Constant(60) - 59.99 * along,
                  bar_half = Linear<M>::Constant(0.05) + 0.45 * along;
  Scene<M> scene;
  scene.gravity.setZero();
  scene.set_shape(scene.add_body(Linear<M>::Zero(), fixed<M>()), Box<M>{plate_half});
  Pose<M> pose{(-0.6 - phase * speed * h) * along, {}};
  if constexpr (M::linear == 2)
    pose.rotation = plane_rotation(tilt);
  else
    pose.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(tilt, Eigen::Vector3d(0, 0.6, 0.8)));
  Velocity<M> V = Velocity<M>::Zero();
  V[0] = speed;
  scene.set_shape(scene.add_body(pose, box<M>(1, bar_half), V), Box<M>{bar_half});
  return Simulation<M>{std::move(scene), {}};
}

template <class M>
class LawB16 : public testing::Test {};
using Turning = testing::Types<PlaneBody, SpaceBody>;
TYPED_TEST_SUITE(LawB16, Turning);

// One end strikes and the other swings on, along a path on which the search at the start of the step did not look.
TYPED_TEST(LawB16, ABarDoesNotSwingThroughAThinPlate) {
  for (const double speed : {5.0, 20.0, 50.0, 300.0})
    for (double tilt = -1.5; tilt <= 1.5; tilt += 0.25)
      for (double phase = 0; phase < 1; phase += 0.125) {
        auto simulation = bar_at_plate<TypeParam>(speed, tilt, phase);
        for (int i = 0; i < 60; ++i) {
          simulation.step(h);
          const double x = simulation.scene.bodies().pose[1].position.x();
          ASSERT_LT(x, 0) << speed << " m/s, tilt " << tilt << ", phase " << phase << ", step " << i;
        }
      }
}

// A ball at rest, struck within the step, meets a wall that the search did not look at.
TYPED_TEST(LawB16, WhatIsStruckStopsAtTheNextWall) {
  using M = TypeParam;
  for (const double speed : {5.0, 50.0, 500.0})
    for (const double gap : {0.02, 0.1, 0.5}) {
      Scene<M> scene;
      scene.gravity.setZero();
      const Linear<M> along = Linear<M>::UnitX();
      const Velocity<M> V = speed * Velocity<M>::Unit(0);
      scene.set_shape(scene.add_body(Linear<M>::Zero(), fixed<M>()),
                      Box<M>{Linear<M>::Constant(5) - 4.999 * along});
      scene.set_shape(scene.add_body((-0.051 - gap) * along, ball<M>(1, 0.05)), Ball<M>{0.05});
      scene.set_shape(scene.add_body((-0.2 - gap) * along, ball<M>(1, 0.05), V), Ball<M>{0.05});
      Simulation<M> simulation{std::move(scene), {}};
      for (int i = 0; i < 30; ++i) simulation.step(h);
      EXPECT_LE(simulation.scene.bodies().pose[1].position.x(), -0.05) << speed << ' ' << gap;
    }
}

// The heavy ball hardly notices: what is struck has to be seen by itself, whichever body it is.
TYPED_TEST(LawB16, WhatAHeavyBallStrikesAslantStopsAtTheNextWall) {
  using M = TypeParam;
  const Linear<M> up = Linear<M>::UnitY();
  for (const double speed : {5.0, 50.0, 500.0})
    for (const int struck : {0, 1}) {
      Scene<M> scene;
      scene.gravity.setZero();
      for (int i = 0; i < 2; ++i) {
        const Linear<M> at = (i == struck ? 0 : -0.071) * (Linear<M>::UnitX() + up);
        const Velocity<M> V = (i == struck ? 0 : speed) * Velocity<M>::Unit(0);
        scene.set_shape(scene.add_body(at, ball<M>(i == struck ? 1 : 1e9, 0.05), V), Ball<M>{0.05});
      }
      scene.set_shape(scene.add_body(0.2 * up, fixed<M>()), Box<M>{Linear<M>::Constant(100) - 99.999 * up});
      Simulation<M> simulation{std::move(scene), {}};
      for (int i = 0; i < 10; ++i) simulation.step(h);
      EXPECT_LE(simulation.scene.bodies().pose[struck].position.y(), 0.15) << speed;
    }
}

TYPED_TEST(LawB16, ABoxStopsOnAPlaneWhereverItLiesAndWhicheverComesFirst) {
  using M = TypeParam;
  for (const double height : {-100.0, 100.0})
    for (const int crate : {0, 1}) {
      Scene<M> scene;
      Velocity<M> V = -10 * Velocity<M>::Unit(1);
      V[M::dof - 1] = 3.5;  // it lands on an edge
      for (int i = 0; i < 2; ++i) {
        const Linear<M> at = (height + (i == crate ? 3 : 0)) * Linear<M>::UnitY(), sides = Linear<M>::Ones();
        if (i == crate)
          scene.set_shape(scene.add_body(at, box<M>(1, sides), V), Box<M>{sides});
        else
          scene.set_shape(scene.add_body(at, fixed<M>()), HalfSpace<M>{Linear<M>::UnitY()});
      }
      Simulation<M> simulation{std::move(scene), {}};
      for (int i = 0; i < 30; ++i) {
        simulation.step(h);
        ASSERT_GT(simulation.scene.bodies().pose[crate].position.y(), height + 0.45) << i;
      }
    }
}

// Who began to press within a step is told of it, in as many parts as it may have been taken.
TYPED_TEST(LawB16, AStepInPartsTellsOfItsTouchesOnce) {
  auto simulation = bar_at_plate<TypeParam>(50, 0.75, 0.5);
  int began = 0, parted = 0, solves = 0;
  bool pressed = false;
  for (int i = 0; i < 60; ++i) {
    const long long before = simulation.work.executed.solves;
    simulation.step(h);
    solves = std::max(solves, static_cast<int>(simulation.work.executed.solves - before));
    const auto touches = simulation.touches();
    for (const auto& touch : touches) {
      EXPECT_EQ(touch.began, !pressed);
      began += touch.began;
    }
    parted += static_cast<int>(simulation.parted().size());
    EXPECT_EQ(simulation.parted().size(), pressed && touches.empty());
    pressed = !touches.empty();
  }
  EXPECT_GT(solves, 2);
  EXPECT_GE(began, 1);
  EXPECT_EQ(began, parted + pressed);
}

}  // namespace law_tunnelling_test
