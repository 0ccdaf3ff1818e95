#include <gtest/gtest.h>

#include "lessons/scenes/boxes.hpp"
#include "solver/step.hpp"

// Sweeps solve two manifolds at once where they share no moving body. Nobody may notice.
namespace byhand {
namespace manifold_pairs_test {

using M = PlaneBody;

/// A box that falls on the ground askew, slides and leans; which one, by its index.
void add_falling(Scene<M>& scene, int i, double x) {
  Pose<M> pose;
  pose.position = {x, 0.5 + 0.001 * i};
  pose.rotation = plane_rotation(0.002 * (i % 3 - 1));
  const int body = add_box(scene, pose, 1 + 0.7 * i, Linear<M>(1, 1), {.friction = 0.2 + 0.1 * i});
  scene.set_velocity(body, {0.3 * (i % 4), -0.5 - 0.1 * i, 0.4 * (i % 2)});
}

Simulation<M> fallen(const std::vector<int>& which, const RowSolver& solver) {
  Scene<M> scene;
  add_ground(scene);
  for (const int i : which) add_falling(scene, i, 3.0 * i);
  Simulation<M> simulation{scene, VelocityStepping{solver, Baumgarte{}}};
  for (int i = 0; i < 20; ++i) simulation.step(1.0 / 60);
  return simulation;
}

class ManifoldPairs : public testing::TestWithParam<RowSolver> {};

TEST_P(ManifoldPairs, ComeToTheBitsOfEachByItself) {
  const Simulation<M> all = fallen({0, 1, 2, 3, 4, 5, 6}, GetParam());
  for (int i = 0; i < 7; ++i) {
    const Simulation<M> alone = fallen({i}, GetParam());
    EXPECT_EQ(all.scene.bodies().velocity[i + 1], alone.scene.bodies().velocity[1]) << "box " << i;
    EXPECT_EQ(all.scene.bodies().pose[i + 1].position.y(), alone.scene.bodies().pose[1].position.y())
        << "box " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(
    , ManifoldPairs,
    testing::Values(RowSolver(GaussSeidel{.sweeps = 3}),
                    RowSolver(GaussSeidel{.sweeps = 3, .order = SweepOrder::coloured}),
                    RowSolver(GaussSeidel{.sweeps = 2, .order = SweepOrder::symmetric}),
                    RowSolver(GaussSeidel{.sweeps = 3, .block_solve = BlockSolve::row_by_row}),
                    RowSolver(GaussSeidel{.sweeps = 3, .relaxation = 1.3}), RowSolver(Jacobi{.sweeps = 5})));

TEST(PairsOfManifolds, AreNotMadeOfManifoldsThatShareABox) {
  // The sweep from the ground upwards carries the weight of the stack by one contact a sweep: each has to see what
  // the one before it did.
  Scene<M> scene = stack(6);
  Simulation<M> swept{scene, VelocityStepping{GaussSeidel{.sweeps = 1, .warm_start = false}, NoDriftCure{}}};
  swept.step(1.0 / 60);
  const auto& V = swept.scene.bodies().velocity;
  std::vector<double> by_hand(7, -9.81 / 60);
  by_hand[0] = by_hand[1] = 0;
  for (int i = 2; i <= 6; ++i) {
    const double mean = 0.5 * (by_hand[i - 1] + by_hand[i]);
    by_hand[i - 1] = by_hand[i] = mean;
  }
  for (int i = 1; i <= 6; ++i) EXPECT_NEAR(V[i].y(), by_hand[i], 1e-12) << "box " << i;
}

}  // namespace manifold_pairs_test
}  // namespace byhand
