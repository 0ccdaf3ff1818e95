#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lessons/methods/equalities.hpp"
#include "lessons/scenes/chain.hpp"
#include "lessons/scenes/pendulum.hpp"
#include "lessons/scenes/top.hpp"
#include "solver/constraints/contact.hpp"
#include "solver/constraints/spring.hpp"
#include "tests/solver/law_motion.hpp"

// What is asked alike of all methods for scenes of equalities.
namespace byhand {

/// Two particles on a rod, thrown turning, without gravity.
template <class Method>
auto thrown_pair(const Method& method) {
  Scene<PlaneParticle> scene;
  scene.gravity.setZero();
  scene.add_body(Eigen::Vector2d(0, 0), with_mass<PlaneParticle>(1), {1, -2});
  scene.add_body(Eigen::Vector2d(2, 0), with_mass<PlaneParticle>(3), {1, 3});
  scene.add(Distance<PlaneParticle>{{0, 1}, 2});
  return Simulation<PlaneParticle, Method>{scene, method};
}

/// A top that nutates.
inline Scene<SpaceBody> leaning_top() {
  const HeavyTop top{.mass = 2, .arm = 0.3, .moment_along = 0.08, .moment_across = 0.25, .spin = 40};
  return spinning_top(top, 0.7, 0);
}

/// How far from its beginning a scene ends that runs for two seconds, has its velocities turned round and runs as
/// long again [m].
template <class M, class Method>
double way_back(const Scene<M>& scene, const Method& method) {
  Simulation simulation{scene, method};
  run(simulation, 2, 1.0 / 100);
  for (auto& V : simulation.scene.state().velocity) V = -V;
  run(simulation, 2, 1.0 / 100);
  double farthest = 0;
  for (int i = 0; i < scene.bodies().size(); ++i)
    farthest =
        std::max(farthest, (simulation.scene.bodies().pose[i].position - scene.bodies().pose[i].position).norm());
  return farthest;
}
template <class M, class Method>
void expect_reversible(const Scene<M>& scene, const Method& method) {
  EXPECT_LT(way_back(scene, method), 1e-10);
}

/// Of rods C is an area, of pins a length; a body that turns has rates in rad/s beside those in m/s.
template <class Method>
void expect_same_at_any_length_of_rods_and_pins(const Method& method) {
  const auto same = [&](double) { return method; };
  expect_same_at_any_length(
      [](double a) { return rod_chain<PlaneParticle>({.links = 3, .length = a, .angle = 1}); }, same);
  expect_same_at_any_length(
      [](double a) { return pinned_chain<SpaceBody>({.links = 3, .length = a, .angle = 1}); }, same);
}

/// The step throws, and moves nothing.
template <class Error, class M, class Method>
void expect_thrown(const Scene<M>& scene, const Method& method, double step, const std::string& words) {
  Simulation simulation{scene, method};
  try {
    simulation.step(step);
    ADD_FAILURE() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(words));
  }
  EXPECT_EQ(simulation.scene.bodies().velocity, scene.bodies().velocity);
  for (int i = 0; i < scene.bodies().size(); ++i)
    EXPECT_EQ(simulation.scene.bodies().pose[i].position, scene.bodies().pose[i].position);
}
template <class M, class Method>
void expect_no_convergence(const Scene<M>& scene, const Method& method, double step) {
  expect_thrown<NoConvergence>(scene, method, step, "take a smaller step");
}
template <class Method>
void expect_invalid(const Method& method, const std::string& words) {
  expect_thrown<std::invalid_argument>(pendulum<PlaneParticle>(1, 2, 3), method, 0.01, words);
}

/// A rod that is there twice.
template <class Method>
void expect_singular(Method method) {
  auto scene = pendulum<PlaneParticle>(1, 2, 3);
  scene.add(Distance<PlaneParticle>{{0, 1}, 2});
  expect_thrown<SingularSystem>(scene, method, 0.01, "repeats");
  method.regularisation = 1e-9;  // decides: either carries its half
  Simulation<PlaneParticle, Method> simulation{scene, method};
  simulation.step(0.01);
  const auto& lambda = simulation.work.system.lambda;
  EXPECT_LT(lambda[0], 0);
  EXPECT_NEAR(lambda[1] / lambda[0], 1, 1e-6);
}

template <class Method>
void expect_refusals(const Method& method) {
  using M = PlaneParticle;
  const auto refused = [&](auto add, const std::string& words) {
    Scene<M> scene;
    scene.add_body(Linear<M>(0, 0), fixed<M>());
    scene.add_body(Linear<M>(2, 0), with_mass<M>(3));
    scene.add(Distance<M>{{0, 1}, 2});
    EXPECT_EQ(refusal(scene, method), "");
    add(scene);
    EXPECT_THAT(refusal(scene, method), testing::HasSubstr(words));
    expect_thrown<std::invalid_argument>(scene, method, 0.01, words);
  };
  refused([](auto& scene) { scene.add(Contact<M>{{0, 1}, Linear<M>::Unit(1)}); }, "constraint 1 is bounded");
  refused([](auto& scene) { scene.add(Spring<M>{{0, 1}, 2, {10, 1}}); }, "constraint 1 is a spring");
  refused(
      [](auto& scene) {
        scene.add(Distance<M>{{0, 1}, 2, 0.5});
      },
      "constraint 1 is soft: it gives way by 0.5");
  for (const double step : {0.0, -1.0, std::nan("")})
    expect_thrown<std::invalid_argument>(pendulum<M>(1, 2, 3), method, step, "time step is");
}

}  // namespace byhand
