#include <gtest/gtest.h>

#include "lessons/scenes/boxes.hpp"
#include "lessons/scenes/bridge.hpp"
#include "lessons/scenes/ragdoll.hpp"
#include "tests/solver/law_motion.hpp"

namespace bridge_and_ragdoll_test {

using namespace byhand;
using M = PlaneBody;
constexpr double g = 9.81;

TEST(Bridge, EachAnchorCarriesHalfAndThePullIsTheSameAllAlong) {
  const BridgeOptions options{.planks = 12, .length = 0.5, .mass = 3};
  Simulation<M> simulation{bridge(options), {Direct{}, Baumgarte{0.2}}};
  EXPECT_LT(position_error(simulation.scene).max, 1e-14);
  // Only friction would bring it to rest: here what moves is taken away, a little in each step.
  run(simulation, 60, 1.0 / 60, [&] {
    for (auto& V : simulation.scene.state().velocity) V *= 0.95;
  });
  const double weight = options.planks * options.mass * g;
  EXPECT_NEAR(force(simulation.work, 0, 1), weight / 2, 1e-6 * weight);
  EXPECT_NEAR(force(simulation.work, options.planks, 1), -weight / 2, 1e-6 * weight);
  const double pull = force(simulation.work, 0, 0);
  EXPECT_LT(pull, 0);  // on the first plank, towards its anchor
  for (int i = 0; i <= options.planks; ++i) {
    EXPECT_NEAR(force(simulation.work, i, 0), pull, 1e-6 * weight);
    EXPECT_NEAR(force(simulation.work, i, 1), weight * (0.5 - static_cast<double>(i) / options.planks),
                1e-6 * weight);
  }
}

double largest_break(const Scene<M>& scene) {
  double largest = 0;
  for (const auto& limit : scene.all<Limit<M, Turn>>()) {
    const auto& poses = scene.bodies().pose;
    largest = std::max(largest, -limit.value<double>(poses[limit.at.body1], poses[limit.at.body2])[0]);
  }
  return largest;
}

TEST(Ragdoll, FallsOnAStairAndLiesThereWithinItsLimits) {
  Simulation<M> simulation{{}, {GaussSeidel{.sweeps = 60}, Baumgarte{.beta = 0.2, .slop = 1e-3, .speed_cap = 3}}};
  Scene<M>& scene = simulation.scene;
  add_ground(scene, {0.6});
  for (int i = 0; i < 4; ++i) {
    Pose<M> step;
    step.position = {0.3 * i, 0.1 * (3 - i)};
    const int body = scene.add_body(step, fixed<M>());
    scene.set_shape(body, Box<M>{{0.3, 2 * (0.1 * (3 - i) + 1e-3)}}, {0.6});
  }
  const int torso = add_ragdoll(scene, {0.2, 2.2});
  EXPECT_EQ(scene.bodies().size(), torso + ragdoll::parts);
  EXPECT_LT(position_error(scene).max, 1e-12);
  double mass = 0;
  for (int i = torso; i < scene.bodies().size(); ++i) mass += 1 / scene.bodies().inverse_mass[i].linear;
  EXPECT_NEAR(mass, 70, 1e-9);
  scene.state().velocity[torso] = {1, 0, -2};
  double worst = 0;
  run(simulation, 20, 1.0 / 120, [&] {
    worst = std::max(worst, largest_break(scene));
    for (const auto& V : scene.bodies().velocity) ASSERT_TRUE(V.allFinite());
  });
  EXPECT_LT(worst, 0.1);
  EXPECT_LT(largest_break(scene), 2e-3);
  EXPECT_LT(kinetic_energy(scene.bodies()), 1e-6);  // it lies
  for (int i = torso; i < scene.bodies().size(); ++i) EXPECT_GT(scene.bodies().pose[i].position.y(), 0);
}

}  // namespace bridge_and_ragdoll_test
