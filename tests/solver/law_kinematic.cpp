#include <gtest/gtest.h>

#include "lessons/exact/slider_crank.hpp"
#include "lessons/methods/generalised.hpp"
#include "lessons/methods/method.hpp"
#include "lessons/scenes/boxes.hpp"
#include "lessons/scenes/chain.hpp"
#include "lessons/scenes/slider_crank.hpp"
#include "solver/constraints/weld.hpp"
#include "tests/solver/law_motion.hpp"
#include "tests/solver/random.hpp"

// Kinematic bodies: a fixed body with a velocity keeps it, whatever leans on it.
namespace law_kinematic_test {

using namespace byhand;

constexpr double time_step = 1.0 / 60;

template <class F>
void with_velocity_stepping(F&& f) {
  for (const DriftCure& cure : {DriftCure(Baumgarte{.slop = 1e-3}), DriftCure(Projection{}),
                                DriftCure(SplitImpulse{}), DriftCure(SoftConstraints{})})
    for (const AnyRowSolver& solver : {AnyRowSolver(GaussSeidel{}), AnyRowSolver(Direct{.regularisation = 1e-9}),
                                       AnyRowSolver(ByGraph{}), AnyRowSolver(AcceleratedGradient{})}) {
      SCOPED_TRACE(testing::Message() << "cure " << cure.index() << ", solver " << solver.index());
      f(AnyStepping{solver, cure});
    }
}
template <class F>
void with_methods_of_contacts(F&& f) {
  with_velocity_stepping(f);
  f(Xpbd{});
  f(Avbd{});
}
template <class F>
void with_all_methods(F&& f) {
  f(AnyStepping{ConjugateGradients{}});
  with_methods_of_contacts(f);
  f(Rattle{});
  for (const Scheme scheme : {Scheme::explicit_euler, Scheme::rk4, Scheme::implicit_midpoint})
    f(Accelerations{scheme});
  for (const JointRule rule : {JointRule::semi_implicit_euler, JointRule::rk4}) f(Generalised{rule});
  f(Controlled<Rattle>{1e-3});
  f(Controlled<Generalised>{1e-6});
}

/// The same scene as someone sees it who moves with -`velocity` [m/s].
template <class M>
Scene<M> seen_in_motion(Scene<M> scene, const Linear<M>& velocity) {
  for (int i = 0; i < scene.bodies().size(); ++i) {
    Velocity<M> V = scene.bodies().velocity[i];
    V.template head<M::linear>() += velocity;
    scene.set_velocity(i, V);
  }
  return scene;
}

TEST_IN_ALL_MODELS(Galilei, AChainThatHangsFromAMovingPivotSwingsAsFromOneAtRest) {
  const Linear<M> velocity = random.vector<M::linear>(2);
  const auto check = [&](const Scene<M>& scene) {
    with_all_methods([&](const auto& method) {
      Simulation at_rest{scene, method}, moving{seen_in_motion(scene, velocity), method};
      for (int i = 1; i <= 60; ++i) {
        at_rest.step(time_step);
        moving.step(time_step);
        for (int body = 0; body < scene.bodies().size(); ++body) {
          const Linear<M> way =
              moving.scene.bodies().pose[body].position - at_rest.scene.bodies().pose[body].position;
          ASSERT_LT((way - i * time_step * velocity).norm(), 1e-8) << "body " << body << " in step " << i;
        }
      }
      EXPECT_EQ(moving.scene.bodies().velocity[0].template head<M::linear>(), velocity);
    });
  };
  check(rod_chain<M>({.links = 3, .angle = 1}));
  if constexpr (M::angular > 0) check(pinned_chain<M>({.links = 3, .angle = 1}));
}

TEST_IN_BOTH_BODIES(Crank, ABodyThatIsWeldedToATurningOneCirclesWithItAndPullsByItsCentripetalForce) {
  constexpr double omega = 2, radius = 1.5, mass = 3;
  Velocity<M> turning = Velocity<M>::Zero(), circling = Velocity<M>::Zero();
  turning[M::dof - 1] = circling[M::dof - 1] = omega;
  circling[1] = omega * radius;
  Scene<M> scene;
  scene.gravity.setZero();
  const int crank = scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>(), turning);
  const Linear<M> out = radius * Linear<M>::Unit(0);
  const int body = scene.add_body(out, box<M>(mass, Linear<M>(Linear<M>::Ones())), circling);
  const int held = scene.add(weld<M>(scene.bodies(), crank, body, out));
  const auto check = [&](const auto& method, double tolerance) {
    Simulation simulation{scene, method};
    run(simulation, 3, 1e-3, [&] {
      const auto [sin, cos] = sin_cos(omega * simulation.time);
      const Linear<M> place = radius * (cos * Linear<M>::Unit(0) + sin * Linear<M>::Unit(1));
      ASSERT_LT((simulation.scene.bodies().pose[body].position - place).norm(), tolerance);
      if (simulation.time < 0.1) return;  // a correction has to settle
      ASSERT_NEAR(simulation.reaction(held).force.norm() / (mass * omega * omega * radius), 1, 0.01);
    });
    EXPECT_EQ(simulation.scene.bodies().velocity[crank], turning);
  };
  for (const AnyRowSolver& solver :
       {AnyRowSolver(GaussSeidel{30}), AnyRowSolver(Direct{}), AnyRowSolver(ConjugateGradients{})})
    check(AnyStepping{solver}, 1e-4);
  check(Xpbd{.substeps = 2}, 1e-4);
  check(Avbd{}, 1e-4);
  check(Rattle{}, 1e-9);
  check(Accelerations{}, 1e-8);
  check(Accelerations{Scheme::implicit_midpoint}, 1e-4);
}

// What moves by itself is where it is at the time of each substep.
TEST_IN_BOTH_BODIES(Crank, OfAWheelThatTurnsSubstepsAreSteps) {
  Velocity<M> turning = Velocity<M>::Zero();
  turning[M::dof - 1] = 5;
  Scene<M> scene;
  const int wheel = scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>(), turning);
  const int bar = scene.add_body(Linear<M>(1.5 * Linear<M>::Unit(0)), random.mass<M>(), random.velocity<M>());
  scene.add(pin<M>(scene.bodies(), wheel, bar, Linear<M>(Linear<M>::Unit(0))));
  const auto check = [&](auto method) {
    Simulation whole{scene, method};
    method.substeps = 4;
    Simulation cut{scene, method};
    run(whole, 1, 1.0 / 256);
    run(cut, 1, 1.0 / 64);
    EXPECT_LT((whole.scene.bodies().pose[bar].position - cut.scene.bodies().pose[bar].position).norm(), 1e-12);
  };
  for (const JointRule rule : {JointRule::semi_implicit_euler, JointRule::rk4}) check(Generalised{rule});
  for (const Scheme scheme : {Scheme::explicit_euler, Scheme::rk4, Scheme::implicit_midpoint})
    check(Accelerations{scheme});
  check(Rattle{});
}

/// A slider-crank whose crank, body 1, is a wheel that turns steadily, with the rod pinned to it.
Scene<PlaneBody> turned_crank(const SliderCrankOptions& options) {
  using M = PlaneBody;
  Scene<M> scene = slider_crank(options);
  scene.remove_body(1);
  const auto [sin, cos] = sin_cos(options.angle);
  const int wheel = scene.add_body(Linear<M>(0, 0), fixed<M>(), Velocity<M>(0, 0, options.speed));
  scene.add(pin<M>(scene.bodies(), wheel, 2, options.crank * Linear<M>(cos, sin)));
  return scene;
}

TEST(Crank, APistonFollowsItsClosedForm) {
  const SliderCrankOptions options{.angle = 0.3};
  const SliderCrank exact(options.crank, options.rod);
  const auto worst = [&](const auto& method, double h) {
    Simulation machine{turned_crank(options), method};
    double error = 0;
    run(machine, 2, h, [&] {
      const double angle = options.angle + options.speed * machine.time;
      error = std::max(error, std::abs(machine.scene.bodies().pose[3].position.x() - exact.position(angle)));
    });
    return error;
  };
  EXPECT_LT(worst(Rattle{}, 1.0 / 60), 1e-9) << "the crank's place is exact, and so is C = 0";
  const AnyStepping stepping{Direct{}, Baumgarte{1}};
  const double coarse = worst(stepping, 1.0 / 240), fine = worst(stepping, 1.0 / 480);
  EXPECT_LT(fine, 2e-4);
  EXPECT_NEAR(order(coarse, fine), 2, 0.2);
}

TEST(Crank, TurnedSteadilyMovesAPistonAsAMotorOfAnyStrengthDoes) {
  const SliderCrankOptions options{
      .piston_mass = 50, .strength = std::numeric_limits<double>::infinity(), .angle = 0.3};
  const AnyStepping method{Direct{}, Baumgarte{1}};
  Simulation turned{turned_crank(options), method}, driven{slider_crank(options), method};
  run(turned, 2, 1.0 / 480, [&] {
    driven.step(1.0 / 480);
    ASSERT_NEAR(turned.scene.bodies().pose[3].position.x(), driven.scene.bodies().pose[3].position.x(), 5e-4);
  });
}

/// A unit box of 2 kg on a platform that moves with `velocity`: body 0 the platform, body 1 the box.
template <class M>
Scene<M> carried(const Shape<M>& platform, const Velocity<M>& velocity, const Surface& surface = {}) {
  Scene<M> scene;
  const bool box = std::holds_alternative<Box<M>>(platform);
  scene.set_shape(scene.add_body(Linear<M>((box ? -0.5 : 0) * Linear<M>::Unit(1)), fixed<M>(), velocity), platform,
                  surface);
  add_unit_box(scene, 0, 0.5, 2, surface);
  return scene;
}
template <class M>
std::array<Shape<M>, 2> platforms() {
  Linear<M> sides = Linear<M>::Constant(40);
  sides.y() = 1;
  return {Box<M>{sides}, HalfSpace<M>{Linear<M>::Unit(1)}};
}

TEST_IN_BOTH_BODIES(Lift, ABoxStandsOnItAndPressesWithItsWeight) {
  for (const auto& platform : platforms<M>())
    for (const double speed : {-3.0, 2.0})
      with_methods_of_contacts([&](const auto& method) {
        Simulation simulation{carried<M>(platform, speed * Velocity<M>::Unit(1)), method};
        simulation.scene.set_velocity(1, speed * Velocity<M>::Unit(1));
        run(simulation, 2, time_step);
        const Bodies<M>& bodies = simulation.scene.bodies();
        EXPECT_NEAR(bodies.pose[1].position.y() - 2 * speed, 0.5, 2e-3);
        EXPECT_NEAR(bodies.velocity[1][1], speed, 1e-3);
        EXPECT_EQ(bodies.velocity[0][1], speed);
        double push = 0;
        for (const Touch<M>& touch : simulation.touches()) push += touch.impulse.y() / simulation.work.h;
        EXPECT_NEAR(push, 2 * 9.81, 2e-3 * 2 * 9.81);
      });
}

TEST_IN_BOTH_BODIES(Lift, ThatSlowsDownByMoreThanGLetsGoOfABox) {
  constexpr double g = 9.81, speed = 5;
  for (const double share : {0.5, 0.999, 1.001, 1.5}) {
    Velocity<M> V = speed * Velocity<M>::Unit(1);
    Simulation<M, AnyStepping> simulation{carried<M>(platforms<M>()[0], V),
                                          {GaussSeidel{.sweeps = 200, .tolerance = 1e-14}}};
    simulation.scene.set_velocity(1, V);
    const auto& pose = simulation.scene.bodies().pose;
    for (int i = 1; i <= 30; ++i) {
      V[1] -= share * g * time_step;
      simulation.scene.set_velocity(0, V);
      simulation.step(time_step);
      double push = 0;
      for (const Touch<M>& touch : simulation.touches()) push += touch.impulse.y() / time_step;
      EXPECT_NEAR(push, 2 * g * std::max(0.0, 1 - share), 1e-6) << share << " of g, step " << i;
    }
    const double t = 30 * time_step, gap = 0.5 * std::max(0.0, share - 1) * g * t * (t + time_step);
    EXPECT_NEAR(pose[1].position.y() - pose[0].position.y() - 1, gap, 1e-8) << share << " of g";
  }
}

TEST(Turntable, CarriesABoxUpToTheRadiusOfFriction) {
  using M = SpaceBody;
  constexpr double mu = 0.3, g = 9.81, omega = 2, limit = mu * g / (omega * omega);
  for (const double share : {0.5, 0.95, 1.05, 1.5}) {
    const Angular<M> turning(0, omega, 0);
    Velocity<M> V = omega * Velocity<M>::Unit(4);
    Scene<M> scene = carried<M>(HalfSpace<M>{Linear<M>::Unit(1)}, V, {.friction = mu});
    scene.set_shape(1, Box<M>{{0.1, 0.02, 0.1}}, {.friction = mu});
    scene.set_mass(1, box<M>(2, Linear<M>(0.1, 0.02, 0.1)));
    scene.set_position(1, {share * limit, 0.01, 0});
    V.head<3>() = turning.cross(scene.bodies().pose[1].position);
    scene.set_velocity(1, V);
    Simulation<M, AnyStepping> simulation{scene, {GaussSeidel{.sweeps = 300, .tolerance = 1e-14}}};
    Linear<M> slip = Linear<M>::Zero();
    for (int i = 0; i < 3; ++i) {  // the first step needs no force: its velocity is right
      const Linear<M> at = simulation.scene.bodies().pose[1].position;
      simulation.step(time_step);
      slip = simulation.scene.bodies().velocity[1].head<3>() - turning.cross(at);
    }
    EXPECT_NEAR(std::hypot(slip.x(), slip.z()) / (mu * g * time_step), 2 * std::max(0.0, share - 1),
                share < 1 ? 1e-3 : 0.1 * (share - 1))
        << share << " of the radius";
  }
}

TEST_IN_BOTH_BODIES(Platform, ThatSetsOffDragsABoxByFrictionUntilBothAreEquallyFast) {
  constexpr double mu = 0.4, g = 9.81, speed = 3;
  for (const auto& platform : platforms<M>())
    with_methods_of_contacts([&](const auto& method) {
      Simulation simulation{carried<M>(platform, speed * Velocity<M>::Unit(0), {.friction = mu}), method};
      run(simulation, 2, time_step, [&] {
        const double exact = std::min(mu * g * simulation.time, speed);
        ASSERT_NEAR(simulation.scene.bodies().velocity[1][0], exact, 0.05 * speed)
            << "after " << simulation.time << " s";
      });
      EXPECT_NEAR(simulation.scene.bodies().velocity[1][0] / speed, 1, 1e-3);
      EXPECT_NEAR(simulation.scene.bodies().pose[0].position.x(), 2 * speed, 1e-9);
      EXPECT_NEAR(simulation.scene.bodies().pose[1].position.x(), 2 * speed - speed * speed / (2 * mu * g), 0.05);
    });
}

TEST(Platform, ThatSpeedsUpCarriesABoxUpToTheAccelerationOfFriction) {
  using M = PlaneBody;
  constexpr double mu = 0.4, g = 9.81;
  for (const double share : {0.5, 0.99, 1.01, 2.0}) {
    Simulation<M, AnyStepping> simulation{carried<M>(platforms<M>()[0], Velocity<M>::Zero(), {.friction = mu})};
    run(simulation, 1, time_step,
        [&] { simulation.scene.set_velocity(0, share * mu * g * simulation.time * Velocity<M>::Unit(0)); });
    const double last = share * mu * g * (simulation.time - time_step),
                 velocity = simulation.scene.bodies().velocity[1][0];
    EXPECT_NEAR(velocity, std::min(last, mu * g * (simulation.time - time_step)), 1e-3) << share << " of μg";
  }
}

TEST_IN_BOTH_BODIES(Paddle, ThrowsABallBackWithTwiceItsOwnSpeedBesides) {
  const auto check = [](const auto& method) {
    Scene<M> scene;
    scene.gravity.setZero();
    const Surface hard{.friction = 0, .restitution = 1};
    const int paddle = scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>(), 2 * Velocity<M>::Unit(0));
    scene.set_shape(paddle, Box<M>{Linear<M>::Ones()}, hard);
    const int it = scene.add_body(Linear<M>(3 * Linear<M>::Unit(0)), ball<M>(1, 0.1), -Velocity<M>::Unit(0));
    scene.set_shape(it, Ball<M>{0.1}, hard);
    Simulation simulation{scene, method};
    run(simulation, 2, time_step);
    EXPECT_NEAR(simulation.scene.bodies().velocity[it][0], 5, 1e-9);
    EXPECT_EQ(simulation.scene.bodies().velocity[paddle][0], 2);
    EXPECT_NEAR(kinetic_energy(simulation.scene.bodies()), 12.5, 1e-8) << "of the ball alone";
  };
  check(AnyStepping{});
  check(AnyStepping{GaussSeidel{}});
  check(Xpbd{});
  check(Avbd{});
}

}  // namespace law_kinematic_test
