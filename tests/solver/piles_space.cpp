#include <gtest/gtest.h>

#include "lessons/scenes/box_pile.hpp"
#include "tests/solver/law_motion.hpp"

// Random piles in space. See piles.cpp for the plane, where energy can be told to the last step: in space a
// spinning box whose gyroscopic moments are left out changes its energy by itself.
namespace {

using namespace byhand;
using M = SpaceBody;
using Points = Scene<M>;
constexpr double h = 1.0 / 60;

TEST(PilesInSpace, HaveNoNumberThatIsNoneAndComeToRest) {
  for (int seed = 1; seed <= 12; ++seed)
    for (const RowSolver& solver : {RowSolver(GaussSeidel{}), RowSolver(ByGraph{})}) {
      Simulation<Points> simulation{box_pile<Points>(seed, {.count = 8}), {solver}};
      simulation.method.drift = Baumgarte{.slop = 0.002, .speed_cap = 3};
      simulation.method.gyroscopic = Gyroscopic::implicit;
      const double first = energy(simulation.scene);
      run(simulation, 1.5, h, [&] {
        for (int i = 0; i < simulation.scene.bodies().size(); ++i) {
          ASSERT_TRUE(simulation.scene.bodies().velocity[i].allFinite()) << "seed " << seed;
          ASSERT_TRUE(simulation.scene.bodies().pose[i].position.allFinite()) << "seed " << seed;
        }
        // The correction's share: what overlaps at first is pushed out at 3 m/s at most.
        ASSERT_LE(energy(simulation.scene), 1.5 * first) << "seed " << seed;
      });
    }
}

TEST(PilesInSpace, KeepEveryImpulseWithinItsBound) {
  PileOptions pile;
  pile.surface.restitution = 0;
  for (int seed = 13; seed <= 18; ++seed) {
    Simulation<Points> simulation{box_pile<Points>(seed, pile), {GaussSeidel{3}}};
    run(simulation, 1, h, [&] {
      const auto& system = simulation.work.system;
      for (const double lambda : system.lambda) ASSERT_TRUE(std::isfinite(lambda));
      for (const auto& contact : std::get<block_type<M, 1, Bound::interval>()>(system.blocks))
        EXPECT_GE(system.lambda[contact.row], 0);
      for (const auto& friction : std::get<block_type<M, 2, Bound::friction>()>(system.blocks)) {
        const double rubbing = std::hypot(system.lambda[friction.row], system.lambda[friction.row + 1]);
        EXPECT_LE(rubbing, 0.6 * system.lambda[friction.leader] + 1e-9);
      }
    });
  }
}

}  // namespace
