#include <gtest/gtest.h>

#include "lessons/scenes/balls.hpp"
#include "solver/constraints/contact_manifold.hpp"
#include "solver/constraints/pin.hpp"
#include "tests/solver/law_motion.hpp"

// Contacts that are found: what becomes of them in a scene, and that their impulses are handed on from step to
// step.
namespace touching_test {

using namespace byhand;
using M = PlaneBody;
constexpr double g = 9.81, h = 1.0 / 60;

template <template <class> class Kind>
std::span<const Kind<M>> contacts(const Simulation<M>& simulation) {
  return simulation.work.contacts.constraints().all<Kind<M>>();
}

TEST(Touching, FindsAFaceForTwoBodiesOrAContactWithFrictionForEachPoint) {
  Simulation<PlaneBody> faces{stack(3), {}};
  Simulation<PlaneBody> points{by_points(stack(3)), {}};
  faces.step(h);
  points.step(h);
  EXPECT_EQ(contacts<ContactManifold>(faces).size(), 3u);
  EXPECT_EQ(contacts<Contact>(points).size(), 6u);
  EXPECT_EQ(contacts<Friction>(points).size(), 6u);
  EXPECT_EQ(points.scene.count(), 0);
}

TEST(Touching, WritesPointsThatLieOnBothSurfacesWithTheNormalFromTheFirstToTheSecond) {
  Simulation<PlaneBody> simulation{stack(2), {}};
  simulation.step(h);
  for (const auto& face : contacts<ContactManifold>(simulation)) {
    EXPECT_LT(face.at.body1, face.at.body2);
    EXPECT_NEAR((face.normal - Linear<M>(0, 1)).norm(), 0, 1e-12);
    EXPECT_NEAR(face.at.arms.second.y(), -0.5, 1e-12);
    EXPECT_NEAR(std::abs(face.at.arms.second.x()), 0.5, 1e-12);
  }
}

TEST(Touching, MixesSurfacesByTheRootOfTheirFrictionAndTheLargerRestitution) {
  Scene<PlaneBody> scene;
  add_ground(scene, {0.2, 0.1});
  add_unit_box(scene, 0, 0.5, 1, {0.8, 0.3});
  Simulation<PlaneBody> simulation{scene, {}};
  simulation.step(h);
  EXPECT_NEAR(contacts<ContactManifold>(simulation)[0].coefficient, 0.4, 1e-15);
  EXPECT_EQ(contacts<ContactManifold>(simulation)[0].restitution, 0.3);
}

TEST(Touching, LeavesAloneWhatIsFartherThanTheMarginAndWhatDoesNotMove) {
  for (const auto& [gap, found] : {std::pair(0.019, 1u), {0.021, 0u}}) {
    Scene<PlaneBody> scene;
    scene.gravity.setZero();
    add_ground(scene);
    add_unit_box(scene, 0, 0.5 + gap);
    const int shelf = scene.add_body({0.9, 0.5}, fixed<M>());
    scene.set_shape(shelf, Box<M>{{0.6, 1}});
    scene.state().pose[1].position.x() = -2;
    Simulation<PlaneBody> simulation{scene, {}};
    simulation.step(h);
    EXPECT_EQ(contacts<ContactManifold>(simulation).size(), found) << gap;
  }
}

TEST(Touching, TakesAnotherMarginFromTheNextStepOnThoughNothingMoves) {
  Scene<PlaneBody> scene;
  scene.gravity.setZero();
  add_ground(scene);
  add_unit_box(scene, 0, 0.55);
  Simulation<PlaneBody> simulation{scene, {}};
  for (const auto& [margin, found] : {std::pair(0.02, 0u), {0.06, 1u}, {0.04, 0u}}) {
    simulation.scene.set_margin(margin);
    simulation.step(h);
    EXPECT_EQ(contacts<ContactManifold>(simulation).size(), found) << margin;
  }
}

TEST(Touching, LetsBodiesThatAreJoinedPassThroughEachOther) {
  Scene<M> scene;
  scene.set_contact_rows(ContactRows::points);
  for (const double x : {0.0, 0.5}) {
    const int body = scene.add_body({x, 0}, box<M>(1, {1, 1}));
    scene.set_shape(body, Box<M>{{1, 1}});
  }
  auto apart = scene;
  scene.add(pin<M>(scene.bodies(), 0, 1, Linear<M>(0.25, 0)));
  Simulation<M> joined{scene, {}}, loose{apart, {}};
  joined.step(h);
  loose.step(h);
  EXPECT_EQ(contacts<Contact>(joined).size(), 0u);
  EXPECT_EQ(contacts<Contact>(loose).size(), 2u);
}

/// The largest speed in a stack that is swept once a step, from its second step on, while a ball falls beside it:
/// when the ball lands all constraints are written anew.
double unrest_of_a_stack_beside_a_ball(bool warm) {
  Simulation<PlaneBody> simulation{stack(3), {GaussSeidel{100}}};
  const int ball_beside = simulation.scene.add_body({5, 1}, ball<M>(1, 0.5));
  simulation.scene.set_shape(ball_beside, Ball<M>{0.5});
  run(simulation, 0.1, h);
  simulation.method.solver = GaussSeidel{1, warm};
  const auto layout = simulation.work.system.layout;
  double largest = 0;
  run(simulation, 1, h, [&] {
    for (int i = 1; i <= 3; ++i)
      largest = std::max(largest, simulation.scene.bodies().velocity[i].cwiseAbs().maxCoeff());
  });
  EXPECT_NE(simulation.work.system.layout, layout) << "the ball has landed";
  return largest;
}

TEST(Touching, HandsImpulsesOnWhereContactsComeAndGoElsewhere) {
  EXPECT_LT(unrest_of_a_stack_beside_a_ball(true), 1e-9);
  EXPECT_GT(unrest_of_a_stack_beside_a_ball(false), 0.01);
}

/// A heavy beam that slides over two blocks, so that corners of the one take turns with corners of the others: the
/// largest share of its weight that one sweep a step fails to carry.
double weight_missed(bool warm) {
  Scene<PlaneBody> scene;
  add_ground(scene, {0});
  for (const double x : {-1.0, 1.0}) add_unit_box(scene, x, 0.5, 1, {0});
  Pose<M> lying;
  lying.position = {-0.5, 1.25};
  const int beam = add_box(scene, lying, 1, {4, 0.5}, {0});
  Simulation<PlaneBody> simulation{scene, {GaussSeidel{200}}};
  run(simulation, 0.1, h);
  simulation.scene.state().velocity[beam].x() = 1;
  simulation.method.solver = GaussSeidel{1, warm};
  double missed = 0;
  run(simulation, 1.3, h, [&] {
    double carried = 0;
    for (const Touch<M>& touch : simulation.touches())
      if (touch.body2 == beam) carried += touch.impulse.y() / h;
    missed = std::max(missed, std::abs(carried / g - 1));
  });
  return missed;
}

TEST(Touching, HandsImpulsesOnWhereABeamSlidesAcrossItsSupports) {
  const double warm = weight_missed(true), cold = weight_missed(false);
  EXPECT_LT(warm, 0.1);
  EXPECT_GT(cold, 3 * warm) << warm;
}

TEST(Touching, ForgetsTheImpulseOfWhatHasParted) {
  Simulation<M> simulation{bouncing_ball<M>(0, 0), {GaussSeidel{1}}};
  run(simulation, 0.5, h);
  EXPECT_NEAR(force(simulation.work, 0), g, 1e-9);
  simulation.scene.state().velocity[1].y() = 3;
  run(simulation, 0.2, h);
  EXPECT_EQ(simulation.work.contacts.constraints().count(), 0);
  const double before = simulation.scene.bodies().velocity[1].y();
  simulation.step(h);
  EXPECT_NEAR(simulation.scene.bodies().velocity[1].y(), before - g * h, 1e-14);
}

TEST(Touching, TakesACopyOfTheSimulationAsAWayBack) {
  Simulation<PlaneBody> simulation{pyramid(4), {ByGraph{}}};
  run(simulation, 0.3, h);
  Simulation<PlaneBody> copy = simulation;
  run(simulation, 0.3, h);
  run(copy, 0.3, h);
  for (int i = 0; i < copy.scene.bodies().size(); ++i)
    EXPECT_EQ(copy.scene.bodies().velocity[i], simulation.scene.bodies().velocity[i]) << i;
}

}  // namespace touching_test
