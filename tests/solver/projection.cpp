#include "solver/cures/projection.hpp"

#include <gmock/gmock.h>

#include "lessons/methods/xpbd.hpp"
#include "lessons/scenes/boxes.hpp"
#include "solver/constraints/spring.hpp"
#include "tests/solver/random.hpp"
#include "tests/solver/swing.hpp"

namespace projection_test {

using namespace byhand;
constexpr double h = 1.0 / 60;

TEST(LawA1, WithPosesProjectedThePendulumErrsAsTheAtlasSays) {
  const SwingErrors row = swing<NormalisedDistance>(VelocityStepping{GaussSeidel{1}, Projection{}}, h);
  expect_two_digits(row.period_error, -3.3e-2, "period");
  expect_two_digits(row.angle_error, 7.6e-2, "angle after 1 s");
  expect_two_digits(row.energy_gain, -0.53, "energy");
  EXPECT_LT(row.stretch, 1e-14);
}

TEST(Stable, IsNotAccurate) {
  const SwingErrors positions = swing<NormalisedDistance>(Xpbd{1, 1}, h);
  const SwingErrors velocities = swing<NormalisedDistance>(VelocityStepping{GaussSeidel{1}, Baumgarte{1}}, h);
  EXPECT_LT(positions.stretch, 1e-12 * velocities.stretch) << "it holds the rod as nothing else does";
  EXPECT_LT(positions.energy_gain, -0.89) << "and yet nine tenths of the energy are gone";
  EXPECT_GT(velocities.energy_gain, -0.02);
  EXPECT_GT(std::abs(positions.angle_error), 10 * std::abs(velocities.angle_error));
}

/// Five bodies in a row, with pins that do not fit.
template <class M>
Scene<M> torn_chain(Random& random) {
  Scene<M> scene;
  for (int i = 0; i < 5; ++i) scene.add_body(random.pose<M>(), random.mass<M>(), random.velocity<M>());
  for (int i = 0; i < 4; ++i) scene.add(Pin<M>{{i, i + 1, random.arms<M>()}});
  return scene;
}

template <class M>
Linear<M> centre_of_mass(const Bodies<M>& bodies) {
  Linear<M> sum = Linear<M>::Zero();
  double mass = 0;
  for (int i = 0; i < bodies.size(); ++i) {
    sum += bodies.pose[i].position / bodies.inverse_mass[i].linear;
    mass += 1 / bodies.inverse_mass[i].linear;
  }
  return sum / mass;
}

TEST_IN_BOTH_BODIES(Projection, ClosesPinsAndMovesNeitherVelocitiesNorTheCentreOfMass) {
  auto scene = torn_chain<M>(random);
  const auto before = scene;
  EXPECT_EQ(project(Projection{.sweeps = 400}, scene), 400 * 4 * M::linear);
  EXPECT_GT(position_error(before).max, 0.1);
  EXPECT_LT(position_error(scene).max, 1e-9);
  EXPECT_LT((centre_of_mass(scene.bodies()) - centre_of_mass(before.bodies())).norm(), 1e-13);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(scene.bodies().velocity[i], before.bodies().velocity[i]);
}

TEST_IN_ALL_MODELS(Projection, RemovesItsShareOfARodsError) {
  auto scene = pendulum<M, NormalisedDistance>(0.5, 2, 3);
  scene.state().pose[1].position *= 1.1;
  for (const double left : {0.15, 0.1125}) {
    project(Projection{.sweeps = 1, .share = 0.25}, scene);
    EXPECT_NEAR(position_error(scene).max, left, 1e-14);
  }
}

TEST(Projection, PushesBoxesApartAsFarAsTheSlopAndNeverPullsThem) {
  for (const double overlap : {0.05, -0.01}) {
    auto scene = stack(1);
    scene.state().pose[1].position.y() -= overlap;
    ContactManager<PlaneBody> touching;
    touching.find(scene);
    ASSERT_EQ(touching.constraints().count(), 1);
    project(Projection{.sweeps = 3, .slop = 0.002}, scene, touching);
    EXPECT_NEAR(scene.bodies().pose[1].position.y(), overlap > 0 ? 0.498 : 0.51, 1e-15);
    EXPECT_EQ(scene.bodies().pose[1].position.x(), 0);
  }
}

TEST(Projection, LeavesSpringsAlone) {
  using M = PlaneParticle;
  Scene<M> scene;
  scene.add_body(Linear<M>(0, 0), fixed<M>());
  scene.add_body(Linear<M>(3, 0), with_mass<M>(1));
  scene.add(Spring<M>{{0, 1}, 1, {10, 1}});
  EXPECT_EQ(project(Projection{}, scene), 0);
  EXPECT_EQ(scene.bodies().pose[1].position.x(), 3);
}

TEST(Projection, RefusesChoicesOutsideTheirRange) {
  const auto refuses = [](const Projection& cure, const char* sentence) {
    auto scene = pendulum<PlaneParticle, NormalisedDistance>(1, 1, 1);
    Work<PlaneParticle> work;
    EXPECT_THAT(
        [&] {
          advance(scene, VelocityStepping{GaussSeidel{1}, cure}, h, work);
        },
        testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr(sentence)));
  };
  refuses({.sweeps = 0}, "number of projection sweeps is 0, but it must be at least 1");
  refuses({.share = 0}, "share of the projection is 0, but it must be above 0 and at most 1");
  refuses({.share = 1.5}, "share of the projection is 1.5, but it must be above 0 and at most 1");
  refuses({.slop = -1}, "slop is -1, but it must be between 0 and");
}

}  // namespace projection_test
