#include <gtest/gtest.h>

#include "solver/byhand.hpp"

// What a program learns of contacts.
namespace {

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
      EXPECT_LE((touch.impulse - weight * h * Linear<M>::Unit(1)).norm(), 1e-4 * weight * h);
      EXPECT_LE((touch.normal - Linear<M>::Unit(1)).norm(), 1e-9);
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

TEST(Touches, BeginAndEndOnceInABounce) {
  with_bodies([]<class M>() {
    Scene<M> scene;
    scene.set_shape(scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>()), HalfSpace<M>{Linear<M>::Unit(1)});
    const int ball_ = scene.add_body(Linear<M>(Linear<M>::Unit(1)), ball<M>(1, 0.1));
    scene.set_shape(ball_, Ball<M>{0.1}, {.restitution = 0.8});
    Simulation<M> simulation{std::move(scene)};
    std::vector<std::string> events;
    while (simulation.time < 1.2) {
      const bool down = simulation.scene.bodies().velocity[ball_][1] < 0;
      simulation.step(h);
      const bool up = simulation.scene.bodies().velocity[ball_][1] > 0;
      for (const auto& touch : simulation.touches()) events.push_back(touch.began ? "began" : "goes on");
      for (const auto& pair : simulation.parted()) {
        EXPECT_EQ(pair, BodyPair(0, ball_));
        events.push_back("ended");
      }
      EXPECT_EQ(!simulation.touches().empty(), down && up) << "it presses in the step in which it turns";
    }
    // It falls from 0.9 m: at 0.43 s, and again 2 e v/g = 0.69 s later.
    EXPECT_EQ(events, (std::vector<std::string>{"began", "ended", "began", "ended"}));
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

}  // namespace
