#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lessons/scenes/boxes.hpp"
#include "lessons/scenes/chain.hpp"
#include "solver/constraints/friction.hpp"
#include "solver/constraints/motor.hpp"
#include "solver/rows/residual.hpp"
#include "tests/solver/solving.hpp"

// When solvers stop: on one residual, that of the natural map, as a share of the largest push.
namespace stopping_test {

using namespace byhand;

/// A unit box that comes down at `speed` [m/s] on its four corners. Two opposite ones touch what is higher by
/// `twist` [m], so that the rows of all four contradict each other.
Scene<SpaceBody> box_on_twisted_ground(double speed, double twist) {
  using M = SpaceBody;
  Scene<M> scene;
  scene.add_body(Linear<M>(0, 0, 0), fixed<M>());
  scene.add_body(Linear<M>(0, 0.5, 0), box<M>(1, {1, 1, 1}), {0, -speed, 0, 0, 0, 0});
  for (const double x : {-0.5, 0.5})
    for (const double z : {-0.5, 0.5})
      scene.add(Contact<M>{between<M>(scene.bodies(), 0, {x, x * z > 0 ? twist : 0, z}, 1, {x, 0, z}),
                           Linear<M>::Unit(1)});
  return scene;
}

// The two high corners carry all, and part at βC/h. On the way there every sweep moves λ from the low corners to
// the high ones and leaves V as it was.
TEST(Stopping, IsNotFooledByVelocitiesThatReturnWhileLambdaRuns) {
  for (const double speed : {1.0, 10.0, 100.0, 1000.0})
    for (const double twist : {0.01, 0.02}) {
      Scene<SpaceBody> scene = box_on_twisted_ground(speed, twist);
      const double rise = 0.2 * twist / time_step;
      Work<SpaceBody> work;
      advance(scene, AnyStepping{exact_sweeps(), Baumgarte{}}, time_step, work);
      EXPECT_TRUE(work.solution.converged);
      EXPECT_LE(residual(work.system, scene.bodies().velocity), 1e-11 * speed);
      EXPECT_NEAR(scene.bodies().velocity[1][1], rise, 1e-10 * speed);
      const double half = (speed + 9.81 * time_step + rise) / 2;
      EXPECT_THAT(work.system.lambda,
                  testing::Pointwise(testing::DoubleNear(1e-9 * speed), {half, 0.0, 0.0, half}));
    }
}

TEST(Residual, OfARodIsTheSpeedAtWhichItsEndsPartWhateverTheUnitOfItsRow) {
  using M = PlaneParticle;
  for (const double length : {0.01, 1.0, 300.0}) {
    Scene<M> scene;
    scene.add_body(Linear<M>(0, 0), with_mass<M>(2), {-1, 5});
    scene.add_body(Linear<M>(length, 0), with_mass<M>(0.3), {3, 5});
    const auto measured = [&](const auto& rod) {
      Scene<M> one = scene;
      one.add(rod);
      System<M> system;
      one.lay_out({0}, system);
      one.write_rows(system, time_step);
      return residual(system, one.bodies().velocity);
    };
    EXPECT_NEAR(measured(NormalisedDistance<M>{{0, 1}, length}), 4, 1e-14);
    EXPECT_NEAR(measured(Distance<M>{{0, 1}, length}), 4, 1e-14);
  }
}

TEST(Residual, CountsATurnByTheRadiusOfGyration) {
  using M = PlaneBody;
  Scene<M> scene;
  scene.add_body(Linear<M>(0, 0), fixed<M>());
  scene.add_body(Linear<M>(0, 0), with_mass<M>(4, Angular<M>(0.25)), {0, 0, 6});
  scene.add(Motor<M, Turn>{{.at = {0, 1}, .strength = 1e9}, 0});
  System<M> system;
  scene.lay_out({0}, system);
  scene.write_rows(system, time_step);
  EXPECT_NEAR(residual(system, scene.bodies().velocity), 6 * std::sqrt(0.25 / 4), 1e-14);
}

/// The same scene in a unit of length, mass and time that is smaller by these factors.
template <class M>
Scene<M> in_units(const Scene<M>& scene, double metre, double kilogram, double second) {
  Scene<M> result;
  result.gravity = scene.gravity * metre / second / second;
  for (int i = 0; i < scene.bodies().size(); ++i) {
    Pose<M> pose = scene.bodies().pose[i];
    pose.position *= metre;
    InverseMass<M> mass = scene.bodies().inverse_mass[i];
    mass.linear /= kilogram;
    if constexpr (M::angular > 0) mass.angular /= kilogram * metre * metre;
    Velocity<M> V = scene.bodies().velocity[i] / second;
    V.template head<M::linear>() *= metre;
    result.add_body(pose, mass, V);
  }
  for_each_of<Distance, Pin, Contact, Friction>(scene, [&](auto constraint, int) {
    if constexpr (M::angular > 0)
      for (auto* arm : {&constraint.at.arms.first, &constraint.at.arms.second}) *arm *= metre;
    if constexpr (requires { constraint.length; }) constraint.length *= metre;
    result.add(constraint);
  });
  return result;
}

const AnyRowSolver by_tolerance[] = {GaussSeidel{.sweeps = 3000, .tolerance = 1e-7},
                                     GaussSeidel{.sweeps = 3000, .relaxation = 1.25, .tolerance = 1e-7},
                                     ConjugateSweeps{.sweeps = 3000},
                                     AcceleratedGradient{.iterations = 3000},
                                     Direct{.regularisation = 0x1p-30},
                                     ConjugateGradients{.iterations = 3000}};

/// All units are powers of two, so that no bit may differ.
template <class M>
void expect_the_same_in_all_units(const Scene<M>& scene, const AnyRowSolver& solver) {
  const AnyStepping method{solver};
  if (!refusal(scene, method).empty()) return;
  Scene<M> own = scene;
  Work<M> work;
  advance(own, method, time_step, work);
  for (const double metre : {0x1p10, 0x1p-10})
    for (const double kilogram : {0x1p10, 0x1p-10})
      for (const double second : {0x1p6, 0x1p-6}) {
        Scene<M> other = in_units(scene, metre, kilogram, second);
        Work<M> other_work;
        advance(other, method, time_step * second, other_work);
        EXPECT_EQ(other_work.solution.passes, work.solution.passes);
        EXPECT_EQ(other_work.solution.rounds, work.solution.rounds);
        EXPECT_EQ(other_work.solution.converged, work.solution.converged);
        if (!std::isnan(work.solution.residual)) {
          EXPECT_DOUBLE_EQ(other_work.solution.residual, work.solution.residual * metre / second);
        }
      }
}

TEST(Stopping, IsAtTheSameSweepInEveryUnit) {
  in_all_models(
      [&]<class M>(Random& random) {
        Scene<M> resting;
        resting.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>());
        for (int i = 1; i <= 4; ++i) {
          resting.add_body(Linear<M>(i * Linear<M>::Unit(1)), random.mass<M>(), random.velocity<M>());
          const int contact = resting.add(Contact<M>{{i - 1, i}, Linear<M>::Unit(1)});
          resting.add(Friction<M>{{i - 1, i}, tangents_of<M>(Linear<M>::Unit(1)), 0.5, contact});
        }
        for (const AnyRowSolver& solver : by_tolerance) {
          SCOPED_TRACE(solver.index());
          expect_the_same_in_all_units(resting, solver);
          expect_the_same_in_all_units(mixed_chain<M>(random, 6), solver);
          expect_the_same_in_all_units(ring<M>(random, 6), solver);
        }
      },
      3);
}

// What a solver says of itself against the residual of the state that it leaves. Each row is right at its turn,
// and rows after it that share its bodies then change its error by as much as their own: a few times the
// tolerance.
TEST(Solution, ConvergesOnlyWithinTheTolerance) {
  in_models<PlaneBody, SpaceBody>(
      [&]<class M>(Random& random) {
        for (const double tolerance : {1e-3, 1e-6, 1e-9})
          for (AnyRowSolver solver : by_tolerance) {
            std::visit(
                [&](auto& choice) {
                  if constexpr (requires { choice.tolerance; }) choice.tolerance = tolerance;
                },
                solver);
            Scene<M> scene = stack<M>(3, 1, {0.5});
            for (int i = 1; i < scene.bodies().size(); ++i) scene.set_velocity(i, 10 * random.velocity<M>());
            Work<M> work;
            if (!refusal(scene, AnyStepping{solver}).empty()) continue;
            advance(scene, AnyStepping{solver}, time_step, work);
            RowScales scales;
            find_scales(work.system, scales);
            double push = 0;
            for (int i = 0; i < work.system.rows(); ++i)
              push = std::max(push, scales.speed[i] * std::abs(work.system.lambda[i]));
            const double left = residual(work.system, scene.bodies().velocity);
            EXPECT_EQ(work.solution.converged, work.solution.residual <= tolerance * push) << solver.index();
            if (work.solution.converged) {
              EXPECT_LE(left, 10 * tolerance * push) << solver.index();
            }
          }
      },
      5);
}

TEST(Solution, SaysWhatAStepTook) {
  const auto scene = pinned_chain<PlaneBody>({.links = 10, .angle = 1});
  const auto after = [&](const AnyStepping& method) {
    Simulation<PlaneBody, AnyStepping> simulation{scene, method};
    for (int i = 0; i < 3; ++i) simulation.step(time_step);
    return simulation.work.solution;
  };
  const Solution blind = after({GaussSeidel{7}});
  EXPECT_EQ(blind.passes, 7) << "of the last step alone";
  EXPECT_TRUE(std::isnan(blind.residual)) << "it did not look";
  EXPECT_FALSE(blind.converged);

  const Solution direct = after({Direct{}});
  EXPECT_EQ(direct.rounds, 1);
  EXPECT_TRUE(direct.converged);

  AnyStepping substeps{Direct{}};
  substeps.substeps = 3;
  EXPECT_EQ(after(substeps).rounds, 3);

  const Solution too_few = after({ConjugateSweeps{.sweeps = 2, .tolerance = 1e-12}});
  EXPECT_EQ(too_few.passes, 2);
  EXPECT_GT(too_few.residual, 1e-12);
  EXPECT_FALSE(too_few.converged) << "exact is what it says";
  EXPECT_TRUE(after({exact_sweeps()}).converged);
}

// λ vanishes, and what sweeps change is rounding: of velocities of 100 m/s it is never within 1e-12 of λ.
TEST_IN_ALL_MODELS(Stopping, EndsAtOnceWhereAllDriftsAtOneSpeed) {
  Scene<M> scene = ring<M>(random, 8);
  scene.gravity.setZero();
  for (auto& V : scene.state().velocity) {
    V.setZero();
    V[0] = 100.3, V[1] = 17.7;
  }
  for (const AnyRowSolver& solver :
       {AnyRowSolver(exact_sweeps()), AnyRowSolver(GaussSeidel{.sweeps = 100, .tolerance = 1e-12}),
        AnyRowSolver(AcceleratedGradient{.tolerance = 1e-12}),
        AnyRowSolver(ConjugateGradients{.tolerance = 1e-12})}) {
    Simulation<M, AnyStepping> simulation{scene, {solver, NoDriftCure{}}};
    simulation.step(time_step);
    EXPECT_TRUE(simulation.work.solution.converged) << solver.index();
    EXPECT_LE(simulation.work.solution.passes, 2) << solver.index();
  }
}

// Of a motor, whose row has no lever, what is pushed is a moment.
TEST_IN_BOTH_BODIES(ConjugateSweeps, SaveSweepsAlsoOnRowsThatOnlyTurn) {
  Scene<M> scene;
  for (int i = 0; i < 20; ++i) {
    scene.add_body(random.pose<M>().position, ball<M>(random.uniform(1, 2), 0.3), random.velocity<M>());
    if (i == 0) continue;
    Turn<M> turn{i - 1, i};
    if constexpr (M::angular == 3) turn.axis = Linear<M>::Unit(0);
    scene.add(motor(turn, 1, 1e9));
  }
  const auto passes = [&](const AnyRowSolver& solver) {
    Simulation<M, AnyStepping> simulation{scene, {solver}};
    simulation.step(time_step);
    EXPECT_TRUE(simulation.work.solution.converged);
    return simulation.work.solution.passes;
  };
  EXPECT_LT(2 * passes(ConjugateSweeps{.sweeps = 10000, .tolerance = 1e-9}),
            passes(GaussSeidel{.sweeps = 10000, .tolerance = 1e-9}));
}

// Two rods have two eigenvalues; what iterations after that change is rounding, most of all of the second rod's λ,
// which is to vanish.
TEST(ConjugateGradients, StopAtRoundingWithoutATolerance) {
  using M = PlaneParticle;
  for (const double angle : {0.3, 1.1, 2.2, 3.7}) {
    const Linear<M> along(std::cos(angle), std::sin(angle));
    Scene<M> scene;
    scene.gravity.setZero();
    for (const double rate : {0.0, 0.74, 0.37})
      scene.add_body(scene.bodies().size() * along, with_mass<M>(0.7), rate * along);
    for (const int i : {0, 1}) scene.add(NormalisedDistance<M>{{i, i + 1}, 1});
    Simulation<M, AnyStepping> simulation{scene, {ConjugateGradients{.iterations = 1000, .tolerance = 0}}};
    simulation.step(time_step);
    EXPECT_EQ(simulation.work.solution.passes, 2);
  }
}

TEST(ActiveSet, IsAcceptedByTheResidual) {
  int converged = 0;
  in_models<PlaneBody, SpaceBody>(
      [&]<class M>(Random& random) {
        Scene<M> scene = stack<M>(3, 1, {0.3});
        for (int i = 1; i < scene.bodies().size(); ++i) scene.set_velocity(i, random.velocity<M>());
        Work<M> work;
        advance(scene, AnyStepping{Direct{.regularisation = 1e-9}}, time_step, work);
        const double left = residual(work.system, scene.bodies().velocity);
        EXPECT_EQ(work.solution.converged, left <= 1e-8);
        if (work.solution.rounds < 20) {
          EXPECT_EQ((work.solution.passes + 2) / 3, work.solution.rounds) << "each of up to three sweeps";
        }
        converged += work.solution.converged;
      },
      20);
  EXPECT_GE(converged, 38);
}

}  // namespace stopping_test
