#include <gtest/gtest.h>

#include "solver/byhand.hpp"

// What a program learns of contacts.
namespace touches_test {

using namespace byhand;
constexpr double h = 1.0 / 60, g = 9.81;

/// Unit boxes of 1, 2, 3 … kg one on the other on the ground, at rest.
template <class M>
Simulation<M> stack(int boxes) {
  Scene<M> scene;
  scene.set_shape(scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>()), HalfSpace<M>{Linear<M>::Unit(1)});
  for (int i = 0; i < boxes; ++i) {
    const Linear<M> sides = Linear<M>::Ones();
    scene.set_shape(scene.add_body(Linear<M>((i + 0.5) * Linear<M>::Unit(1)), box<M>(i + 1, sides)),
                    Box<M>{sides});
  }
  Simulation<M> simulation{std::move(scene)};
  for (int i = 0; i < 120; ++i) simulation.step(h);
  return simulation;
}

template <class F>
void with_bodies(F&& f) {
  f.template operator()<PlaneBody>();
  f.template operator()<SpaceBody>();
}

TEST(Touches, OfARestingStackCarryTheWeightAboveThem) {
  with_bodies([]<class M>() {
    const auto simulation = stack<M>(4);
    const auto touches = simulation.touches();
    ASSERT_EQ(touches.size(), 4u);
    for (int i = 0; i < 4; ++i) {
      const Touch<M>& touch = touches[i];
      EXPECT_EQ(touch.body1, i);
      EXPECT_EQ(touch.body2, i + 1);
      double weight = 0, pressing = 0;
      for (int above = i + 1; above <= 4; ++above) weight += above * g;
      for (const auto& point : touch.points) {
        pressing += point.normal_impulse;
        EXPECT_NEAR(point.at.y(), i, 2e-3);
        EXPECT_NEAR(std::abs(point.at.x()), 0.5, 1e-3) << "at a corner";
        EXPECT_NEAR(point.separation, 0, 2e-3);
      }
      EXPECT_NEAR(pressing, weight * h, 1e-4 * weight * h);
      // In space the stack still leans by 5e-5, and friction holds it there.
      EXPECT_NEAR(touch.impulse[1], weight * h, 1e-4 * weight * h);
      EXPECT_LE((touch.impulse - weight * h * Linear<M>::Unit(1)).norm(), 1e-3 * weight * h);
      EXPECT_LE((touch.normal - Linear<M>::Unit(1)).norm(), M::linear == 2 ? 1e-9 : 1e-4);
      EXPECT_EQ(touch.points.size(), M::linear == 2 ? 2u : 4u);
      EXPECT_FALSE(touch.began);
    }
    EXPECT_TRUE(simulation.parted().empty());
  });
}

// A step of a sliding box: what the ground gives it, friction as well, is the change of its momentum.
TEST(Touches, GiveTheChangeOfMomentumWithFriction) {
  with_bodies([]<class M>() {
    auto simulation = stack<M>(1);
    simulation.scene.apply_impulse(1, 3 * Linear<M>::Unit(0));
    for (int i = 0; i < 5; ++i) {
      const Linear<M> before = linear_momentum(simulation.scene.bodies());
      simulation.step(h);
      const auto touches = simulation.touches();
      ASSERT_EQ(touches.size(), 1u);
      const Linear<M> gain = linear_momentum(simulation.scene.bodies()) - before - h * simulation.scene.gravity;
      EXPECT_LE((touches[0].impulse - gain).norm(), 1e-12);
      EXPECT_NEAR(touches[0].impulse.x(), -0.6 * touches[0].impulse.y(), 1e-9) << "it slips";
    }
  });
}

TEST(Touches, BeginWhereABallLandsAndEndWhereItIsKickedAway) {
  with_bodies([]<class M>() {
    Scene<M> scene;
    scene.set_shape(scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>()), HalfSpace<M>{Linear<M>::Unit(1)});
    const int round = scene.add_body(Linear<M>(Linear<M>::Unit(1)), ball<M>(1, 0.1));
    scene.set_shape(round, Ball<M>{0.1});
    Simulation<M> simulation{std::move(scene)};
    int began = 0, ended = 0;
    for (int i = 0; i < 60; ++i) {
      simulation.step(h);
      EXPECT_TRUE(simulation.parted().empty());
      for (const auto& touch : simulation.touches()) {
        if (!touch.began) continue;
        ++began;
        // From 0.9 m with 4.2 m/s: it lands after 0.43 s.
        EXPECT_NEAR(simulation.time, std::sqrt(2 * 0.9 / g), 2 * h);
      }
    }
    EXPECT_EQ(began, 1);
    EXPECT_EQ(simulation.touches().size(), 1u) << "it lies";
    simulation.scene.apply_impulse(round, 3 * Linear<M>::Unit(1));
    for (int i = 0; i < 10; ++i) {
      simulation.step(h);
      EXPECT_TRUE(simulation.touches().empty());
      for (const auto& pair : simulation.parted()) {
        EXPECT_EQ(pair, BodyPair(0, round));
        EXPECT_EQ(i, 0);
        ++ended;
      }
    }
    EXPECT_EQ(ended, 1);
  });
}

TEST(Touches, AreNoneBeforeAStepAndNoneWhereNothingHasAShape) {
  Scene<PlaneBody> scene;
  scene.add_body({0, 0}, box<PlaneBody>(1, {1, 1}));
  Simulation simulation{scene};
  EXPECT_TRUE(simulation.touches().empty());
  simulation.step(h);
  EXPECT_TRUE(simulation.touches().empty());
  EXPECT_TRUE(simulation.parted().empty());
}

TEST(Layers, LetABodyFallThroughWhatItDoesNotMeet) {
  with_bodies([]<class M>() {
    Scene<M> scene;
    const int ground = scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>());
    scene.set_shape(ground, HalfSpace<M>{Linear<M>::Unit(1)});
    // A box that meets the ground, one that meets neither the ground nor the third, and one in the same place that
    // meets all.
    const Layers layers[] = {{}, {.in = 2, .meets = ~5u}, {.in = 4}};
    for (int i = 0; i < 3; ++i) {
      const int crate = scene.add_body(Linear<M>(Linear<M>::Unit(1) + (i == 2 ? 1 : i) * 4 * Linear<M>::Unit(0)),
                                       box<M>(1, Linear<M>::Ones()));
      scene.set_shape(crate, Box<M>{Linear<M>::Ones()}, {}, layers[i]);
    }
    Simulation<M> simulation{std::move(scene)};
    for (int i = 0; i < 120; ++i) simulation.step(h);
    const auto height = [&](int body) { return simulation.scene.bodies().pose[body].position.y(); };
    EXPECT_NEAR(height(1), 0.5, 2e-3);
    EXPECT_NEAR(height(2), 1 - g * 2 * (2 + h) / 2, 1e-9) << "in free fall";
    EXPECT_NEAR(height(3), 0.5, 2e-3) << "one that does not meet it is not met either";
    simulation.scene.set_shape(1, Box<M>{Linear<M>::Ones()}, {}, {.meets = 0});
    for (int i = 0; i < 60; ++i) simulation.step(h);
    EXPECT_LT(height(1), -4) << "a change is noticed";
  });
}

TEST(Impulse, OfARopeThatNeverHeldOrIsGoneIsRefusedOrZero) {
  using M = PlaneParticle;
  Scene<M> scene;
  scene.add_body({0, 0}, fixed<M>());
  scene.add_body({0, -1}, with_mass<M>(1));
  const auto rope = scene.add(Rope<M>{{0, 1}, 2});
  Simulation simulation{scene};
  EXPECT_THROW(simulation.impulse(rope), std::invalid_argument) << "no step yet";
  simulation.step(h);
  ASSERT_EQ(simulation.impulse(rope).size(), 1u);
  EXPECT_EQ(simulation.impulse(rope)[0], 0);
  EXPECT_THROW(simulation.impulse(7), std::invalid_argument);
  simulation.scene.remove(rope);
  EXPECT_THROW(simulation.impulse(rope), std::invalid_argument);
}

}  // namespace touches_test
