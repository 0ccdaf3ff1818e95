#include <gtest/gtest.h>

#include "lessons/methods/row_solvers.hpp"
#include "lessons/scenes/chain.hpp"
#include "solver/direct/equations.hpp"

// What a step counts of its work, from which its price is made.
namespace counts_test {

using namespace byhand;
using M = PlaneBody;

constexpr int links = 7, rows = 2 * links, steps = 5, substeps = 3;

template <class Solver>
auto run_of(const Solver& solver, const DriftCure& cure = Baumgarte{}) {
  AnyStepping method{solver, cure};
  method.substeps = substeps;
  Simulation simulation{pinned_chain<M>({.links = links}), method};
  for (int i = 0; i < steps; ++i) simulation.step(1.0 / 60);
  return simulation;
}

struct Counts {
  long long laid_out_rows, solves, passes, prepared_rows, projected_rows, row_solves;
  bool operator==(const Counts&) const = default;
};
void PrintTo(const Counts& c, std::ostream* out) {
  *out << c.laid_out_rows << " rows laid out, " << c.solves << " solves, " << c.passes << " passes, "
       << c.prepared_rows << " rows prepared, " << c.projected_rows << " projected, " << c.row_solves
       << " row solves";
}
template <class Simulation>
Counts counts_of(const Simulation& simulation) {
  const Executed& done = simulation.work.executed;
  return {done.laid_out_rows, done.solves,         done.passes,
          done.prepared_rows, done.projected_rows, simulation.work.row_solves};
}

constexpr long long solves = steps * substeps;

TEST(Counts, OfAFixedNumberOfSweepsAreThatNumberInEachSubstep) {
  const auto expected = [](long long passes) {
    return Counts{rows, solves, passes * solves, rows * solves, 0, passes * rows * solves};
  };
  EXPECT_EQ(counts_of(run_of(GaussSeidel{13})), expected(13));
  EXPECT_EQ(counts_of(run_of(GaussSeidel{13, true, SweepOrder::symmetric})), expected(26));
  EXPECT_EQ(counts_of(run_of(GaussSeidel{13, true, SweepOrder::coloured})), expected(13));
  EXPECT_EQ(counts_of(run_of(Jacobi{13})), expected(13));
}

TEST(Counts, OfADirectSolveAreTheRowSolvesOfAsManyMultiplications) {
  const auto simulation = run_of(Direct{});
  Graph graph{links, {{Edge::no_body, 0, 2}}};
  for (int i = 1; i < links; ++i) graph.edges.push_back({i - 1, i, 2});
  const long long once = plan_elimination(graph, M::dof, 1LL << 40).multiplications / (4 * M::dof) + 1;
  const Counts counts = counts_of(simulation);
  EXPECT_EQ(counts.row_solves, once * solves);
  EXPECT_EQ(counts.passes, 0);
  EXPECT_EQ(simulation.work.solution.rounds, substeps);
}

TEST(Counts, OfADenseSolveAreASixthOfTheCubeOfItsRows) {
  const long long multiplications = rows * rows * rows / 6 + rows * rows;
  EXPECT_EQ(counts_of(run_of(Direct{Factorisation::dense})).row_solves,
            (multiplications / (4 * M::dof) + 1) * solves);
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
  const Counts counts = counts_of(run_of(GaussSeidel{13}, Projection{.sweeps = 3}));
  EXPECT_EQ(counts.projected_rows, 3 * rows * solves);
  EXPECT_EQ(counts.row_solves, (13 + 3) * rows * solves);
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

}  // namespace counts_test
