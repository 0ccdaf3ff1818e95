#include <gtest/gtest.h>

#include "lessons/methods/row_solvers.hpp"
#include "lessons/scenes/chain.hpp"
#include "tests/solver/hash.hpp"

// What a step counts of its work, from which its price is made.
namespace counts_test {

using namespace byhand;
using M = PlaneBody;

constexpr int links = 7, rows = 2 * links, steps = 5, substeps = 3;

template <class Solver>
auto run_of(const Solver& solver, const DriftCure& cure = Baumgarte{}, double end_mass = 1) {
  AnyStepping method{solver, cure};
  method.substeps = substeps;
  Simulation simulation{pinned_chain<M>({.links = links, .end_mass = end_mass}), method};
  for (int i = 0; i < steps; ++i) simulation.step(1.0 / 60);
  return simulation;
}

constexpr long long solves = steps * substeps;

TEST(Counts, OfAFixedNumberOfSweepsAreThatNumberInEachSubstep) {
  const auto expect = [](long long passes, const auto& simulation) {
    EXPECT_EQ(counted<M>(simulation.work),
              fmt::format("{} rows laid out, {} solves, {} passes, {} rows prepared, {} row solves", rows, solves,
                          passes * solves, rows * solves, passes * rows * solves));
  };
  expect(13, run_of(GaussSeidel{13}));
  expect(26, run_of(GaussSeidel{13, true, SweepOrder::symmetric}));
  expect(13, run_of(GaussSeidel{13, true, SweepOrder::coloured}));
  expect(13, run_of(Jacobi{13}));
}

Elimination plan_of_the_chain() {
  Graph graph{links, {{Edge::no_body, 0, 2}}};
  for (int i = 1; i < links; ++i) graph.edges.push_back({i - 1, i, 2});
  return plan_elimination(graph, M::dof, 1LL << 40);
}

TEST(Counts, OfADirectSolveAreTheRowSolvesOfAsManyMultiplications) {
  const auto simulation = run_of(Direct{});
  const long long once = plan_of_the_chain().multiplications / (4 * M::dof) + 1;
  EXPECT_EQ(simulation.work.row_solves, once * solves);
  EXPECT_EQ(simulation.work.executed.passes, 0);
  EXPECT_EQ(simulation.work.solution.rounds, substeps);
}

// A heavy end looks like dependent rows. That it is not takes a second solve with the same factor.
TEST(Counts, OfADirectSolveHaveTheLookForDependence) {
  const auto simulation = run_of(Direct{}, Baumgarte{}, 1e4);
  const Elimination plan = plan_of_the_chain();
  EXPECT_EQ(simulation.work.row_solves,
            (plan.multiplications / (4 * M::dof) + 1 + plan.multiplications_again / (4 * M::dof) + 1) * solves);
  EXPECT_EQ(simulation.work.solution.rounds, substeps);
}

TEST(Counts, OfADenseSolveAreASixthOfTheCubeOfItsRows) {
  const long long multiplications = rows * rows * rows / 6 + rows * rows;
  EXPECT_EQ(run_of(Direct{Factorisation::dense}).work.row_solves, (multiplications / (4 * M::dof) + 1) * solves);
}

// Planned once, whenever the rows are laid out: another step plans nothing.
TEST(Counts, OfPlansAreOfThoseMade) {
  auto simulation = run_of(Direct{});
  const auto planned = [&] { return std::any_cast<DirectWork<M>>(&simulation.work.solver)->planned; };
  const long long once = planned();
  EXPECT_GT(once, 30 * links);
  simulation.step(1.0 / 60);
  EXPECT_EQ(planned(), once);
  simulation.scene.add_body(Linear<M>(0, 5), box<M>(1, {1, 1}));
  simulation.step(1.0 / 60);
  EXPECT_EQ(planned(), 2 * once);
}

TEST(Counts, OfProjectionAreItsSweepsOverAllRows) {
  const auto simulation = run_of(GaussSeidel{13}, Projection{.sweeps = 3});
  EXPECT_EQ(simulation.work.executed.projected_rows, 3 * rows * solves);
  EXPECT_EQ(simulation.work.row_solves, (13 + 3) * rows * solves);
}

TEST(Counts, OfSolvesAddUp) {
  Solution sum{.passes = 1, .rounds = 2, .residual = 0.1, .converged = true, .row_solves = 3};
  sum += {.passes = 10, .rounds = 20, .residual = 0.2, .converged = false, .row_solves = 30};
  EXPECT_EQ(sum.passes, 11);
  EXPECT_EQ(sum.rounds, 22);
  EXPECT_EQ(sum.residual, 0.2);
  EXPECT_FALSE(sum.converged);
  EXPECT_EQ(sum.row_solves, 33);
}

// A bob between two fixed points has two rods that say the same of it.
TEST(Counts, OfALoopWhoseRowsRepeatHaveTheSolveInVain) {
  using P = PlaneParticle;
  Scene<P> scene;
  for (const double x : {0.0, 1.0, 2.0}) scene.add_body(Linear<P>(x, 0), x == 1 ? with_mass<P>(1) : fixed<P>());
  for (const int fixed : {0, 2}) scene.add(Distance<P>{{fixed, 1}, 1});
  Simulation<P> simulation{scene, {ByGraph{}}};
  simulation.step(1.0 / 60);
  EXPECT_EQ(simulation.work.solution.rounds, 2);
  EXPECT_EQ(simulation.work.executed.passes, 1);
  EXPECT_EQ(simulation.work.row_solves % 2, 0);
  EXPECT_GT(simulation.work.row_solves, 0);
}

}  // namespace counts_test
