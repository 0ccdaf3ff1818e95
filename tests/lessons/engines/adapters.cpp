#include <gtest/gtest.h>

#include "lessons/engines/contest.hpp"
#include "lessons/exact/compound_pendulum.hpp"
#include "lessons/exact/simple_pendulum.hpp"
#include "lessons/scenes/boxes.hpp"
#include "lessons/scenes/incline.hpp"
#include "lessons/scenes/pendulum.hpp"
#include "solver/measure.hpp"

// A wrong adapter would slander an engine. Each engine reproduces what any engine has to, at a step that is short
// enough.
namespace byhand::engines {
namespace adapters_test {

using M = PlaneBody;
constexpr int short_steps = 64;  // a frame

class Adapter : public testing::TestWithParam<int> {
 protected:
  const Engine& engine() const { return all_engines().at(GetParam()); }
  template <class Model = M>
  Scene<Model> after(const Scene<Model>& scene, double time, int steps = short_steps) const {
    Scene<Model> end = scene;
    run<Model>(theirs<Model>(engine(), engine().usual, steps), scene, static_cast<int>(std::lround(time / frame)),
               [&](const Scene<Model>& seen, double) { end = seen; });
    return end;
  }
};

TEST_P(Adapter, FallsByHalfGTSquared) {
  Scene<M> scene;
  const Velocity<M> thrown(3, 0, 2);
  scene.add_body(Linear<M>(1, 5), box<M>(2, {1, 0.5}), thrown);
  const Scene<M> end = after(scene, 0.5);
  const Pose<M>& pose = end.bodies().pose[0];
  EXPECT_NEAR(pose.position.x(), 1 + 3 * 0.5, 1e-4);
  EXPECT_NEAR(pose.position.y(), 5 - 0.5 * 9.81 * 0.25, 9.81 * 0.5 * frame / short_steps)
      << "half a step more or less";
  EXPECT_NEAR(std::atan2(pose.rotation.sin, pose.rotation.cos), 1, 1e-4);
  EXPECT_NEAR(end.bodies().velocity[0].y(), -9.81 * 0.5, 1e-4);
}

TEST_P(Adapter, SwingsARodOnAPinAsTheEllipticIntegralSays) {
  const Scene<M> end = after(hinged_rod(1, 1.5, 2), 1);
  const PlaneRotation<double> turned = end.bodies().pose[1].rotation;
  const CompoundPendulum exact(1, 1.5, 2, 9.81);
  EXPECT_NEAR(std::atan2(turned.sin, turned.cos), exact.angle(1), 0.01 * std::abs(exact.angle(1)));
  EXPECT_NEAR(end.bodies().velocity[1][2], exact.angular_velocity(1), 0.01 * std::abs(exact.angular_velocity(1)));
  EXPECT_LT(position_error(end).max, 1e-3);
}

TEST_P(Adapter, SwingsABobOnARodAsTheEllipticIntegralSays) {
  if (!engine().rods) GTEST_SKIP() << engine().name << " has no rigid rod";
  const Scene<M> end = after(pendulum<M>(1, 1.5, 2), 1);
  const Linear<M> bob = end.bodies().pose[1].position;
  const SimplePendulum exact(1, 1.5, 9.81);
  EXPECT_NEAR(std::atan2(bob.x(), -bob.y()), exact.angle(1), 0.01 * std::abs(exact.angle(1)));
  EXPECT_NEAR(bob.norm(), 1.5, 1e-3);
}

TEST_P(Adapter, LaysABoxOnTheGroundWhereItIs) {
  const Scene<M> end = after(stack(1), 1, 4);
  EXPECT_NEAR(end.bodies().pose[1].position.y(), 0.5, 0.006) << "the slop of Box2D is 5 mm";
  EXPECT_NEAR(end.bodies().pose[1].position.x(), 0, 1e-4);
}

TEST_P(Adapter, LetsABoxSlideAsCoulombSays) {
  const double slope = 0.5, friction = 0.3, time = 0.5;
  const Scene<M> start = box_on_incline(slope, friction);
  const Scene<M> end = after(start, time, 16);
  const double way = (end.bodies().pose[1].position - start.bodies().pose[1].position).norm(),
               exact = 0.5 * 9.81 * (std::sin(slope) - friction * std::cos(slope)) * time * time;
  EXPECT_NEAR(way, exact, 0.03 * exact);
}

TEST_P(Adapter, LeavesABoxOnASlopeThatFrictionHolds) {
  const Scene<M> start = box_on_incline(0.2, 0.3);
  const Scene<M> end = after(start, 0.5, 16);
  EXPECT_LT((end.bodies().pose[1].position - start.bodies().pose[1].position).norm(), 0.01);
}

TEST_P(Adapter, LaysAndSwingsInSpaceToo) {
  if (engine().plane) GTEST_SKIP() << engine().name << " knows the plane alone";
  using S = SpaceBody;
  const Scene<S> lying = after<S>(stack<S>(1), 1, 4);
  EXPECT_LT((lying.bodies().pose[1].position - stack<S>(1).bodies().pose[1].position).norm(), 0.006);
  const Scene<S> swung = after<S>(hinged_rod<S>(1, 1.5, 2), 1);
  const Linear<S> middle = swung.bodies().pose[1].position;
  const CompoundPendulum exact(1, 1.5, 2, 9.81);
  EXPECT_NEAR(std::atan2(middle.x(), -middle.y()), exact.angle(1), 0.01 * std::abs(exact.angle(1)));
}

INSTANTIATE_TEST_SUITE_P(Each, Adapter, testing::Range(0, static_cast<int>(all_engines().size())),
                         [](const auto& tested) {
                           std::string name = all_engines()[tested.param].name;
                           std::erase_if(name, [](char c) { return !std::isalnum(c); });
                           return name;
                         });
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Adapter);

TEST(Engines, EachIsThereOrNamedAsMissing) {
  EXPECT_GE(all_engines().size() + missing().size(), 5U);
  for (const Engine& engine : all_engines()) {
    EXPECT_FALSE(engine.version.empty());
    EXPECT_EQ(std::count(missing().begin(), missing().end(), engine.name), 0);
  }
}

}  // namespace adapters_test
}  // namespace byhand::engines
