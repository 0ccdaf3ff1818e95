#include <gtest/gtest.h>

#include "lessons/scenes/boxes.hpp"
#include "lessons/scenes/chain.hpp"
#include "solver/constraints/spring.hpp"
#include "tests/solver/solving.hpp"

// Cures of drift beside Baumgarte's: what each leaves in the poses, and what in the velocities.
namespace cures_test {

using namespace byhand;
using M = PlaneParticle;
using Rods = Scene<M>;

Rods hanging(int links) { return rod_chain<M, NormalisedDistance>({.links = links}); }

AnyStepping cured_by(const DriftCure& cure, const AnyRowSolver& solver = GaussSeidel{}, int substeps = 1) {
  AnyStepping method{solver, cure};
  method.substeps = substeps;
  return method;
}

/// A bob that rests in weightlessness with its rod stretched by `error` [m].
Simulation<M, AnyStepping> stretched(double error, const DriftCure& cure) {
  Simulation<M, AnyStepping> simulation{pendulum<M, NormalisedDistance>(0.4, 2, 3), cured_by(cure)};
  simulation.scene.gravity.setZero();
  simulation.scene.state().pose[1].position *= 1 + error / 2;
  return simulation;
}
double stretch(const Simulation<M, AnyStepping>& simulation) {
  return simulation.scene.bodies().pose[1].position.norm() - 2;
}

TEST(SplitImpulse, AStepLeavesOneMinusBetaOfTheErrorAndNoVelocity) {
  for (const double beta : {0.0, 0.1, 0.2, 1.0, 1.5, 2.5}) {
    auto simulation = stretched(0.1, SplitImpulse{beta});
    for (int i = 1; i <= 4; ++i) {
      simulation.step(time_step);
      EXPECT_NEAR(stretch(simulation), 0.1 * std::pow(1 - beta, i), 1e-13) << beta;
      EXPECT_EQ(simulation.scene.bodies().velocity[1].norm(), 0) << beta;
    }
  }
}

/// A unit box on the ground, `overlap` [m] within it.
Simulation<PlaneBody, AnyStepping> sunk(double overlap, const DriftCure& cure) {
  Simulation<PlaneBody, AnyStepping> simulation{stack(1), cured_by(cure)};
  simulation.scene.state().pose[1].position.y() -= overlap;
  return simulation;
}
double height(const Simulation<PlaneBody, AnyStepping>& simulation) {
  return simulation.scene.bodies().pose[1].position.y() - 0.5;
}

// Baumgarte's throws it off the ground from 0.1226 m on.
TEST(SplitImpulse, ADeepBoxDoesNotPop) {
  for (const double overlap : {0.05, 0.2, 0.4}) {
    auto split = sunk(overlap, SplitImpulse{}), baumgarte = sunk(overlap, Baumgarte{});
    double highest = -1;
    for (int i = 1; i <= 100; ++i) {
      split.step(time_step);
      baumgarte.step(time_step);
      highest = std::max(highest, height(baumgarte));
      EXPECT_NEAR(height(split), -overlap * std::pow(0.8, i), 1e-12);
      EXPECT_LE(split.scene.bodies().velocity[1].norm(), 1e-12);
    }
    EXPECT_EQ(highest > 1e-3, overlap > 0.1226) << overlap;
  }
}

TEST(SplitImpulse, HonoursSlopAndSpeedCap) {
  auto simulation = sunk(0.4, SplitImpulse{.slop = 0.05, .speed_cap = 1.5});
  simulation.step(time_step);
  EXPECT_NEAR(height(simulation), -0.4 + 1.5 * time_step, 1e-13);
  for (int i = 0; i < 200; ++i) simulation.step(time_step);
  EXPECT_NEAR(height(simulation), -0.05, 1e-12);
}

TEST(SplitImpulse, StillLetsAContactCloseItsGapAndBounce) {
  Scene<PlaneBody> scene;
  add_ground(scene, {0, 0.5});
  add_unit_box(scene, 0, 0.51, 1, {0, 0.5});
  scene.state().velocity[1].y() = -6;
  Simulation<PlaneBody, AnyStepping> simulation{scene, cured_by(SplitImpulse{})};
  simulation.step(time_step);
  EXPECT_NEAR(height(simulation), 0, 1e-14);
  // As restitution.hpp derives: half the speed at which the parabola of the fall meets the ground.
  const double fall = 9.81 * time_step, meets = std::sqrt((6 + fall / 2) * (6 + fall / 2) + 2 * 9.81 * 0.01);
  EXPECT_NEAR(simulation.scene.bodies().velocity[1].y(), meets / 2 + fall / 2, 1e-12);
}

// A warm start remembers Baumgarte's correction as a velocity: ten links and one sweep ring from β = 0.025 on.
// Split impulse remembers it as a change of pose, which rings at no β and is much quicker than to begin anew.
TEST(SplitImpulse, OneWarmSweepIsEnoughAtAnyBeta) {
  for (const double beta : {0.2, 0.5, 1.0, 1.9})
    for (const bool warm : {false, true}) {
      Simulation<M, AnyStepping> split{hanging(10),
                                       cured_by(SplitImpulse{.beta = beta, .warm_start = warm}, GaussSeidel{1})},
          baumgarte{hanging(10), cured_by(Baumgarte{beta}, GaussSeidel{1})};
      for (int i = 0; i < 6000; ++i) {
        split.step(time_step);
        baumgarte.step(time_step);
      }
      EXPECT_LE(position_error(split).max, 1e-10) << beta;
      EXPECT_GE(position_error(baumgarte).max, 0.1) << beta;
    }
}

TEST(SplitImpulse, ReachesThePosesSoonerFromTheLastCorrection) {
  const auto steps = [](bool warm) {
    Simulation<M, AnyStepping> chain{hanging(10), cured_by(SplitImpulse{.warm_start = warm}, GaussSeidel{1})};
    for (int i = 1; i <= 10; ++i) chain.scene.state().pose[i].position.y() -= 0.01 * i;
    int count = 0;
    do chain.step(time_step), ++count;
    while (position_error(chain).max > 1e-3 && count < 5000);
    return count;
  };
  EXPECT_LT(10 * steps(true), steps(false));
}

/// A bob on a rod of 1 m, let go at 90°, step by step in numbers of its own: x, v, the rod's unit vector n, its
/// error C and its λ for 1 kg. What of it a cure changes comes as a function. Returns the energy lost after 10 s
/// in units of m g L.
struct Bob {
  Eigen::Vector2d x{1, 0}, v{0, 0}, n{1, 0};
  double C = 0, lambda = 0;

  void look() {
    n = x.normalized();
    C = x.norm() - 1;
  }
  /// v along the rod becomes `speed`.
  void set_speed_along(double speed) {
    const double change = speed - v.dot(n);
    v += change * n;
    lambda += change;
  }
  template <class Solve, class Move>
  double lost(Solve&& solve, Move&& move) {
    for (int i = 0; i < 600; ++i) {
      look();
      v.y() -= 9.81 * time_step;
      solve(*this);
      x += time_step * v;
      move(*this);
    }
    return -(v.squaredNorm() / 2 + 9.81 * x.y()) / 9.81;
  }
};

/// Energy that a pendulum of 90° has lost after 10 s, in units of m g L.
double energy_lost(const DriftCure& cure) {
  Simulation<M, AnyStepping> simulation{pendulum<M, NormalisedDistance>(std::acos(-1.0) / 2, 1, 1),
                                        cured_by(cure)};
  const double before = energy(simulation.scene);
  for (int i = 0; i < 600; ++i) simulation.step(time_step);
  return (before - energy(simulation.scene)) / 9.81;
}

// A velocity along the rod of one step's start leaves the circle. Baumgarte's correction turns it back; what moves
// poses alone leaves it to be thrown away by the next step. Tangent to the rod where it has come to, it loses
// little.
TEST(Cures, LoseThePendulumsEnergyUnlessVelocitiesTurnWithIt) {
  const auto hard = [](Bob& bob) { bob.set_speed_along(0); };
  const auto nothing = [](Bob&) {};
  // 600 steps of numbers of about 1, of which each rounding may grow with the time: 600² 2⁻⁵³ = 4e-11.
  constexpr double rounding = 1e-10;
  EXPECT_NEAR(energy_lost(NoDriftCure{}), Bob().lost(hard, nothing), rounding);
  const auto baumgarte = [](Bob& bob) { bob.set_speed_along(-0.2 * bob.C / time_step); };
  EXPECT_NEAR(energy_lost(Baumgarte{}), Bob().lost(baumgarte, nothing), rounding);
  const auto onto_the_circle = [](Bob& bob) { bob.x.normalize(); };
  EXPECT_NEAR(energy_lost(Projection{}), Bob().lost(hard, onto_the_circle), rounding);
  for (const double beta : {0.2, 1.0}) {
    const auto push = [beta](Bob& bob) { bob.x -= beta * bob.C * bob.n; };
    EXPECT_NEAR(energy_lost(SplitImpulse{beta}), Bob().lost(hard, push), rounding) << beta;
  }
  for (const bool refresh : {false, true}) {
    const SoftConstraints cure{.frequency = 90, .damping_ratio = 1, .refresh = refresh};
    const double a1 = 2 + time_step * 90, a2 = time_step * 90 * a1;  // of an effective mass of 1 kg
    const auto soft = [=](Bob& bob) {  // v·n + 90/a1 C + λ/a2 = 0, from the λ that stands
      bob.v += bob.lambda * bob.n;
      const double change = -(bob.v.dot(bob.n) + 90 / a1 * bob.C + bob.lambda / a2) / (1 + 1 / a2);
      bob.set_speed_along(bob.v.dot(bob.n) + change);
    };
    const auto relaxed = [=](Bob& bob) {
      if (refresh) bob.look();
      bob.set_speed_along(0);
    };
    EXPECT_NEAR(energy_lost(cure), Bob().lost(soft, relaxed), rounding) << refresh;
  }
  // And what that comes to: most is lost where velocities are cut off at the next step's tangent.
  EXPECT_LT(9 * energy_lost(SoftConstraints{.refresh = true}), energy_lost(Projection{}));
  EXPECT_LT(5 * energy_lost(Baumgarte{}), energy_lost(Projection{}));
}

TEST(SoftConstraints, SagByTheirLoadOverTheirStiffness) {
  for (const bool relax : {false, true})
    for (const double frequency : {10.0, 40.0, 200.0})
      for (const double ratio : {0.5, 1.0, 10.0}) {
        Simulation<M, AnyStepping> simulation{pendulum<M, NormalisedDistance>(0, 1, 3),
                                              cured_by(SoftConstraints{frequency, ratio, relax})};
        for (int i = 0; i < 6000; ++i) simulation.step(time_step);
        EXPECT_NEAR(position_error(simulation).max * frequency * frequency / 9.81, 1, 1e-9);
        EXPECT_NEAR(simulation.work.system.lambda[0], -3 * 9.81 * time_step, 1e-9);
      }
}

TEST(SoftConstraints, AreStableInOneRowForEveryFrequencyAndDamping) {
  for (const double turn : {1e-2, 0.1, 1.0, 10.0, 100.0, 1e3})  // ωh
    for (const double ratio : {0.0, 0.1, 1.0, 10.0}) {
      auto swinging = stretched(0.1, SoftConstraints{turn / time_step, ratio, false});
      auto relaxed = stretched(0.1, SoftConstraints{turn / time_step, ratio, true});
      // Each step begins at rest: the soft solve takes ω/a₁ C to a₂/(1 + a₂).
      const double left = 1 - turn * turn / (1 + turn * (2 * ratio + turn));
      double most = 0;
      for (int i = 1; i <= 2000; ++i) {
        swinging.step(time_step);
        relaxed.step(time_step);
        most = std::max(most, std::abs(stretch(swinging)));
        ASSERT_NEAR(stretch(relaxed), 0.1 * std::pow(left, i), 1e-11) << turn << ' ' << ratio;
      }
      EXPECT_LE(most, 0.1) << turn << ' ' << ratio;
      const double decay = ratio > 1 ? turn / (2 * ratio) : turn * (ratio + turn / 2);  // a step, about
      if (2000 * decay > 10) {
        EXPECT_LE(std::abs(stretch(swinging)), 0.01) << turn << ' ' << ratio;
      }
    }
}

TEST(SoftConstraints, AreSpringsOfTheRowsOwnMass) {
  auto soft = pendulum<M, NormalisedDistance>(1, 2, 3);
  soft.state().pose[1].position *= 1.05;
  Scene<M> spring = bodies_alone(soft);
  const NormalisedDistance<M> rod = soft.all<NormalisedDistance>()[0];
  spring.add(Spring<M>{rod.at, rod.length, tuned(soft.bodies(), rod, 30, 0.7)});
  Work<M> work1, work2;
  for (int i = 0; i < 50; ++i) {
    advance(soft, cured_by(SoftConstraints{30, 0.7, false}), time_step, work1);
    advance(spring, AnyStepping{}, time_step, work2);
    ASSERT_LE((soft.bodies().pose[1].position - spring.bodies().pose[1].position).norm(), 1e-12) << i;
  }
}

TEST(SoftConstraints, LeaveNoSpeedAlongTheRowsOnceTheyAreRelaxed) {
  for (const AnyRowSolver& solver : {AnyRowSolver(Direct{}), AnyRowSolver(GaussSeidel{2000})})
    for (const bool refresh : {false, true}) {
      Simulation<M, AnyStepping> simulation{rod_chain<M, NormalisedDistance>({.links = 5, .angle = 1}),
                                            cured_by(SoftConstraints{.refresh = refresh}, solver)};
      for (int i = 0; i < 20; ++i) simulation.step(time_step);
      const auto& bodies = simulation.scene.bodies();
      EXPECT_LE(residual(simulation.work.system, bodies.velocity), 1e-9);
      double largest = 0;
      for (const auto& rod : simulation.scene.all<NormalisedDistance>()) {
        const auto J = rod.jacobian(bodies.pose[rod.at.body1], bodies.pose[rod.at.body2]);
        largest =
            std::max(largest, std::abs(dot(J, bodies.velocity[rod.at.body1], bodies.velocity[rod.at.body2])[0]));
      }
      EXPECT_EQ(largest <= 1e-9, refresh) << "tangent to where the bodies are now";
    }
}

/// How far the angle of a bob on a circle, without weight, is behind after 10 s [rad].
double lag(bool refresh) {
  const double speed = 1;
  auto scene = pendulum<M, NormalisedDistance>(0, 1, 1);
  scene.gravity.setZero();
  scene.state().velocity[1].x() = speed;
  Simulation<M, AnyStepping> simulation{scene, cured_by(SoftConstraints{.refresh = refresh}, GaussSeidel{1}, 4)};
  double angle = 0;
  for (int i = 0; i < 600; ++i) {
    const Linear<M> before = simulation.scene.bodies().pose[1].position;
    simulation.step(time_step);
    const Linear<M> after = simulation.scene.bodies().pose[1].position;
    angle += std::asin(cross(before, after)[0] / (before.norm() * after.norm()));
  }
  return 10 * speed - angle;
}

TEST(LawB14, RowsWrittenAnewBeforeTheyRelaxCutTheLagOfATurningRod) {
  EXPECT_GT(lag(false), 0.05);
  EXPECT_GT(lag(false), 30 * std::abs(lag(true)));
}

const DriftCure cures[] = {NoDriftCure{},
                           Baumgarte{0.05},
                           Projection{},
                           SplitImpulse{},
                           SoftConstraints{},
                           SoftConstraints{.refresh = false},
                           SoftConstraints{.relax = false}};

TEST(Cures, KeepMomentumAndBoundsInSubstepsOfOneSweep) {
  const AnyRowSolver solvers[] = {GaussSeidel{1},     GaussSeidel{1, true, SweepOrder::symmetric},
                                  Direct{},           ConjugateGradients{5},
                                  ConjugateSweeps{2}, AcceleratedGradient{2}};
  for (const DriftCure& cure : cures)
    for (const AnyRowSolver& solver : solvers) {
      Random random;
      Rods free = hanging(6);
      free.gravity.setZero();
      free.set_mass(0, with_mass<M>(2));
      free = with_random_velocities(free, random);
      const Linear<M> before = linear_momentum(free.bodies());
      Simulation<M, AnyStepping> simulation{free, cured_by(cure, solver, 8)};
      for (int i = 0; i < 300; ++i) {
        simulation.step(time_step);
        ASSERT_LE((linear_momentum(simulation.scene.bodies()) - before).norm(), 1e-10)
            << "cure " << cure.index() << ", solver " << solver.index();
        if (cure.index() != 0) {
          ASSERT_LE(position_error(simulation).max, 0.5)
              << "cure " << cure.index() << ", solver " << solver.index();
        }
      }
    }
}

TEST(Cures, HoldAStackOfThree) {
  for (const DriftCure& cure : cures) {
    Simulation<PlaneBody, AnyStepping> simulation{stack(3), cured_by(cure, GaussSeidel{4}, 4)};
    for (int i = 0; i < 300; ++i) simulation.step(time_step);
    EXPECT_LE(position_error(simulation).max, 0.01) << cure.index();
    EXPECT_NEAR(simulation.scene.bodies().pose[3].position.y(), 2.5, 0.02) << cure.index();
    EXPECT_LE(simulation.scene.bodies().velocity[3].norm(), 1e-3) << cure.index();
  }
}

TEST(Cures, LeaveMotorsAndSpringsTheirOwn) {
  Scene<M> scene;
  scene.add_body({0, 0}, fixed<M>());
  scene.add_body({0, -1.2}, with_mass<M>(2));
  scene.add(Spring<M>{{0, 1}, 1, {50, 3}});
  Simulation<M, AnyStepping> none{scene, cured_by(NoDriftCure{})};
  auto split = none, soft = none;
  split.method.drift = SplitImpulse{};
  soft.method.drift = SoftConstraints{};
  for (int i = 0; i < 100; ++i) {
    none.step(time_step);
    split.step(time_step);
    soft.step(time_step);
    EXPECT_NEAR(split.scene.bodies().pose[1].position.y(), none.scene.bodies().pose[1].position.y(), 1e-12);
    EXPECT_NEAR(soft.scene.bodies().pose[1].position.y(), none.scene.bodies().pose[1].position.y(), 1e-12);
  }
}

}  // namespace cures_test
