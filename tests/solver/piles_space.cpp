#include <gtest/gtest.h>

#include "lessons/scenes/box_pile.hpp"
#include "tests/solver/law_motion.hpp"

// Random piles in space. See piles.cpp for the plane, where energy can be told to the last step: in space a
// spinning box whose gyroscopic moments are left out changes its energy by itself.
namespace piles_space_test {

using namespace byhand;
using M = SpaceBody;
constexpr double h = 1.0 / 60;

// What the correction may give in a step is λ over the way that it opens its row, as in piles.cpp. Impacts and
// friction take more than all else gives: that the energy stays below its first value and the correction's share
// is a law, though no single step has to lose some.
// Restitution together with Coulomb's friction may make a little energy (Kane's paradox), friction alone does not.
// A row that bounces forgets its λ besides, so that what its correction gave is not counted here.
TEST(PilesInSpace, StayFiniteAndGainNoEnergy) {
  for (const auto& [e, gain] : {std::pair{0.0, 1e-12}, {0.5, 1e-3}})
    for (int seed = 1; seed <= 12; ++seed)
      for (const RowSolver& solver : {RowSolver(GaussSeidel{}), RowSolver(ByGraph{})}) {
        Simulation<M> simulation{box_pile<M>(seed, {.count = 8, .surface = {0.6, e}}), {solver}};
        simulation.method.drift = Baumgarte{.slop = 0.002, .speed_cap = 3};
        simulation.method.gyroscopic = Gyroscopic::implicit;
        double allowed = energy(simulation.scene);
        run(simulation, 1.5, h, [&, gain = gain] {
          for (int i = 0; i < simulation.scene.bodies().size(); ++i) {
            ASSERT_TRUE(simulation.scene.bodies().velocity[i].allFinite()) << "seed " << seed;
            ASSERT_TRUE(simulation.scene.bodies().pose[i].position.allFinite()) << "seed " << seed;
          }
          const auto& system = simulation.work.system;
          for (int row = 0; row < system.rows(); ++row)
            allowed += system.lambda[row] * std::max(0.0, -system.bias[row]);
          ASSERT_LE(energy(simulation.scene), (1 + gain) * allowed) << "seed " << seed;
        });
      }
}

// Balls roll on for ever, for nothing brakes a roll; boxes stop. Friction and impacts stop a box dead in a time
// that is short beside 15 s, and from there each step leaves a share of what the sweeps have left: rounding after
// a second.
TEST(PilesInSpace, ComeToRestAsFarAsTheyAreBoxes) {
  for (const int seed : {2, 5, 6})
    for (const RowSolver& solver : {RowSolver(GaussSeidel{}), RowSolver(ByGraph{})}) {
      Simulation<M> simulation{box_pile<M>(seed, {.count = 8, .decades = 0}), {solver}};
      simulation.method.drift = Baumgarte{.slop = 0.002, .speed_cap = 3};
      simulation.method.gyroscopic = Gyroscopic::implicit;
      run(simulation, 15, h);
      int boxes = 0;
      for (int i = 1; i < simulation.scene.bodies().size(); ++i) {
        if (!std::holds_alternative<Box<M>>(simulation.scene.colliders().shapes[i])) continue;
        EXPECT_LT(simulation.scene.bodies().velocity[i].norm(), 1e-9) << "seed " << seed << ", body " << i;
        ++boxes;
      }
      EXPECT_GE(boxes, 3);
    }
}

TEST(PilesInSpace, KeepEveryImpulseWithinItsBound) {
  PileOptions pile;
  pile.surface.restitution = 0;
  int pressing = 0, sliding = 0;
  for (int seed = 13; seed <= 18; ++seed) {
    Simulation<M> simulation{box_pile<M>(seed, pile), {GaussSeidel{3}}};
    run(simulation, 1, h, [&] {
      const auto& system = simulation.work.system;
      for (const double lambda : system.lambda) ASSERT_TRUE(std::isfinite(lambda));
      for (const auto& contact : std::get<block_type<M, 1, Bound::interval>()>(system.blocks)) {
        EXPECT_GE(system.lambda[contact.row], 0);
        pressing += system.lambda[contact.row] > 0;
      }
      for (const auto& friction : std::get<block_type<M, 2, Bound::friction>()>(system.blocks)) {
        const double rubbing = std::hypot(system.lambda[friction.row], system.lambda[friction.row + 1]);
        const double radius = 0.6 * system.lambda[friction.normal_row];
        EXPECT_LE(rubbing, radius + 1e-9);
        sliding += radius > 1e-6 && rubbing > 0.999 * radius;
      }
    });
  }
  // Six piles of ten bodies that fall for half a second and then bounce or lie: a point in every other step at
  // least.
  EXPECT_GT(pressing, 6 * 10 * 15) << "there was something to keep";
  EXPECT_GT(sliding, 100) << "friction came to its bound";
}

}  // namespace piles_space_test
