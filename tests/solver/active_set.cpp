#include <gtest/gtest.h>

#include "lessons/scenes/boxes.hpp"
#include "solver/direct/graph.hpp"
#include "solver/measure.hpp"
#include "tests/solver/random.hpp"

namespace active_set_test {

using namespace byhand;
using M = PlaneBody;

/// A column of boxes of random widths and masses, a little askew, that falls, leans or slides.
Scene<PlaneBody> random_column(Random& random, int count) {
  Scene<PlaneBody> scene;
  add_ground(scene, {random.uniform(0, 0.5)});
  double height = 0;
  for (int i = 0; i < count; ++i) {
    const Linear<M> sides(random.uniform(0.5, 2), random.uniform(0.3, 1));
    Pose<M> pose;
    pose.position = {random.uniform(-0.1, 0.1), height + 0.5 * sides.y()};
    height += sides.y();
    const int box = add_box(scene, pose, random.uniform(0.5, 5), sides, {random.uniform(0, 0.5)});
    scene.state().velocity[box] = 0.3 * random.velocity<M>();
  }
  return scene;
}

double difference_of(const Scene<PlaneBody>& a, const Scene<PlaneBody>& b) {
  double largest = 0;
  for (int i = 0; i < a.bodies().size(); ++i)
    largest = std::max(largest, (a.bodies().velocity[i] - b.bodies().velocity[i]).cwiseAbs().maxCoeff());
  return largest;
}

TEST(ActiveSet, FindsWhatSweepsConvergeTo) {
  Random random;
  for (int i = 0; i < 60; ++i) {
    Scene<PlaneBody> scene = random_column(random, 1 + random.index(6));
    Scene<PlaneBody> swept = scene;
    Direct direct;
    direct.tolerance = 1e-12;
    Work<M> work, reference;
    advance(scene, VelocityStepping{direct}, 1.0 / 60, work);
    advance(swept, {GaussSeidel{.sweeps = 200000, .tolerance = 1e-12}}, 1.0 / 60, reference);
    // A sweep that changes 1e-12 may be a hundred thousand sweeps from the end of a slow mode.
    ASSERT_LE(difference_of(scene, swept), 1e-7) << "draw " << i;
    ASSERT_LE(residual(work.system, scene.bodies().velocity), 1e-9);
  }
}

TEST(ActiveSet, IsTheSameByTheStructuredAndTheDenseFactorisation) {
  Random random;
  for (int i = 0; i < 60; ++i) {
    Simulation<PlaneBody> structured{random_column(random, 1 + random.index(8)),
                                     VelocityStepping{Direct{.rounds = 100, .tolerance = 1e-12}}};
    for (int step = 0; step < 5; ++step) {
      Simulation<PlaneBody> dense = structured;
      dense.method.solver = Direct{.factorisation = Factorisation::dense, .rounds = 100, .tolerance = 1e-12};
      structured.step(1.0 / 60);
      dense.step(1.0 / 60);
      ASSERT_LE(difference_of(structured.scene, dense.scene), 1e-7) << "draw " << i << ", step " << step;
    }
  }
}

TEST(ActiveSet, KeepsEveryBoundExactly) {
  Random random;
  for (int i = 0; i < 30; ++i) {
    Scene<PlaneBody> scene = random_column(random, 6);
    Work<M> work;
    for (int step = 0; step < 30; ++step) {
      advance(scene, {Direct{}}, 1.0 / 60, work);
      for (std::size_t k = 0; k < work.system.lambda.size(); k += 3) {
        const double* lambda = &work.system.lambda[k];
        ASSERT_GE(lambda[0], 0);
        ASSERT_GE(lambda[1], 0);
        ASSERT_LE(std::abs(lambda[2]), work.system.upper[k] * (lambda[0] + lambda[1]) * (1 + 1e-12));
      }
    }
  }
}

TEST(ActiveSet, ChangesNothingWhereNothingTouches) {
  Scene<PlaneBody> scene;
  add_ground(scene);
  Pose<M> pose;
  pose.position = {0, 10};
  add_box(scene, pose, 1, {1, 1});
  Work<M> work;
  advance(scene, {Direct{}}, 1.0 / 60, work);
  EXPECT_EQ(scene.bodies().velocity[1], Velocity<M>(0, -9.81 / 60, 0));
}

TEST(ByGraph, SolvesAColumnDirectlyAndAWallBySweeps) {
  Scene<PlaneBody> column = stack(5), wall = pyramid(4);
  Work<M> of_column, of_wall;
  advance(column, {ByGraph{}}, 1.0 / 60, of_column);
  advance(wall, {ByGraph{}}, 1.0 / 60, of_wall);
  EXPECT_EQ(of_column.layout, Layout::elimination);
  EXPECT_EQ(of_wall.layout, Layout::coloured);

  Scene<PlaneBody> same = stack(5);
  Work<M> work;
  advance(same, {Direct{}}, 1.0 / 60, work);
  EXPECT_EQ(difference_of(column, same), 0);
}

TEST(HasNoLoops, CountsAllThatDoesNotMoveAsOneBody) {
  constexpr int none = Edge::no_body;
  EXPECT_TRUE(has_no_loops({3, {}}));
  EXPECT_TRUE(has_no_loops({3, {{none, 0}, {0, 1}, {1, 2}}}));
  EXPECT_FALSE(has_no_loops({3, {{none, 0}, {0, 1}, {1, 2}, {2, none}}})) << "held at both ends";
  EXPECT_FALSE(has_no_loops({3, {{0, 1}, {1, 2}, {2, 0}}}));
  EXPECT_FALSE(has_no_loops({2, {{0, 1}, {0, 1}}})) << "joined twice";
  EXPECT_TRUE(has_no_loops({1, {{none, none}, {none, 0}}})) << "between two that do not move nothing is passed on";
}

TEST(Tolerance, StopsSweepsThatHaveNothingMoreToDo) {
  Scene<PlaneBody> fixed_number = stack(3), until_done = fixed_number;
  Work<M> work1, work2;
  for (int i = 0; i < 120; ++i) {
    advance(fixed_number, {GaussSeidel{.sweeps = 200}}, 1.0 / 60, work1);
    advance(until_done, {GaussSeidel{.sweeps = 200, .tolerance = 1e-10}}, 1.0 / 60, work2);
  }
  EXPECT_LE(difference_of(fixed_number, until_done), 1e-7);
  EXPECT_LT(work2.row_solves, work1.row_solves / 4);
}

}  // namespace active_set_test
