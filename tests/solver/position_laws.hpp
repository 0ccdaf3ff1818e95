#pragma once

#include <numbers>

#include "lessons/exact/hanging_chain.hpp"
#include "lessons/scenes/chain.hpp"
#include "lessons/scenes/incline.hpp"
#include "solver/constraints/spring.hpp"
#include "tests/solver/allocations.hpp"
#include "tests/solver/random.hpp"
#include "tests/solver/swing.hpp"

// Laws that hold for each method on positions, whatever its choices.
namespace byhand {

/// λ/h of a constraint's rows [units of C's conjugate force].
template <class Work>
double reaction(const Work& work, int constraint, int row = 0) {
  return work.system.lambda[work.system.row_of[constraint] + row] / work.h;
}

/// A body hangs on a damped spring: it comes to rest mg/k below, and the spring pulls with mg.
template <class M, class Method>
void expect_static_sag(const Method& method, double h, double stiffness) {
  constexpr double g = 9.81, mass = 3;
  Simulation<M, Method> simulation{{}, method};
  auto& scene = simulation.scene;
  scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>());
  InverseMass<M> bob;
  if constexpr (M::angular == 0)
    bob = with_mass<M>(mass);
  else
    bob = ball<M>(mass, 0.1);
  scene.add_body(Linear<M>(-Linear<M>::Unit(1)), bob);
  const double damping = 2 * std::sqrt(stiffness * mass);  // critical
  scene.add(Spring<M>{{0, 1}, 1, {stiffness, damping}});
  run(simulation, 20, h);
  const double sag = -1 - scene.bodies().pose[1].position.y();
  EXPECT_NEAR(sag * stiffness / (mass * g), 1, 1e-9) << "h " << h << ", k " << stiffness;
  const double rounding = 10 * mass * 0x1p-53 / (simulation.work.h * simulation.work.h);  // of positions of 1 m
  EXPECT_NEAR(reaction(simulation.work, 0), -mass * g, 1e-9 + rounding);
}

/// Each rod of a chain at rest carries the weight below it, in units of it to `tolerance`.
template <class Method>
void expect_tensions(const Method& method, double tolerance) {
  using M = PlaneParticle;
  Simulation<M, Method> simulation{rod_chain<M, NormalisedDistance>({.links = 8, .mass = 2, .end_mass = 5}),
                                   method};
  run(simulation, 60, 1.0 / 60);
  const std::vector<double> tensions = hanging_chain_tensions(std::vector<double>{2, 2, 2, 2, 2, 2, 2, 5}, 9.81);
  for (int i = 0; i < 8; ++i)
    EXPECT_NEAR(-reaction(simulation.work, i) / tensions[i], 1, tolerance) << "rod " << i;
}

/// A box sticks below the angle of friction, but for a creep [m/s], and slides above it as fast as the formula
/// says.
template <class M, class Method>
void expect_friction_angle(const Method& method, double creep) {
  constexpr double g = 9.81, mu = 0.5, time = 5;
  for (const double share : {0.99, 1.1}) {
    const double angle = share * std::atan(mu);
    Simulation simulation{box_on_incline<M>(angle, mu), method};
    run(simulation, time, 1.0 / 60);
    const double speed = simulation.scene.bodies().velocity[1].template head<2>().norm();
    if (share < 1)
      EXPECT_LT(speed, creep);
    else
      EXPECT_NEAR(speed / (g * (std::sin(angle) - mu * std::cos(angle)) * time), 1, 0.01);
  }
}

/// A stack of boxes stands for 10 s with its top within `sunk` [m] of where it belongs, and the ground carries it.
template <class M, class Method>
void expect_standing_stack(const Method& method, int boxes, double sunk, double tolerance) {
  Simulation simulation{stack<M>(boxes), method};
  run(simulation, 10, 1.0 / 60);
  const auto& top = simulation.scene.bodies().pose[boxes].position;
  EXPECT_NEAR(top.y(), boxes - 0.5, sunk);
  EXPECT_NEAR(top.x(), 0, 1e-3);
  double carried = 0;
  for (const Touch<M>& touch : simulation.touches())
    if (touch.body1 == 0) carried += touch.impulse.dot(touch.normal) / simulation.work.h;
  EXPECT_NEAR(carried / (boxes * 9.81), 1, tolerance);
}

/// A ball that keeps half of its speed comes back to a quarter of its height, and again, as far as steps h are
/// short.
template <class Method>
void expect_bounces(const Method& method, double h) {
  Scene<PlaneBody> scene;
  add_ground(scene, {.restitution = 0.5});
  const int body = scene.add_body(Linear<PlaneBody>(0, 1.5), ball<PlaneBody>(2, 0.5));
  scene.set_shape(body, Ball<PlaneBody>{0.5}, {.restitution = 0.5});
  Simulation<PlaneBody, Method> simulation{scene, method};
  std::vector<double> peaks;
  double rising = 0;
  run(simulation, 1.6, h, [&] {
    const double speed = simulation.scene.bodies().velocity[body].y();
    if (rising > 0 && speed <= 0) peaks.push_back(simulation.scene.bodies().pose[body].position.y() - 0.5);
    rising = speed;
  });
  ASSERT_GE(peaks.size(), 2u);
  EXPECT_NEAR(peaks[0], 1.0 / 4, 0.01);
  EXPECT_NEAR(peaks[1], 1.0 / 16, 0.005);
}

/// Two balls that meet, neither of them fixed, keep momentum and part at half the speed; no push is left over.
template <class Method>
void expect_balls_bounce_off_each_other(const Method& method, double h, double tolerance) {
  for (const double fast : {3.0, -3.0}) {
    Scene<PlaneBody> scene;
    scene.gravity.setZero();
    for (const bool first : {true, false}) {
      const Linear<PlaneBody> at(first ? -fast / 3 : 0.3, 0);
      const int body = scene.add_body(at, ball<PlaneBody>(first ? 1 : 3, 0.5), {first ? fast : 0.2 * fast, 0, 0});
      scene.set_shape(body, Ball<PlaneBody>{0.5}, {.friction = 0, .restitution = 0.5});
    }
    Simulation<PlaneBody, Method> simulation{scene, method};
    run(simulation, 1, h, [&] {
      const auto& V = simulation.scene.bodies().velocity;
      ASSERT_NEAR(V[0].x() + 3 * V[1].x(), 1.6 * fast, tolerance);
      if (fast * (V[1].x() - V[0].x()) > 0) {
        for (const double lambda : simulation.work.system.lambda) ASSERT_EQ(lambda, 0);
      }
    });
    const auto& V = simulation.scene.bodies().velocity;
    EXPECT_NEAR((V[1].x() - V[0].x()) / fast, 0.4, tolerance);
  }
}

/// Nothing is allocated once a scene has been laid out.
template <class M, class Method>
void expect_no_allocation(const Scene<M>& scene, const Method& method) {
  Simulation simulation{scene, method};
  EXPECT_GT(allocations_in([&] { simulation.step(1.0 / 60); }), 0) << "the counter counts";
  for (int i = 0; i < 30; ++i) simulation.step(1.0 / 60);
  EXPECT_EQ(allocations_in([&] {
              for (int i = 0; i < 30; ++i) simulation.step(1.0 / 60);
            }),
            0);
}

}  // namespace byhand
