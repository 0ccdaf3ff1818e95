#include <gtest/gtest.h>

#include "lessons/scenes/box_pile.hpp"
#include "tests/solver/law_motion.hpp"

// Whatever is thrown together: no number that is none, impulses within their bounds, and no more energy than was
// put in.
namespace piles_test {

using namespace byhand;
constexpr double h = 1.0 / 60;

template <class M>
bool finite(const Scene<M>& scene) {
  for (const auto& V : scene.bodies().velocity)
    if (!V.allFinite()) return false;
  for (const auto& pose : scene.bodies().pose)
    if (!pose.position.allFinite()) return false;
  return true;
}

/// What overlapping rows may give in this step by their correction [J]: each pushes with its λ over the way -b h
/// that it is to open.
template <class M>
double allowance(const System<M>& system) {
  double sum = 0;
  for (int row = 0; row < system.rows(); ++row) sum += system.lambda[row] * std::max(0.0, -system.bias[row]);
  return sum;
}

/// The most energy [J] that any step of a pile makes beyond its allowance, as a share of what there was at first.
/// Of a step in parts only the last one's allowance is known.
template <class M>
double energy_made(const Scene<M>& pile, const VelocityStepping& method, int steps) {
  Simulation simulation{pile, method};
  const double first = energy(simulation.scene);
  double before = first, most = 0;
  for (int i = 0; i < steps; ++i) {
    simulation.step(h);
    EXPECT_TRUE(finite(simulation.scene)) << "step " << i;
    const double now = energy(simulation.scene);
    if (simulation.work.h == h) most = std::max(most, now - before - allowance(simulation.work.system));
    before = now;
  }
  return most / first;
}

const PileOptions dead{.surface = {.friction = 0.6, .restitution = 0}};

// From λ = 0 every sweep lowers ½λᵀAλ + λᵀ(JV + b), which is the energy made less the allowance. A warm start
// begins with last step's λ, which may be too much where a contact has turned: sweeps that stop early leave some
// of that.
TEST(Piles, MakeNoEnergyFromAColdStart) {
  for (int seed = 1; seed <= 20; ++seed)
    for (const DriftCure& cure : {DriftCure(NoDriftCure{}), DriftCure(Baumgarte{0.2})})
      EXPECT_LE(energy_made(box_pile<PlaneBody>(seed, dead), {GaussSeidel{10, false}, cure}, 100), 1e-12)
          << "seed " << seed;
}

TEST(Piles, MakeNoEnergyFromAWarmStartThatIsSweptToTheEnd) {
  PileOptions alike = dead;
  alike.decades = 0;
  for (int seed = 1; seed <= 10; ++seed)
    EXPECT_LE(energy_made(box_pile<PlaneBody>(seed, alike),
                          {GaussSeidel{.sweeps = 1000, .tolerance = 1e-12}, NoDriftCure{}}, 60),
              1e-6)
        << "seed " << seed;
}

// What such a step makes is chance: of 800 piles 10 make more than a twentieth.
TEST(Piles, SeldomMakeEnergyFromAWarmStartThatIsNot) {
  int often = 0;
  for (int seed = 1; seed <= 400; ++seed)
    for (const RowSolver& solver : {RowSolver(GaussSeidel{}), RowSolver(ByGraph{})}) {
      const double made = energy_made(box_pile<PlaneBody>(seed, dead), {solver, NoDriftCure{}}, 100);
      EXPECT_LE(made, 0.25) << "seed " << seed;
      often += made > 0.05;
    }
  EXPECT_LE(often, 16);
}

// Moreau's law reflects V⁻ in the cone of velocities that part, which it does not lengthen. With e = 1 nothing is
// lost either, so that what is not the law shows: gaps that contacts may close, and friction, which is left out.
TEST(Piles, GainNoEnergyByBouncing) {
  for (const auto& [e, friction, gain] : {std::array{0.0, 0.6, 1e-9}, {0.5, 0.6, 1e-9}, {1.0, 0.0, 0.01}})
    for (int seed = 1; seed <= 334; ++seed) {
      Simulation<PlaneBody> simulation{box_pile<PlaneBody>(seed, {.decades = 1, .surface = {friction, e}}),
                                       {.solver = GaussSeidel{.sweeps = 2000, .tolerance = 1e-10},
                                        .drift = NoDriftCure{},
                                        .bounce_threshold = 0.01}};
      const double first = energy_of_parabolas(simulation.scene, h);
      double most = first;
      run(simulation, 2, h, [&] { most = std::max(most, energy_of_parabolas(simulation.scene, h)); });
      EXPECT_LE(most, (1 + gain) * first) << "seed " << seed << ", e " << e;
    }
}

TEST(Piles, BounceAndSpinWithoutANumberThatIsNone) {
  for (int seed = 21; seed <= 30; ++seed)
    for (const RowSolver& solver : {RowSolver(GaussSeidel{}), RowSolver(ByGraph{}), RowSolver(Jacobi{})}) {
      Simulation<PlaneBody> simulation{
          by_points(box_pile<PlaneBody>(seed, {.speed = seed % 2 == 0 ? 10.0 : 100.0})), {solver}};
      simulation.method.substeps = 1 + seed % 3;
      try {
        run(simulation, 1, h);
        EXPECT_GT(simulation.work.row_solves, 300) << "they met";
      } catch (const NotFinite&) {  // Jacobi's sweeps of a pile grow
        EXPECT_TRUE(std::holds_alternative<Jacobi>(solver)) << "seed " << seed;
      }
      EXPECT_TRUE(finite(simulation.scene)) << "seed " << seed;
    }
}

// With friction there may be more than one answer; without it the velocities are unique, however many impulses
// make them. Without the lookahead, for boxes that press on each other all around have more rows than they can
// move.
TEST(Piles, WithoutFrictionAreSolvedDirectlyToWhereSweepsConverge) {
  for (int seed = 1; seed <= 8; ++seed)
    for (const double e : {0.0, 1.0}) {
      Scene<PlaneBody> pile = box_pile<PlaneBody>(seed, {.decades = 1, .surface = {0, e}});
      pile.set_margin(0.02, 0);
      Simulation<PlaneBody> swept{std::move(pile), {}};
      for (int i = 0; i < 30; ++i) {
        Simulation<PlaneBody> direct = swept, as_it_comes = swept;
        direct.method.solver = Direct{.rounds = 100, .tolerance = 1e-13};
        as_it_comes.method.solver = Direct{};
        swept.method.solver = GaussSeidel{.sweeps = 100000, .tolerance = 1e-13};
        direct.step(h);
        as_it_comes.step(h);
        swept.step(h);
        for (int body = 0; body < swept.scene.bodies().size(); ++body) {
          // Sweeps that end on a residual of 1e-13 of pushes of some m/s have as much over 1 - ρ left to go, and
          // of so few bodies ρ < 0.9999. As it comes the active set ends on 1e-10.
          const auto& V = swept.scene.bodies().velocity[body];
          ASSERT_LE((direct.scene.bodies().velocity[body] - V).norm(), 1e-9) << "seed " << seed << ", step " << i;
          ASSERT_LE((as_it_comes.scene.bodies().velocity[body] - V).norm(), 1e-6)
              << "seed " << seed << ", step " << i;
        }
      }
    }
}

TEST(Piles, KeepEveryImpulseWithinItsBound) {
  int pressing = 0;
  for (int seed = 31; seed <= 50; ++seed) {
    Simulation<PlaneBody> simulation{box_pile<PlaneBody>(seed, seed % 2 == 0 ? dead : PileOptions{}),
                                     {GaussSeidel{3}}};
    run(simulation, 2, h, [&] {
      const auto& system = simulation.work.system;
      for (const auto& face : std::get<block_type<PlaneBody, 3, Bound::manifold>()>(system.blocks)) {
        const double* lambda = &system.lambda[face.row];
        EXPECT_GE(lambda[0], 0);
        EXPECT_GE(lambda[1], 0);
        // What bounces has its λ forgotten, its friction not.
        if (system.restitution[face.row] == 0) {
          EXPECT_LE(std::abs(lambda[2]), 0.6 * (lambda[0] + lambda[1]) + 1e-9);
        }
        pressing += lambda[0] > 0;
      }
    });
  }
  EXPECT_GT(pressing, 1000) << "there was something to keep";
}

}  // namespace piles_test
