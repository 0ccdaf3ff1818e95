#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lessons/methods/method.hpp"
#include "lessons/scenes/chain.hpp"
#include "tests/solver/law_motion.hpp"
#include "tests/solver/random.hpp"

// Damping v' = -cv and gravity of each body's own: against their closed forms, alike in every method.
namespace law_damping_test {

using namespace byhand;
using testing::AllOf, testing::HasSubstr, testing::StartsWith, testing::ThrowsMessage;

constexpr double time_step = 1.0 / 60, g = 9.81;

/// All methods but `Accelerations`, which integrate free bodies exactly.
template <class F>
void with_exact_methods(F&& f) {
  f(VelocityStepping{});
  f(VelocityStepping{.substeps = 3});
  f(VelocityStepping{GaussSeidel{}, SplitImpulse{}});
  f(VelocityStepping{GaussSeidel{}, SoftConstraints{}});
  f(Xpbd{});
  f(Avbd{});
  f(Rattle{});
}
template <class F>
void with_all_methods(F&& f) {
  with_exact_methods(f);
  f(Accelerations{});
  f(Accelerations{Scheme::implicit_midpoint});
}

TEST(MeanDecay, IsThatOfTheExponential) {
  for (double x = 1e-20; x < 1e20; x *= 1.01) EXPECT_NEAR(mean_decay(x) * x / -std::expm1(-x), 1, 1e-15) << x;
  for (const double limit : {1.0 / 16, 64.0})
    for (const double x : {std::nextafter(limit, 0.0), limit, std::nextafter(limit, 1e9)})
      EXPECT_NEAR(mean_decay(x) * x / -std::expm1(-x), 1, 1e-15) << x;
  EXPECT_EQ(mean_decay(0), 1);
}

/// One free body with a velocity.
template <class M>
Scene<M> thrown(const Velocity<M>& velocity, double gravity) {
  Scene<M> scene;
  scene.gravity = -gravity * Linear<M>::Unit(1);
  InverseMass<M> mass;
  if constexpr (M::angular == 0)
    mass = with_mass<M>(2);
  else
    mass = ball<M>(2, 0.3);
  scene.add_body(Linear<M>(Linear<M>::Zero()), mass, velocity);
  return scene;
}

TEST_IN_ALL_MODELS(Damping, SlowsAFreeBodyExponentially) {
  const Velocity<M> V = random.velocity<M>();
  const auto worst = [&](const auto& method, double linear, double angular) {
    Simulation simulation{thrown<M>(V, 0), method};
    simulation.scene.set_damping(0, linear, angular);
    double error = 0;
    run(simulation, 1, time_step, [&] {
      Velocity<M> exact = V;
      exact.template head<M::linear>() *= std::exp(-linear * simulation.time);
      exact.template tail<M::angular>() *= std::exp(-angular * simulation.time);
      error = std::max(error, (simulation.scene.bodies().velocity[0] - exact).norm());
    });
    return error;
  };
  for (const auto& [linear, angular] : {std::pair(0.3, 2.0), {5.0, 0.0}, {0.0, 20.0}}) {
    with_exact_methods([&, linear = linear, angular = angular](const auto& method) {
      EXPECT_LT(worst(method, linear, angular), 1e-11);
    });
    const double share = std::max(linear, angular) * time_step;  // ch
    EXPECT_LT(worst(Accelerations{}, linear, angular), V.norm() * std::pow(share, 4) / 120);
    EXPECT_LT(worst(Accelerations{Scheme::implicit_midpoint}, linear, angular), V.norm() * share * share / 12);
  }
}

TEST_IN_ALL_MODELS(Damping, IsStableHoweverStrongItIs) {
  const Velocity<M> V = random.velocity<M>();
  for (double share = 1e-3; share <= 1e6; share *= 10)
    with_exact_methods([&](const auto& method) {
      Simulation simulation{thrown<M>(V, 0), method};
      simulation.scene.set_damping(0, share / time_step, share / time_step);
      for (int i = 0; i < 20; ++i) {
        const Velocity<M> before = simulation.scene.bodies().velocity[0];
        simulation.step(time_step);
        const Velocity<M> now = simulation.scene.bodies().velocity[0];
        ASSERT_LE(now.norm(), before.norm() * (1 + 1e-12) + 1e-12) << "ch = " << share;
        ASSERT_GE(now.dot(before), -1e-12) << "it does not turn round";
      }
    });
}

// A step damps what it finds and then adds gh: the speed tends to gh/(1 - exp(-ch)), which is g/c to the first
// order of ch, and gh where ch is large. RATTLE does both in two halves.
TEST_IN_ALL_MODELS(Damping, LeadsToTheTerminalSpeed) {
  constexpr double half = 0.5;  // of gravity
  for (const double rate : {2.0, 50.0, 6e5}) {
    const auto terminal = [&](const auto& method) {
      Simulation simulation{thrown<M>(Velocity<M>::Zero(), g), method};
      simulation.scene.set_damping(0, rate);
      simulation.scene.set_gravity_scale(0, half);
      run(simulation, 20, time_step);
      return -simulation.scene.bodies().velocity[0][1];
    };
    EXPECT_NEAR(terminal(VelocityStepping{}) * -std::expm1(-rate * time_step) / (half * g * time_step), 1, 1e-9);
    with_exact_methods([&](const auto& method) {
      EXPECT_GE(terminal(method), half * g / rate * (1 - 1e-6));
      EXPECT_LE(terminal(method), half * g * (1 / rate + time_step) * (1 + 1e-6));
    });
    if (rate * time_step > 1) continue;
    EXPECT_NEAR(terminal(Accelerations{}) * rate / (half * g), 1, 1e-6);
  }
}

TEST_IN_ALL_MODELS(Damping, LeavesAHangingBodyItsWeight) {
  with_all_methods([](const auto& method) {
    Simulation simulation{pendulum<M>(0, 1, 2), method};
    simulation.scene.set_damping(1, 7);
    run(simulation, 1, time_step);
    const double weight = g / simulation.scene.bodies().inverse_mass[1].linear;
    EXPECT_NEAR(simulation.reaction(0).force.norm(), weight, 1e-3 * weight);
  });
}

// θ'' + cθ' + (g/L)θ = 0.
TEST_IN_ALL_MODELS(Damping, OfAPendulumIsThatOfALinearOscillator) {
  constexpr double rate = 1, small = 1e-3, h = 1e-3;
  const double omega = std::sqrt(g - rate * rate / 4);
  with_all_methods([&](const auto& method) {
    Simulation simulation{pendulum<M>(small, 1, 2), method};
    simulation.scene.set_damping(1, rate);
    run(simulation, 3, h);
    const double t = 3, exact = small * std::exp(-rate * t / 2) *
                                (std::cos(omega * t) + rate / (2 * omega) * std::sin(omega * t));
    EXPECT_NEAR(rod_angle(simulation.scene, 0, 1), exact, 0.02 * small);
  });
}

TEST_IN_ALL_MODELS(GravityScale, OfAllBodiesIsThatOfTheScene) {
  with_all_methods([]<class Method>(const Method& method) {
    const Scene<M> scene = rod_chain<M>({.links = 4, .angle = 1});
    for (const double scale : {-1.0, 0.0, 0.25}) {
      Simulation own{scene, method}, whole{scene, method};
      for (int i = 0; i <= 4; ++i) own.scene.set_gravity_scale(i, scale);
      whole.scene.gravity *= scale;
      EXPECT_NEAR(energy(own.scene), energy(whole.scene), 1e-12);
      run(own, 1, time_step, [&] {
        whole.step(time_step);
        for (int i = 0; i <= 4; ++i)
          ASSERT_EQ(own.scene.bodies().pose[i].position, whole.scene.bodies().pose[i].position);
      });
    }
  });
}

TEST(OwnForces, AreForgottenWithABodyAndKeptByCopies) {
  using M = PlaneParticle;
  Scene<M> scene;
  for (int i = 0; i < 3; ++i) scene.add_body({0, 0}, with_mass<M>(1));
  EXPECT_TRUE(scene.bodies().forces.empty()) << "no memory for what none has";
  scene.set_damping(1, 3);
  scene.set_gravity_scale(2, 0.5);
  scene.remove_body(1);
  ASSERT_EQ(scene.add_body({0, 0}, with_mass<M>(1)), 1);
  ASSERT_EQ(scene.add_body({0, 0}, with_mass<M>(1)), 3);
  const auto falls = [](Scene<M> it, int body, double scale) {
    Simulation simulation{std::move(it), VelocityStepping{}};
    simulation.step(time_step);
    EXPECT_DOUBLE_EQ(simulation.scene.bodies().velocity[body].y(), -scale * g * time_step) << "body " << body;
  };
  for (const int body : {0, 1, 3}) falls(scene, body, 1);
  falls(scene, 2, 0.5);
}

TEST(OwnForces, OutsideOfTheirRangeAreRefused) {
  using M = SpaceBody;
  Simulation simulation{thrown<M>(Velocity<M>::Zero(), g), Accelerations{}};
  Scene<M>& scene = simulation.scene;
  const auto refuses = [](auto&& call, const std::string& start, const std::string& allowed) {
    EXPECT_THAT(call, ThrowsMessage<std::invalid_argument>(AllOf(StartsWith(start), HasSubstr(allowed))));
  };
  refuses([&] { scene.set_damping(0, -1); }, "linear damping is -1", "between 0 and");
  refuses([&] { scene.set_damping(0, 0, std::nan("")); }, "angular damping is nan", "");
  refuses([&] { scene.set_gravity_scale(0, std::nan("")); }, "gravity scale is nan", "a finite number");
  refuses([&] { scene.set_damping(1, 1); }, "body index is 1", "");
  EXPECT_TRUE(scene.bodies().forces.empty());
  scene.set_damping(0, 0, 0.99 / time_step);
  EXPECT_NO_THROW(simulation.step(time_step));
  scene.set_damping(0, 1.01 / time_step);
  refuses([&] { simulation.step(time_step); }, "damping in a substep is 1.01",
          "at most 1 for integration of accelerations");
  simulation.method.substeps = 2;
  EXPECT_NO_THROW(simulation.step(time_step));
}

}  // namespace law_damping_test
