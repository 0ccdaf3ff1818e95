#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "lessons/scenes/chain.hpp"
#include "solver/direct/graph.hpp"
#include "tests/solver/compiled.hpp"
#include "tests/solver/solving.hpp"

// Gauss–Seidel and Jacobi: the fused loops against (17) and (20) as the article writes them, orders, warm start.
namespace sweeps_test {

using namespace byhand;

/// Rows of all constraints, one by one in the order of `numbers`, swept with the article's own formulas;
/// returns the velocities.
template <class M>
std::vector<double> swept_by_hand(Scene<M> scene, const std::vector<int>& numbers, int sweeps,
                                  double relaxation = 1) {
  struct Row {
    int body1, body2;
    Jacobian<M, 1> J, W;
    double bias, gamma, lower, lambda = 0;
  };
  auto& bodies = scene.state();
  std::vector<std::vector<Row>> natural;
  for_each_of<Distance, Pin, Contact>(scene, [&](const auto& constraint, int) {
    using Kind = std::remove_cvref_t<decltype(constraint)>;
    const int b1 = constraint.at.body1, b2 = constraint.at.body2;
    const auto all = constraint.jacobian(bodies.pose[b1], bodies.pose[b2]);
    const auto C = constraint.template value<double>(bodies.pose[b1], bodies.pose[b2]);
    auto& rows = natural.emplace_back();
    for (int k = 0; k < Kind::rows; ++k) {
      const Jacobian<M, 1> J{all.matrix.row(k)};
      const bool open = bound_of<Kind>() == Bound::interval && C[k] > 0;
      rows.push_back({b1, b2, J,
                      times_inverse_mass(J, bodies.inverse_mass[b1], bodies.pose[b1], bodies.inverse_mass[b2],
                                         bodies.pose[b2]),
                      (open ? 1.0 : 0.2) / time_step * C[k], constraint.softness,
                      bound_of<Kind>() == Bound::interval ? 0.0 : -1e300});
    }
  });
  add_gravity(bodies, scene.gravity, time_step);
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (const int number : numbers)
      for (Row& row : natural[number]) {
        Velocity<M>&V1 = bodies.velocity[row.body1], &V2 = bodies.velocity[row.body2];
        const double A = inverse_effective_mass(row.J, row.W)(0, 0);
        const double change =
            A == 0 ? 0.0 : impulse(row.J, row.W, V1, V2, row.bias + row.gamma * row.lambda) * A / (A + row.gamma);
        const double next = std::max(row.lower, row.lambda + relaxation * change);
        apply_impulse(row.W, Rows<1>(next - row.lambda), V1, V2);
        row.lambda = next;
      }
  return numbers_of<M>(bodies.velocity);
}

std::vector<int> natural_order(int count) {
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  return order;
}

/// Rods and contacts, which have one row each.
template <class M>
Scene<M> single_rows(Random& random) {
  Scene<M> scene;
  for (int i = 0; i < 8; ++i)
    scene.add_body(random.pose<M>(), i == 0 ? fixed<M>() : random.mass<M>(),
                   i == 0 ? Velocity<M>(Velocity<M>::Zero()) : random.velocity<M>());
  for (int i = 0; i < 14; ++i) {
    const int body1 = random.index(8), body2 = (body1 + 1 + random.index(7)) % 8;
    const Anchors<M> at{body1, body2, random.arms<M>()};
    if (i % 3 == 0)
      scene.add(Contact<M>{at, random.direction<M>(), i % 2 * 0.1});
    else
      scene.add(Distance<M>{at, random.uniform(1, 2), i % 2 * 0.3});
  }
  return scene;
}

TEST_IN_ALL_MODELS(GaussSeidel, IsEquations17And20RowAfterRow, 20) {
  const auto scene = single_rows<M>(random);
  const int count = scene.count();
  std::vector<int> forward = natural_order(count), backward(forward.rbegin(), forward.rend());
  const auto expect = [&](SweepOrder order, const std::vector<int>& by_hand, double relaxation) {
    GaussSeidel solver{7, false, order};
    solver.relaxation = relaxation;
    const auto expected = swept_by_hand(scene, by_hand, 7, relaxation);
    EXPECT_LE(difference(solved(scene, solver).velocity, expected), 1e-12 * (1 + largest(expected)));
  };
  expect(SweepOrder::natural, forward, 1);
  expect(SweepOrder::reverse, backward, 1);
  expect(SweepOrder::coloured, coloured_order(scene.graph()), 1);
  expect(SweepOrder::natural, forward, 0.7);
  expect(SweepOrder::natural, forward, 1.3);
}

TEST_IN_ALL_MODELS(GaussSeidel, RowByRowSolvesTheRowsOfABlockOneAtATime, 20) {
  const auto scene = random_graph<M>(random, 8, 12);
  GaussSeidel solver{5, false};
  solver.block_solve = BlockSolve::row_by_row;
  const auto expected = swept_by_hand(scene, natural_order(scene.count()), 5);
  EXPECT_LE(difference(solved(scene, solver).velocity, expected), 1e-12 * (1 + largest(expected)));
  solver.block_solve = BlockSolve::whole;
  EXPECT_GE(difference(solved(scene, solver).velocity, expected), M::angular == 0 ? 0.0 : 1e-6)
      << "a block is another method where turning couples its rows";
}

TEST_IN_ALL_MODELS(GaussSeidel, SolvesABlockWholeAtOnce, 50) {
  const auto pair = random_pair<M>(random);
  Scene<M> scene = pair.scene();
  scene.add(Pin<M>{pair.at});
  const auto answer = solved(scene, GaussSeidel{1, false});
  EXPECT_LE(answer.residual, 1e-11);
  EXPECT_LE(difference(answer.lambda, solved(scene, Direct{Factorisation::dense}).lambda), 1e-11);
}

TEST_IN_ALL_MODELS(GaussSeidel, OrdersDifferOnTheWayAndMeetAtTheEnd) {
  const auto scene = with_random_velocities(rod_chain<M>({.links = 6, .angle = 1}), random);
  const auto exact = solved(scene, Direct{Factorisation::dense});
  std::set<double> after_one_sweep;
  for (const auto order : {SweepOrder::natural, SweepOrder::reverse, SweepOrder::coloured}) {
    after_one_sweep.insert(solved(scene, GaussSeidel{1, false, order}).residual);
    const auto answer = solved(scene, GaussSeidel{2000, false, order});
    EXPECT_LE(difference(answer.velocity, exact.velocity), 1e-10);
    EXPECT_LE(difference(answer.lambda, exact.lambda), 1e-10);
  }
  EXPECT_EQ(after_one_sweep.size(), 3);
}

TEST_IN_ALL_MODELS(GaussSeidel, WarmAndColdMeetAtTheEnd) {
  auto warm = rod_chain<M>({.links = 6, .angle = 1}), cold = warm;
  Work<M> warm_work, cold_work;
  for (int i = 0; i < 10; ++i) {
    advance(warm, {GaussSeidel{1000, true}}, time_step, warm_work);
    advance(cold, {GaussSeidel{1000, false}}, time_step, cold_work);
  }
  EXPECT_LE(difference(numbers_of<M>(warm.bodies().velocity), numbers_of<M>(cold.bodies().velocity)), 1e-8);
}

TEST(GaussSeidel, WarmStartBeginsWithTheImpulsesOfTheLastStep) {
  auto scene = rod_chain<PlaneParticle>({.links = 6});
  Work<PlaneParticle> work;
  const auto residual_after_a_step = [&](double h) {
    advance(scene, {GaussSeidel{1}, NoDriftCure{}}, h, work);
    return residual(work.system, scene.bodies().velocity);
  };
  EXPECT_GT(residual_after_a_step(time_step), 0.01);
  for (int i = 0; i < 2000; ++i) residual_after_a_step(time_step);
  EXPECT_LT(residual_after_a_step(time_step), 1e-10) << "a chain that hangs still has nothing left to solve";
  EXPECT_LT(residual_after_a_step(time_step / 2), 1e-10) << "λ is an impulse and halves with the step";
}

TEST_IN_ALL_MODELS(ColdStart, ForgetsWhatLambdaWasBefore) {
  for (const RowSolver& solver : {RowSolver(GaussSeidel{3, false}), RowSolver(Jacobi{3, false})}) {
    auto scene = rod_chain<M>({.links = 5, .angle = 1});
    Work<M> used, none;
    for (int i = 0; i < 5; ++i) advance(scene, {solver}, time_step, used);
    auto fresh = scene;
    advance(scene, {solver}, time_step, used);
    advance(fresh, {solver}, time_step, none);
    EXPECT_EQ(used.system.lambda, none.system.lambda);
  }
}

TEST(GaussSeidel, RelaxesFasterAtTheBestFactor) {
  // SOR theory: ω = 2/(1+√(1-ρ²)) with ρ = cos(π/2N) of Jacobi takes the rate from ρ² to ω - 1.
  const auto scene = rod_chain<PlaneParticle, NormalisedDistance>({.links = 10});
  const double rho = std::cos(std::acos(-1.0) / 20);
  GaussSeidel solver{60, false}, relaxed = solver;
  relaxed.relaxation = 2 / (1 + std::sqrt(1 - rho * rho));
  EXPECT_LT(solved(scene, relaxed).residual, 1e-3 * solved(scene, solver).residual);
}

TEST_IN_ALL_MODELS(Colouring, SharesNoMovingBodyWithinAColour, 30) {
  const auto graph = random_graph<M>(random, 12, 30).graph();
  const auto order = coloured_order(graph);
  EXPECT_EQ(std::set<int>(order.begin(), order.end()).size(), graph.edges.size());
  // Cut at every meeting of two edges at a body; an order that is not by colours falls into many groups.
  std::set<int> taken;
  int groups = 1;
  std::vector<int> degree(graph.bodies);
  for (const int e : order) {
    const auto& edge = graph.edges[e];
    if (taken.count(edge.body1) || taken.count(edge.body2)) {
      taken.clear();
      ++groups;
    }
    for (const int body : {edge.body1, edge.body2})
      if (body != Edge::no_body) {
        taken.insert(body);
        ++degree[body];
      }
  }
  EXPECT_LE(groups, 2 * *std::max_element(degree.begin(), degree.end()) - 1) << "what a greedy colouring needs";
}

TEST(Colouring, TakesAChainInTwoColoursAndPinsToTheGroundInOne) {
  const std::vector<int> red_black{0, 2, 4, 1, 3, 5};
  EXPECT_EQ(coloured_order(rod_chain<PlaneParticle>({.links = 6}).graph()), red_black);
  Scene<PlaneBody> scene;
  const int ground = scene.add_body({0, 0}, fixed<PlaneBody>());
  for (int i = 0; i < 6; ++i) {
    const int body = scene.add_body({1.0 * i, 0}, ball<PlaneBody>(1, 0.1));
    scene.add(pin<PlaneBody>(scene.bodies(), ground, body, {1.0 * i, 0.1}));
  }
  EXPECT_EQ(coloured_order(scene.graph()), natural_order(6));
}

TEST_IN_ALL_MODELS(Jacobi, SolvesEveryRowFromTheSameVelocities, 20) {
  const auto scene = random_graph<M>(random, 8, 12);
  Jacobi solver{1, false};
  solver.relaxation = 0.8;
  solver.block_solve = BlockSolve::row_by_row;
  // One sweep from rest of λ is the sum of what every constraint would do alone.
  std::vector<double> expected, before;
  {
    auto free = scene;
    add_gravity(free.state(), free.gravity, time_step);
    before = expected = numbers_of<M>(free.bodies().velocity);
  }
  for (int number = 0; number < scene.count(); ++number) {
    const auto alone = swept_by_hand(scene, {number}, 1);
    for (std::size_t i = 0; i < expected.size(); ++i) expected[i] += 0.8 * (alone[i] - before[i]);
  }
  EXPECT_LE(difference(solved(scene, solver).velocity, expected), 1e-12 * (1 + largest(expected)));
}

TEST_IN_ALL_MODELS(Jacobi, ConvergesToTheSameAnswerUnderRelaxation) {
  const auto scene = with_random_velocities(rod_chain<M>({.links = 6, .angle = 1}), random);
  Jacobi solver{4000, false};
  solver.relaxation = 0.9;
  const auto exact = solved(scene, Direct{Factorisation::dense});
  EXPECT_LE(difference(solved(scene, solver).lambda, exact.lambda), 1e-9);
}

}  // namespace sweeps_test
