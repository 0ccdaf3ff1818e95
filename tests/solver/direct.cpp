#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lessons/scenes/branches.hpp"
#include "lessons/scenes/chain.hpp"
#include "solver/constraints/spring.hpp"
#include "solver/direct/equations.hpp"
#include "tests/solver/solving.hpp"

// The structured direct solve is held against the dense one on every shape of graph that could break it.
namespace direct_test {

using namespace byhand;

Graph sheet(int n) {
  Graph graph{n * n, {}};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j + 1 < n; ++j) {
      graph.edges.push_back({n * i + j, n * i + j + 1});
      graph.edges.push_back({n * j + i, n * (j + 1) + i});
    }
  return graph;
}
// Of a sheet of n² points, nested dissection takes some 31 n² log₂ n numbers and 10 n³ multiplications for the
// factor of one matrix; the matrix of its 2n² rods has eight times the multiplications.
TEST(Elimination, OfASheetCostsAsTheCubeOfItsSide) {
  for (const int n : {25, 50, 100}) {
    const Elimination plan = plan_elimination(sheet(n), 3, 1LL << 40);
    EXPECT_LT(plan.multiplications, 80LL * n * n * n) << n;
    EXPECT_EQ(plan.order.size(), 2U * n * (n - 1)) << n;
    EXPECT_GE(plan.planned, std::ssize(plan.targets)) << n;
  }
}
// Each of n blocks of s rows is inverted and, but for the last, goes once into L and once into its neighbour.
TEST(Elimination, OfAChainIsAFactorOfOneBand) {
  for (const int n : {1, 2, 50})
    for (const int s : {1, 2, 3, 6}) {
      Graph graph{n, {{Edge::no_body, 0, s}}};
      for (int i = 1; i < n; ++i) graph.edges.push_back({i - 1, i, s});
      const Elimination plan = plan_elimination(graph, 6, 1LL << 40);
      const int again = n * s * s + 2 * (n - 1) * s * s;
      EXPECT_EQ(plan.multiplications_again, again);
      EXPECT_EQ(plan.multiplications, n * s * s * s + 2 * (n - 1) * s * s * s + again);
      EXPECT_EQ(plan.values, n * s * s + (n - 1) * s * s);
      EXPECT_TRUE(plan.fill_in.empty());
      EXPECT_EQ(plan.edge_size, s);
    }
}
TEST(Elimination, GivesUpBeforeItCountsTooMuch) {
  Random random;
  Graph graph{10000, {}};
  for (int i = 0; i < 30000; ++i) {
    const int body = random.index(10000);
    graph.edges.push_back({body, (body + 1 + random.index(9999)) % 10000});
  }
  EXPECT_GT(plan_elimination(graph, 3, 10000000).multiplications, 10000000);
  Elimination plan;
  EXPECT_THAT([&] { elimination_order(graph, 3, plan); },
              testing::ThrowsMessage<std::invalid_argument>(
                  testing::HasSubstr("a direct solve of these 30000 constraints would take more than")));
}

template <class M>
void expect_structured_is_dense(const Scene<M>& scene, double regularisation = 0) {
  const auto structured = solved(scene, Direct{Factorisation::structured, regularisation});
  const auto dense = solved(scene, Direct{Factorisation::dense, regularisation});
  EXPECT_LE(difference(structured.velocity, dense.velocity), 1e-9 * (1 + largest(dense.velocity)));
  EXPECT_LE(difference(structured.lambda, dense.lambda), 1e-8 * (1 + largest(dense.lambda)));
  if (regularisation == 0) {
    EXPECT_LE(structured.residual, 1e-10 * (1 + largest(dense.velocity)));
    EXPECT_LE(dense.residual, 1e-10 * (1 + largest(dense.velocity)));
  }
}

TEST(StructuredDirect, IsTheDenseSolveOnChains) {
  in_all_models([]<class M>(Random& random) {
    for (const int links : {1, 2, 3, 10, 57}) {
      SCOPED_TRACE(links);
      expect_structured_is_dense(with_random_velocities(rod_chain<M>({.links = links, .angle = 1}), random));
    }
  });
  in_both_bodies([]<class M>(Random& random) {
    for (const int links : {1, 2, 3, 10, 57}) {
      SCOPED_TRACE(links);
      expect_structured_is_dense(
          with_random_velocities(pinned_chain<M>({.links = links, .end_mass = 30, .angle = 1}), random));
    }
  });
}

TEST_IN_BOTH_BODIES(StructuredDirect, IsTheDenseSolveOnTrees) {
  for (const int levels : {1, 2, 5})
    expect_structured_is_dense(with_random_velocities(pinned_tree<M>(levels), random));
}

TEST(StructuredDirect, IsTheDenseSolveOnStars) {
  in_both_bodies([]<class M>(Random& random) {
    for (const int arms : {1, 2, 3, 4, 5, 30})
      expect_structured_is_dense(with_random_velocities(pinned_star<M>(arms), random));
  });
  Random random;
  expect_structured_is_dense(with_random_velocities(pinned_star<PlaneBody>(200), random));
}

TEST_IN_ALL_MODELS(StructuredDirect, IsTheDenseSolveOnRings) {
  for (const int links : {4, 5, 12}) expect_structured_is_dense(ring<M>(random, links));
}

TEST_IN_ALL_MODELS(StructuredDirect, IsTheDenseSolveOnGridsOfHubs) {
  for (const int n : {2, 3, 4, 6}) expect_structured_is_dense(grid<M>(random, n));
}

TEST_IN_ALL_MODELS(StructuredDirect, IsTheDenseSolveWhereALineOfRodsJoinsTwoHubs) {
  Scene<M> scene;
  const int hubs[] = {0, 2};
  for (int i = 0; i < 3; ++i)
    scene.add_body(Linear<M>(2.0 * i * Linear<M>::Unit(0)), random.mass<M>(), random.velocity<M>());
  for (const int hub : hubs) {
    scene.add(Distance<M>{{hub, 1}, 2});
    for (int i = 0; i < 4; ++i)
      scene.add(Distance<M>{{hub, scene.add_body(random.pose<M>(), random.mass<M>(), random.velocity<M>())}});
  }
  expect_structured_is_dense(scene);
}

TEST_IN_BOTH_BODIES(StructuredDirect, IsTheDenseSolveWhereALinkJoinsTwoHubs) {
  Scene<M> scene;
  const auto body = [&] { return scene.add_body(random.pose<M>(), random.mass<M>(), random.velocity<M>()); };
  const auto join = [&](int a, int b) {
    scene.add(pin<M>(scene.bodies(), a, b, Linear<M>(random.vector<M::linear>(2))));
  };
  const int link = body();
  for (const int hub : {body(), body()}) {
    join(hub, link);
    for (int i = 0; i < 4; ++i) join(hub, body());
  }
  expect_structured_is_dense(scene);
}

TEST(StructuredDirect, IsTheDenseSolveOnMixedKinds) {
  in_all_models([]<class M>(Random& random) { expect_structured_is_dense(mixed_chain<M>(random, 20)); }, 5);
}

TEST_IN_ALL_MODELS(StructuredDirect, IsTheDenseSolveOnRandomGraphs, 50) {
  const int bodies = 3 + random.index(12);
  expect_structured_is_dense(random_graph<M>(random, bodies, 1 + random.index(3 * bodies)));
  expect_structured_is_dense(random_graph<M>(random, bodies, 1 + random.index(3 * bodies)), 1e-3);
}

TEST(Direct, DividesByARegularisedDiagonal) {
  auto scene = rod_chain<PlaneParticle>({.links = 1});
  const double hard = solved(scene, Direct{}).lambda[0];
  for (const auto factorisation : {Factorisation::structured, Factorisation::dense})
    EXPECT_NEAR(solved(scene, Direct{factorisation, 0.25}).lambda[0], hard / 1.25, 1e-14);
}

TEST(Direct, ForgetsWhatLambdaWasBefore) {
  auto scene = rod_chain<PlaneParticle>({.links = 5, .angle = 1});
  Work<PlaneParticle> used;
  for (int i = 0; i < 5; ++i) advance(scene, {Direct{}}, time_step, used);
  auto fresh = scene;
  Work<PlaneParticle> none;
  advance(scene, {Direct{}}, time_step, used);
  advance(fresh, {Direct{}}, time_step, none);
  EXPECT_EQ(used.system.lambda, none.system.lambda);
}

TEST(Direct, RunsASceneWithoutConstraints) {
  Scene<PlaneParticle> scene;
  scene.add_body({0, 0}, with_mass<PlaneParticle>(1));
  for (const auto factorisation : {Factorisation::structured, Factorisation::dense}) {
    Work<PlaneParticle> work;
    EXPECT_NO_THROW(advance(scene, {Direct{factorisation}}, time_step, work));
  }
  EXPECT_NEAR(scene.bodies().velocity[0].y(), -2 * 9.81 * time_step, 1e-15);
}

/// A hanging bob whose one rod is there twice, with two lengths.
template <class M>
Scene<M> doubled_rod(double length1, double length2) {
  Scene<M> scene;
  scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>());
  InverseMass<M> bob;
  if constexpr (M::angular == 0)
    bob = with_mass<M>(3);
  else
    bob = ball<M>(3, 0.1);
  scene.add_body(Linear<M>(-length1 * Linear<M>::Unit(1)), bob);
  scene.add(NormalisedDistance<M>{{0, 1}, length1});
  scene.add(NormalisedDistance<M>{{0, 1}, length2});
  return scene;
}

TEST_IN_ALL_MODELS(SingularSystem, IsRefusedInASentenceAndLeavesTheVelocities) {
  for (const auto factorisation : {Factorisation::structured, Factorisation::dense}) {
    auto scene = doubled_rod<M>(1, 1);
    scene.gravity.setZero();
    scene.state().velocity[1][0] = 1;
    Work<M> work;
    EXPECT_THAT([&] { advance(scene, {Direct{factorisation}}, time_step, work); },
                testing::ThrowsMessage<SingularSystem>(testing::HasSubstr("regularisation above 0")));
    EXPECT_EQ(scene.bodies().velocity[1], Velocity<M>(Velocity<M>::Unit(0)));
  }
}

TEST_IN_ALL_MODELS(SingularSystem, WithRegularisationHasTheRightSumOfImpulses) {
  for (const auto factorisation : {Factorisation::structured, Factorisation::dense}) {
    const auto answer = solved(doubled_rod<M>(1, 1), Direct{factorisation, 1e-9});
    EXPECT_NEAR(answer.lambda[0] + answer.lambda[1], -3 * 9.81 * time_step, 1e-8);
    EXPECT_NEAR(answer.lambda[0], answer.lambda[1], 1e-6) << "two equal rods share";
  }
}

TEST(SingularSystem, IsFoundWhateverTheUnitOfMass) {
  for (const double mass : {1e-9, 1.0, 1e9}) {
    Scene<PlaneBody> scene;
    const int ground = scene.add_body({0, 0}, fixed<PlaneBody>());
    const int body = scene.add_body({0.3, 0.2}, with_mass<PlaneBody>(mass, Angular<PlaneBody>(mass)));
    for (int i = 0; i < 2; ++i) scene.add(pin<PlaneBody>(scene.bodies(), ground, body, {0, 0.7}));
    EXPECT_THROW(solved(scene, Direct{}), SingularSystem) << mass;
    scene.remove(1);
    EXPECT_NO_THROW(solved(scene, Direct{})) << mass;
  }
}

TEST_IN_ALL_MODELS(ByGraph, SolvesALoopWhateverItsSmallestPivot) {
  const Scene<M> loop = ring<M>(random, 5);
  const auto softened = solved(loop, Direct{.regularisation = 1e-7}),
             choosy = solved(loop, ByGraph{.loopless = {.smallest_pivot = 1}});
  EXPECT_LE(difference(choosy.velocity, softened.velocity), 1e-12);
  EXPECT_TRUE(choosy.converged);
}

/// The velocity after a step of a particle on rods that are too short from two fixed points, which comes first or
/// last, with a chain of so many links elsewhere.
template <class M>
Velocity<M> on_short_rods(bool first, int links = 0) {
  Simulation<M> simulation;
  Scene<M>& scene = simulation.scene;
  const auto add = [&] { return scene.add_body(Linear<M>(0.02 * Linear<M>::Unit(1)), with_mass<M>(1)); };
  int particle = first ? add() : -1;
  if (links > 0) scene = rod_chain<M>({.links = links, .angle = 1});
  scene.gravity.setZero();
  const int end1 = scene.add_body(Linear<M>(-Linear<M>::Unit(0)), fixed<M>()),
            end2 = scene.add_body(Linear<M>(Linear<M>::Unit(0)), fixed<M>());
  if (!first) particle = add();
  for (const int end : {end1, end2}) scene.add(NormalisedDistance<M>{{end, particle}, 0.9});
  simulation.step(time_step);
  EXPECT_FALSE(simulation.work.solution.converged);
  return scene.bodies().velocity[particle];
}

// Together they ask for 2 β/h · 0.1 m = 2.4 m/s; an exact answer would be 60 m/s.
TEST(RowsThatCannotBeMet, DoTheSameWhateverTheOrderOfBodiesAndWhateverHangsElsewhere) {
  in_models<PlaneParticle, SpaceParticle>([]<class M>(Random&) {
    const Velocity<M> alone = on_short_rods<M>(false);
    EXPECT_LT(alone.norm(), 2.5 * 2.4);
    EXPECT_LE((on_short_rods<M>(true) - alone).norm(), 1e-9);
    for (const int links : {1, 3, 30, 300})
      EXPECT_LE((on_short_rods<M>(false, links) - alone).norm(), 1e-9) << links;
  });
}

TEST_IN_ALL_MODELS(Direct, LetsASpringBetweenFixedBodiesPullByHookesLaw) {
  Scene<M> scene;
  const int first = scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>());
  const int second = scene.add_body(Linear<M>(1.5 * Linear<M>::Unit(0)), fixed<M>());
  const double stiffness = 1e6, stretch = 0.5;
  const auto spring = scene.add(Spring<M>{{first, second}, 1, {stiffness}});
  Simulation simulation{scene, {Direct{}}};
  simulation.step(0.1);
  EXPECT_NEAR(simulation.reaction(spring).force[0], -stiffness * stretch, 1e-6);
}

TEST(SingularSystem, OfALoopWithoutFreedomIsFound) {
  // A body pinned three times to the ground: six rows for three freedoms.
  Scene<PlaneBody> scene;
  const int ground = scene.add_body({0, 0}, fixed<PlaneBody>());
  const int body = scene.add_body({0.3, 0.2}, ball<PlaneBody>(1, 1));
  for (const double x : {-1.0, 0.5, 2.0}) scene.add(pin<PlaneBody>(scene.bodies(), ground, body, {x, x * x}));
  EXPECT_THROW(solved(scene, Direct{}), SingularSystem);
  EXPECT_THROW(solved(scene, Direct{Factorisation::dense}), SingularSystem);
  const auto soft = solved(scene, Direct{Factorisation::structured, 1e-9});
  EXPECT_LE(largest(soft.velocity), 1e-7);
}

/// |λ| of both rods of 1.0 m and 1.1 m after so many steps.
template <class M>
double conflict(const RowSolver& solver, double softness, int steps) {
  auto scene = doubled_rod<M>(1.0, 1.1);
  scene.state().pose[1].position *= 1.05;
  scene.template change_all<NormalisedDistance>([&](auto& rod) { rod.softness = softness; });
  Work<M> work;
  for (int i = 0; i < steps; ++i) advance(scene, {solver}, time_step, work);
  EXPECT_LE(position_error(scene).max, 0.11) << "the picture looks calm";
  return std::max(std::abs(work.system.lambda[0]), std::abs(work.system.lambda[1]));
}

TEST_IN_ALL_MODELS(ConflictingRods, GrowWithoutBoundUnderWarmStart) {
  const double at_300 = conflict<M>(GaussSeidel{}, 0, 300), at_600 = conflict<M>(GaussSeidel{}, 0, 600),
               at_900 = conflict<M>(GaussSeidel{}, 0, 900);
  EXPECT_GT(at_600, 1.5 * at_300);
  EXPECT_NEAR(at_900 - at_600, at_600 - at_300, 1e-3 * at_300) << "linearly";
}

TEST_IN_ALL_MODELS(ConflictingRods, AreBoundedBySoftnessAndByARegularisedDirectSolve) {
  const double softness = 1e-2 / 3;  // a hundredth of JM⁻¹Jᵀ
  EXPECT_NEAR(conflict<M>(GaussSeidel{}, softness, 900), conflict<M>(GaussSeidel{}, softness, 1800), 0.1);
  const Direct direct{Factorisation::structured, 1e-2};
  EXPECT_NEAR(conflict<M>(direct, 0, 300), conflict<M>(direct, 0, 600), 1e-6);
  EXPECT_LE(conflict<M>(direct, 0, 900), 1.1 * 0.2 * 0.05 / time_step / softness)
      << "half of the conflict, β/h · 0.05 m, over the softness";
}

TEST_IN_ALL_MODELS(RowsWithoutEffect, GetNoImpulseInAnySolver) {
  Scene<M> scene;
  const int post1 = scene.add_body(random.pose<M>(), fixed<M>());
  const int post2 = scene.add_body(random.pose<M>(), fixed<M>());
  const int bob = scene.add_body(random.pose<M>(), random.mass<M>(), random.velocity<M>());
  scene.add(Distance<M>{{post1, post2}, 1});
  scene.add(Distance<M>{{post1, bob}, 1});
  scene.add(Pin<M>{{post2, post1}});
  for (const RowSolver& solver :
       {RowSolver(GaussSeidel{}), RowSolver(GaussSeidel{5, true, SweepOrder::coloured}),
        RowSolver(GaussSeidel{5, true, SweepOrder::natural, BlockSolve::row_by_row}), RowSolver(Jacobi{}),
        RowSolver(Direct{}), RowSolver(Direct{Factorisation::dense})}) {
    const auto answer = solved(scene, any(solver));
    EXPECT_EQ(answer.lambda[0], 0);
    EXPECT_NE(answer.lambda[1], 0);
    for (int k = 0; k < M::linear; ++k) EXPECT_EQ(answer.lambda[2 + k], 0);
    EXPECT_LT(largest(answer.velocity), 1e3);
  }
  // A rod whose ends have come together since it was added: J is zero.
  Scene<M> vanishing;
  vanishing.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>());
  vanishing.add_body(Linear<M>(Linear<M>::Unit(0)), random.mass<M>());
  vanishing.add(Distance<M>{{0, 1}, 1});
  vanishing.add(NormalisedDistance<M>{{0, 1}, 1});
  vanishing.state().pose[1].position.setZero();
  for (const RowSolver& solver : {RowSolver(GaussSeidel{}), RowSolver(Jacobi{}), RowSolver(Direct{}),
                                  RowSolver(Direct{Factorisation::dense})})
    EXPECT_EQ(largest(solved(vanishing, any(solver)).lambda), 0);
}

}  // namespace direct_test
