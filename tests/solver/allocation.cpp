#include <gtest/gtest.h>

#include "lessons/methods/accelerations.hpp"
#include "lessons/methods/controlled.hpp"
#include "lessons/methods/rattle.hpp"
#include "lessons/scenes/branches.hpp"
#include "lessons/scenes/chain.hpp"
#include "lessons/scenes/incline.hpp"
#include "solver/constraints/friction.hpp"
#include "solver/direct/equations.hpp"
#include "solver/direct/newton_work.hpp"
#include "tests/solver/allocations.hpp"
#include "tests/solver/each_cure.hpp"
#include "tests/solver/solving.hpp"

namespace allocation_test {

using namespace byhand;

const AnyRowSolver solvers[] = {GaussSeidel{},
                                GaussSeidel{10, false, SweepOrder::reverse},
                                GaussSeidel{10, true, SweepOrder::coloured},
                                Jacobi{.relaxation = 0.2},
                                Direct{},
                                ConjugateSweeps{},
                                ConjugateGradients{},
                                AcceleratedGradient{},
                                SemismoothNewton{}};

template <class M>
void expect_none_after_the_first_step(Scene<M> scene, const AnyRowSolver& solver,
                                      const DriftCure& cure = Baumgarte{}) {
  Work<M> work;
  AnyStepping method{solver, cure};
  method.substeps = 2;
  EXPECT_GT(allocations_in([&] { advance(scene, method, time_step, work); }), 0) << "the counter counts";
  EXPECT_EQ(allocations_in([&] {
              for (int i = 0; i < 5; ++i) advance(scene, method, time_step, work);
            }),
            0);
}

TEST_IN_ALL_MODELS(Allocation, HappensInNoStepAfterTheFirst) {
  for (const auto& solver : solvers) {
    SCOPED_TRACE(solver.index());
    expect_none_after_the_first_step(rod_chain<M>({.links = 10, .angle = 1}), solver);
    expect_none_after_the_first_step(random_graph<M>(random, 10, 25), solver);
    if constexpr (M::angular > 0) expect_none_after_the_first_step(pinned_star<M>(9), solver);
  }
}

TEST_IN_ALL_MODELS(Allocation, HappensInNoStepOfAnyCureAfterTheFirst) {
  for (const DriftCure& cure : tests::each_cure())
    for (const AnyRowSolver& solver : {AnyRowSolver(GaussSeidel{}), AnyRowSolver(Direct{})})
      expect_none_after_the_first_step(rod_chain<M>({.links = 10, .angle = 1}), solver, cure);
}

TEST_IN_ALL_MODELS(Allocation, HappensInNoStepWithContactsAfterTheFirst) {
  for (const auto& solver : {solvers[0], solvers[2], solvers[3], solvers[5], solvers[7], solvers[8]}) {
    Scene<M> scene;
    const int ground = scene.add_body(random.pose<M>(), fixed<M>());
    for (int i = 0; i < 4; ++i) {
      const int body = scene.add_body(random.pose<M>(), random.mass<M>());
      const int contact = scene.add(Contact<M>{{ground, body}, Linear<M>::Unit(1)});
      scene.add(Friction<M>{{ground, body}, tangents_of<M>(Linear<M>::Unit(1)), 0.5, contact});
    }
    expect_none_after_the_first_step(scene, solver);
  }
}

template <class M, class Method>
void expect_none_after_the_first_step_by(const Scene<M>& scene, const Method& method) {
  Simulation simulation{scene, method};
  simulation.step(time_step);
  EXPECT_EQ(allocations_in([&] {
              for (int i = 0; i < 5; ++i) simulation.step(time_step);
            }),
            0);
}

TEST(Allocation, HappensInNoStepOfAccelerationsOrRattleAfterTheFirst) {
  const auto expect_none = [](const auto& scene) {
    for (const Scheme scheme : {Scheme::rk4, Scheme::implicit_midpoint})
      expect_none_after_the_first_step_by(scene, Accelerations{scheme, 2});
    expect_none_after_the_first_step_by(scene, Rattle{2});
    expect_none_after_the_first_step_by(scene, Controlled<Rattle>{1e-5});
    expect_none_after_the_first_step_by(scene, Controlled<Generalised>{1e-10});
  };
  expect_none(rod_chain<PlaneParticle>({.links = 10, .angle = 1}));
  expect_none(pinned_chain<SpaceBody>({.links = 10, .angle = 1}));
}

template <class M>
void expect_none_at_rest(const Scene<M>& scene, const AnyRowSolver& solver) {
  Simulation simulation{scene, AnyStepping{solver}};
  for (int i = 0; i < 30; ++i) simulation.step(time_step);
  EXPECT_EQ(allocations_in([&] {
              for (int i = 0; i < 30; ++i) simulation.step(time_step);
            }),
            0);
}

TEST(Allocation, HappensInNoStepWhileTheSameContactsAreFound) {
  for (const AnyRowSolver& solver : {AnyRowSolver(GaussSeidel{}), AnyRowSolver(ByGraph{})}) {
    expect_none_at_rest(stack(5), solver);
    expect_none_at_rest(pyramid(4), solver);
    expect_none_at_rest(box_on_incline<SpaceBody>(0.1, 0.5, 1), solver);
  }
}

TEST_IN_ALL_MODELS(Allocation, HappensOnlyToPlanWhenAGraphIsLaidAgainWithinItsLargestSize) {
  // Laying out anew needs a new order; the rows, blocks and scratch it is written to have their room already.
  for (const auto& solver : solvers) {
    SCOPED_TRACE(solver.index());
    auto scene = rod_chain<M>({.links = 40, .angle = 1});
    Work<M> work;
    advance(scene, AnyStepping{solver}, time_step, work);
    work.layout = Layout::none;
    const auto* rows = work.system.lambda.data();
    const auto factor = [&]() -> const double* {
      const auto* direct = std::any_cast<DirectWork<M>>(&work.solver);
      return direct ? direct->values.data() : nullptr;
    };
    const double* values = factor();
    const auto* blocks = std::get<0>(work.system.blocks).data();
    ASSERT_NE(rows, nullptr);
    ASSERT_NE(blocks, nullptr);
    EXPECT_EQ(values != nullptr, std::holds_alternative<Direct>(solver));
    const long planning = allocations_in([&] {
      const Graph graph = scene.graph();
      Elimination plan;
      if (std::holds_alternative<Direct>(solver))
        elimination_order(graph, M::dof, plan);
      else if (std::holds_alternative<SemismoothNewton>(solver))
        Envelope<M>().plan(work.system, scene.bodies().size());
      else
        order_of(Layout::coloured, graph);
    });
    // And two for what is carried over: the λ of constraints that stay, and where it stood.
    EXPECT_LE(allocations_in([&] { advance(scene, AnyStepping{solver}, time_step, work); }), planning + 2);
    EXPECT_EQ(work.system.lambda.data(), rows);
    EXPECT_EQ(factor(), values);
    EXPECT_EQ(std::get<0>(work.system.blocks).data(), blocks);
  }
}

}  // namespace allocation_test
