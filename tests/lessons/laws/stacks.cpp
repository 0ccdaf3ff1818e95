#include <gtest/gtest.h>

#include "lessons/laws/closed_forms.hpp"
#include "lessons/scenes/boxes.hpp"
#include "solver/constraints/contact.hpp"
#include "solver/constraints/friction.hpp"
#include "tests/solver/law_motion.hpp"

// Atlas B9, B18 and B20: what makes columns sink, lean and fall, and what does not.
namespace stacks_test {

using namespace byhand;
using M = PlaneBody;
constexpr double g = 9.81, h = 1.0 / 60;

/// How long a kicked stack stands [s], at most `time`.
double stands(int count, const VelocityStepping& method, double time, double top_mass = 1) {
  Simulation<M> simulation{stack(count, top_mass), method};
  kick(simulation.scene, 0.02);
  while (simulation.time < time) {
    simulation.step(h);
    if (simulation.scene.bodies().pose[count].position.y() < count - 1) break;
  }
  return simulation.time;
}

TEST(LawB18, AColumnStandsIffItIsSweptOftenEnough) {
  struct Case {
    int count, falls, stands;
  };
  for (const auto [count, falling, standing] : {Case{8, 1, 2}, {10, 2, 3}, {15, 6, 8}, {20, 14, 19}}) {
    const double law = laws::sweeps_to_stand(count, g, h);
    EXPECT_TRUE(falling < law && law < standing) << count << " boxes: " << law;
    EXPECT_LT(stands(count, {GaussSeidel{falling}, NoDriftCure{}}, 30), 30) << count << " boxes";
    EXPECT_GE(stands(count, {GaussSeidel{standing}, NoDriftCure{}}, 30), 30) << count << " boxes";
  }
}

TEST(LawB18, ShorterStepsAreWorthTheirSquareInSweeps) {
  // A quarter of the step takes (σh)² to a sixteenth: one sweep in each does the work of seven in a whole one, and
  // more.
  VelocityStepping method{GaussSeidel{1}, NoDriftCure{}};
  EXPECT_LT(stands(15, method, 30), 30);
  method.substeps = 4;
  EXPECT_GE(stands(15, method, 30), 30);
}

TEST(LawB20, SolvedDirectlyAHundredBoxesStandAKick) { EXPECT_GE(stands(100, {Direct{}}, 30), 30); }

TEST(LawB20, SolvedDirectlyThirtyBoxesStandAKickUnderAHundredTimesTheirWeight) {
  for (const double top_mass : {10.0, 100.0}) EXPECT_GE(stands(30, {ByGraph{}}, 30, top_mass), 30) << top_mass;
}

TEST(LawB9, AColdStackSinksTheMoreTheFewerItsSweeps) {
  double last = 1;
  for (const int sweeps : {2, 4, 8, 16, 32, 64}) {
    Simulation<M> simulation{stack(5), {GaussSeidel{.sweeps = sweeps, .warm_start = false}, Baumgarte{}}};
    run(simulation, 10, h);
    const double sunk = 4.5 - simulation.scene.bodies().pose[5].position.y();
    EXPECT_LT(sunk, 0.6 * last) << sweeps;
    EXPECT_GT(sunk, 1e-6) << sweeps;
    last = sunk;
  }
}

TEST(LawB9, AWarmStackDoesNotSink) {
  Simulation<M> simulation{stack(5), {GaussSeidel{20}, Baumgarte{}}};
  run(simulation, 10, h);
  EXPECT_NEAR(simulation.scene.bodies().pose[5].position.y(), 4.5, 1e-3);
}

/// A stack on contacts at the corners of each box, each with friction, left before right or right before left.
Scene<M> stack_on_corners(int count, double first) {
  Scene<M> scene;
  scene.add_body({0, 0}, fixed<M>());
  for (int i = 1; i <= count; ++i) {
    scene.add_body({0, i - 0.5}, box<M>(1, {1, 1}));
    for (const double x : {first, -first}) {
      const auto at = between<M>(scene.bodies(), i - 1, {x, i - 1.0}, i, {x, i - 1.0});
      const auto contact = scene.add(Contact<M>{at});
      scene.add(Friction<M>{at, tangents_of<M>({0, 1}), 0.6, contact});
    }
  }
  return scene;
}

TEST(LawB9, TheOtherOrderOfSweepingMirrorsTheDriftToTheLastBit) {
  for (const int sweeps : {1, 10}) {
    Simulation<M> left{stack_on_corners(5, -0.5), {GaussSeidel{sweeps}, Baumgarte{}}},
        right{stack_on_corners(5, 0.5), {GaussSeidel{sweeps}, Baumgarte{}}};
    run(left, 1, h);
    run(right, 1, h);
    for (int i = 1; i <= 5; ++i) {
      const Pose<M>&a = left.scene.bodies().pose[i], &b = right.scene.bodies().pose[i];
      EXPECT_NE(a.position.x(), 0);
      EXPECT_EQ(a.position.x(), -b.position.x()) << i;
      EXPECT_EQ(a.position.y(), b.position.y()) << i;
      EXPECT_EQ(a.rotation.sin, -b.rotation.sin) << i;
    }
  }
}

TEST(LawB9, FacesHaveNoLeftAndNoRight) {
  Simulation<M> simulation{stack(5), {GaussSeidel{3}, NoDriftCure{}}};
  run(simulation, 1, h);
  for (int i = 1; i <= 5; ++i) EXPECT_NEAR(simulation.scene.bodies().pose[i].position.x(), 0, 1e-14) << i;
}

}  // namespace stacks_test
