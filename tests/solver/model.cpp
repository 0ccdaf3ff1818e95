#include "solver/model.hpp"

#include <gtest/gtest.h>

#include "lessons/scenes/chain.hpp"
#include "lessons/scenes/pendulum.hpp"
#include "solver/constraints/contact.hpp"
#include "solver/constraints/distance.hpp"
#include "solver/constraints/friction.hpp"
#include "solver/constraints/pin.hpp"
#include "solver/step.hpp"
#include "tests/solver/random.hpp"

namespace model_test {

using namespace byhand;

TEST(Model, CarriesNoNumberThatItDoesNotMoveWith) {
  EXPECT_EQ(sizeof(Pose<PlaneParticle>), 16);
  EXPECT_EQ(sizeof(Pose<PlaneBody>), 32);
  EXPECT_EQ(sizeof(Pose<SpaceParticle>), 24);
  EXPECT_EQ(sizeof(Pose<SpaceBody>), 56);
  EXPECT_EQ(sizeof(InverseMass<PlaneParticle>), 8);
  EXPECT_EQ(sizeof(InverseMass<SpaceParticle>), 8);
  EXPECT_EQ(sizeof(InverseMass<PlaneBody>), 16);
  EXPECT_EQ(sizeof(InverseMass<SpaceBody>), 32);
  in_all_models([]<class M>(Random&) {
    EXPECT_EQ(sizeof(Velocity<M>), M::dof * sizeof(double));
    EXPECT_EQ(sizeof(Jacobian<M, 1>), 2 * M::dof * sizeof(double));
  });
}

TEST(Model, GivesAParticleNoArms) {
  const std::size_t bodies = 2 * sizeof(int), length_and_softness = 2 * sizeof(double);
  EXPECT_EQ(sizeof(Anchors<PlaneParticle>), bodies);
  EXPECT_EQ(sizeof(Anchors<SpaceParticle>), bodies);
  EXPECT_EQ(sizeof(Distance<PlaneParticle>), bodies + length_and_softness);
  EXPECT_EQ(sizeof(Distance<SpaceParticle>), bodies + length_and_softness);
  EXPECT_EQ(sizeof(Distance<SpaceBody>), bodies + length_and_softness + 6 * sizeof(double));
}

TEST_IN_ALL_MODELS(Scene, CarriesNoByteForKindsThatItDoesNotHave) {
  const std::size_t two_vectors = 2 * sizeof(std::vector<int>);
  EXPECT_LE(sizeof(Scene<M>), sizeof(Bodies<M>) + sizeof(Linear<M>) + sizeof(Colliders<M>) + two_vectors +
                                  2 * sizeof(int) + 2 * sizeof(std::uint64_t) + alignof(Scene<M>))
      << "bodies, gravity, shapes, stores, entries, two counters, identity and version";
  Simulation<M> simulation{rod_chain<M>({.links = 4})};
  simulation.step(1.0 / 60);
  EXPECT_TRUE(simulation.scene.template all<Pin>().empty());
  int blocks = 0;
  simulation.work.system.for_each_type([&](const auto& of_a_type) { blocks += of_a_type.capacity() > 0; });
  EXPECT_EQ(blocks, 1) << "only rods are laid out";
}

TEST(Scene, NumbersConstraintsOfAllKindsInTheOrderInWhichTheyCome) {
  Scene<PlaneBody> scene;
  for (int i = 0; i < 3; ++i) scene.add_body({1.0 * i, 0}, ball<PlaneBody>(1, 0.1));
  EXPECT_EQ(scene.add(Distance<PlaneBody>{{0, 1}}), 0);
  EXPECT_EQ(scene.add(Pin<PlaneBody>{{1, 2}}), 1);
  EXPECT_EQ(scene.add(Distance<PlaneBody>{{2, 0}}), 2);
  std::vector<int> first_bodies;
  for (const auto& entry : scene.entries()) first_bodies.push_back(entry.body1);
  EXPECT_EQ(first_bodies, (std::vector{0, 1, 2}));
  EXPECT_EQ(scene.all<Pin>().size(), 1);
  EXPECT_EQ(scene.all<Distance>().size(), 2);
}

template <class M>
double times_moved(const Pose<M>& a, const Pose<M>& b) {
  double moved = difference(a.position, b.position);
  if constexpr (M::angular == 1) moved += std::abs(a.rotation.sin - b.rotation.sin);
  if constexpr (M::angular == 3) moved += difference(a.rotation.coeffs(), b.rotation.coeffs());
  return moved;
}

TEST_IN_ALL_MODELS(FixedBody, NeverMoves) {
  for (const RowSolver& solver :
       {RowSolver(GaussSeidel{3}), RowSolver(Jacobi{3}), RowSolver(Direct{}),
        RowSolver(Direct{Factorisation::dense}), RowSolver(GaussSeidel{3, true, SweepOrder::coloured})}) {
    Simulation simulation{rod_chain<M>({.links = 4, .angle = 1}), VelocityStepping{solver}};
    const Pose<M> held = random.pose<M>();
    auto& scene = simulation.scene;
    const int post = scene.add_body(held, fixed<M>());
    scene.add(Distance<M>{{post, 4}, (scene.bodies().pose[4].position - held.position).norm()});
    const Pose<M> end = scene.bodies().pose[2];
    for (int i = 0; i < 30; ++i) simulation.step(1.0 / 60);
    EXPECT_EQ(times_moved<M>(scene.bodies().pose[post], held), 0);
    EXPECT_EQ(times_moved<M>(scene.bodies().pose[0], {}), 0);
    EXPECT_TRUE(scene.bodies().velocity[post].isZero(0));
    EXPECT_GT(times_moved<M>(scene.bodies().pose[2], end), 1e-3) << "what is not fixed moves";
  }
}

/// Where the end of a swinging chain of rods is after a second.
template <class M>
Eigen::Vector2d end_of_chain(const RowSolver& solver) {
  Simulation simulation{rod_chain<M>({.links = 3, .length = 2, .mass = 3, .end_mass = 5, .angle = 1.2}),
                        VelocityStepping{solver}};
  for (int i = 0; i < 60; ++i) simulation.step(1.0 / 60);
  return simulation.scene.bodies().pose[3].position.template head<2>();
}

TEST(FourModels, MoveAChainHeldByTheCentresAlike) {
  for (const RowSolver& solver : {RowSolver(GaussSeidel{20}), RowSolver(Jacobi{20}), RowSolver(Direct{})}) {
    const Eigen::Vector2d expected = end_of_chain<PlaneParticle>(solver);
    in_all_models([&]<class M>(Random&) { EXPECT_LE(difference(end_of_chain<M>(solver), expected), 1e-10); });
  }
}

TEST_IN_ALL_MODELS(Simulation, IsAValueSoThatACopyIsAWayBack) {
  Simulation simulation{rod_chain<M>({.links = 3, .angle = 1}), VelocityStepping{}};
  for (int i = 0; i < 10; ++i) simulation.step(1.0 / 60);
  auto before = simulation;
  for (int i = 0; i < 10; ++i) simulation.step(1.0 / 60);
  const Linear<M> end = simulation.scene.bodies().pose[3].position;
  EXPECT_NE(end, before.scene.bodies().pose[3].position);
  for (int i = 0; i < 10; ++i) before.step(1.0 / 60);
  EXPECT_EQ(end, before.scene.bodies().pose[3].position);
  EXPECT_EQ(simulation.time, before.time);
}

}  // namespace model_test
