#include "solver/direct/semismooth_newton.hpp"

#include <gtest/gtest.h>

#include "lessons/scenes/box_pile.hpp"
#include "lessons/scenes/chain.hpp"
#include "solver/measure.hpp"
#include "solver/step.hpp"

// Contacts in space where sweeps stall, by the default method at 60 steps a second.
namespace byhand {
namespace semismooth_newton_test {

using M = SpaceBody;
constexpr double h = 1.0 / 60;
constexpr Surface rough{.friction = 0.6};

/// Cubes of these masses [kg], one on the other: each side is `growth` times that of the cube below, and each cube
/// lies off the axis by up to so much [m].
Scene<M> cubes(const std::vector<double>& masses, double off = 0, double growth = 1, Surface surface = rough) {
  Scene<M> scene;
  scene.set_shape(scene.add_body({0, 0, 0}, fixed<M>()), HalfSpace<M>{{0, 1, 0}}, surface);
  double height = 0, side = 1;
  for (std::size_t i = 0; i < masses.size(); ++i, side *= growth) {
    const Linear<M> sides = Linear<M>::Constant(side),
                    place(off * (i % 2), height + 0.5 * side, 0.7 * off * (i % 3));
    scene.set_shape(scene.add_body(place, box<M>(masses[i], sides)), Box<M>{sides}, surface);
    height += side;
  }
  return scene;
}

/// What a run has shown.
struct Seen {
  int unconverged = 0, rounds = 0;  // steps, and the most rounds of a step
  double moved = 0;                 // of a body, at the end [m]
  double speed = 0;                 // of a body, in the last quarter of the time [m/s]
};

template <class Method>
Seen seen(const Scene<M>& scene, const Method& method, double time) {
  Simulation<M, Method> simulation{scene, method};
  Seen result;
  const int steps = static_cast<int>(std::lround(time / h));
  for (int i = 0; i < steps; ++i) {
    simulation.step(h);
    result.unconverged += !simulation.work.solution.converged;
    const Solution& solution = simulation.work.solution;
    result.rounds = std::max(result.rounds, solution.rounds);
    // It goes on only where it costs no more than half of the sweeps; then ΔV becomes λ.
    EXPECT_LE(solution.row_solves, solution.rounds * (0.5 * 50 + 6) * simulation.work.system.rows());
    if (4 * i >= 3 * steps)
      for (const auto& V : simulation.scene.bodies().velocity) result.speed = std::max(result.speed, V.norm());
  }
  for (int i = 0; i < scene.bodies().size(); ++i)
    result.moved = std::max(result.moved,
                            (simulation.scene.bodies().pose[i].position - scene.bodies().pose[i].position).norm());
  return result;
}
Seen by_default(const Scene<M>& scene, double time) { return seen(scene, VelocityStepping{}, time); }

TEST(CubesOfUnlikeMass, DoNotSinkIntoEachOtherInEitherOrder) {
  for (const double ratio : {1.0, 49.0, 51.0, 1e2, 1e3, 1e4, 1e6})
    for (const auto& masses : {std::vector{1.0, ratio}, std::vector{ratio, 1.0}}) {
      const Seen run = by_default(cubes(masses), 10);
      EXPECT_LE(run.moved, 1e-6) << masses[0] << " kg below " << masses[1] << " kg";
      EXPECT_EQ(run.unconverged, 0) << masses[0] << " kg below " << masses[1] << " kg";
      EXPECT_LE(run.rounds, 20) << masses[0] << " kg below " << masses[1] << " kg";
    }
}

TEST(CubesOfUnlikeMass, StandAsATowerOffTheAxisOnWhatIsSlippery) {
  for (const double off : {0.0, 0.07, 0.14, 0.2, 0.3})
    for (const double friction : {0.2, 0.3, 0.6}) {
      const Seen run = by_default(cubes({1, 1e3, 1e6}, off, 1, {.friction = friction}), 5);
      EXPECT_LE(run.moved, 1e-5) << off << ' ' << friction;
      EXPECT_LE(run.unconverged, 2) << off << ' ' << friction;
    }
}

TEST(CubesOfUnlikeMass, SinkBySweepsAlone) {
  EXPECT_GT(seen(cubes({1, 1e4}), VelocityStepping{ConjugateSweeps{}, Baumgarte{.slop = 0.001}}, 2).moved, 0.5);
}

// With so few sweeps a factorisation does not pay.
TEST(CubesOfUnlikeMass, TakeTenTimesAsManySweepsWhereNewtonsMethodDoesNotPay) {
  for (const auto& [mass, sweeps] : {std::pair(2.0, 3), {1e3, 30}}) {
    Simulation<M> simulation{cubes({1, mass}), {ByGraph{.loops = {.sweeps = 3, .tolerance = 0}}, Baumgarte{}}};
    simulation.step(h);
    EXPECT_EQ(simulation.work.solution.passes, sweeps) << mass;
    EXPECT_EQ(simulation.work.solution.rounds, 0) << mass;
  }
}

// With a tolerance that 50 sweeps reach in every step.
TEST(CubesOfLikeMass, AreLeftToSweepsAndSoKeepTheirBits) {
  const ConjugateSweeps sweeps{.tolerance = 1e-5};
  const Baumgarte cure{.slop = 0.001};
  Simulation<M> chosen{cubes({1, 2}), {ByGraph{.loops = sweeps}, cure}};
  Simulation<M> swept{cubes({1, 2}), {sweeps, cure}};
  for (int i = 0; i < 120; ++i) {
    chosen.step(h);
    swept.step(h);
    ASSERT_EQ(chosen.work.solution.rounds, 0);
    for (int body = 0; body < 3; ++body)
      ASSERT_EQ(chosen.scene.bodies().velocity[body], swept.scene.bodies().velocity[body]);
  }
}

TEST(StacksInSpace, OfFifteenStaggeredCubesComeToRest) {
  const Seen run = by_default(cubes(std::vector(15, 1.0), 0.01), 20);
  EXPECT_LE(run.speed, 1e-9);
  EXPECT_EQ(run.unconverged, 0);
}

TEST(StacksInSpace, OfThirtyCubesStandAtOneStepAFrame) {
  const Seen run = by_default(cubes(std::vector(30, 1.0), 0.02), 20);
  EXPECT_LE(run.moved, 1e-6);
  EXPECT_LE(run.speed, 1e-8);
  EXPECT_EQ(run.unconverged, 0);
}

TEST(StacksInSpace, OfCubesThatGrowUpwardsStand) {
  std::vector<double> masses(1, 1.0);
  while (masses.size() < 8) masses.push_back(masses.back() * 1.5 * 1.5 * 1.5);
  const Seen run = by_default(cubes(masses, 0.01, 1.5), 20);
  EXPECT_LE(run.moved, 1e-6);
  EXPECT_EQ(run.unconverged, 0);
}

constexpr SemismoothNewton exact{.rounds = 1000, .tolerance = 1e-11};

TEST(SemismoothNewton, SolvesRowsWithoutBoundsAsADirectSolveDoes) {
  const Scene<PlaneBody> chain = pinned_chain<PlaneBody>({.links = 20, .angle = 1});
  Simulation<PlaneBody> newton{chain, {exact, Baumgarte{}}}, direct{chain, {Direct{}, Baumgarte{}}};
  for (int i = 0; i < 20; ++i) newton.step(h), direct.step(h);
  EXPECT_TRUE(newton.work.solution.converged);
  for (int i = 0; i < chain.bodies().size(); ++i)
    EXPECT_LE((newton.scene.bodies().velocity[i] - direct.scene.bodies().velocity[i]).norm(), 1e-9);
}

// The slip of a ball's lowest point v + ω × r keeps its direction while friction μ m g opposes it.
TEST(SemismoothNewton, FindsFrictionThatOpposesTheSlipOfASpinningBall) {
  Scene<M> scene = cubes({});
  Velocity<M> start;
  start << 2, 0, -1, 0.5, 7, 0.3;
  scene.set_shape(scene.add_body({0, 0.5, 0}, ball<M>(1, 0.5), start), Ball<M>{0.5}, rough);
  Simulation<M> simulation{scene, {exact, Baumgarte{.slop = 0.001}}};
  constexpr int steps = 6;
  for (int i = 0; i < steps; ++i) simulation.step(h);
  EXPECT_TRUE(simulation.work.solution.converged);
  const Linear<M> down(0, -0.5, 0), slip = start.head<3>() + start.tail<3>().cross(down);
  const Linear<M> expected =
      start.head<3>() - rough.friction * scene.gravity.norm() * steps * h * slip.normalized();
  EXPECT_LE((simulation.scene.bodies().velocity[1].head<3>() - expected).norm(), 1e-9);
}

TEST(SemismoothNewton, ComesToTheVelocitiesOfExactSweepsInPilesAndKeepsBounds) {
  int converged = 0, agreed = 0;
  for (int seed = 1; seed <= 12; ++seed) {
    Simulation<M> pile{box_pile<M>(seed, {.count = 6, .speed = 1, .decades = 0, .surface = {0.6, 0}})};
    for (int i = 0; i < 60; ++i) pile.step(h);
    Simulation<M> newton{pile.scene, {exact, Baumgarte{.slop = 0.001}}},
        swept{pile.scene, {ConjugateSweeps{.sweeps = 20000, .tolerance = 1e-12}, Baumgarte{.slop = 0.001}}};
    newton.step(h);
    swept.step(h);
    const auto& system = newton.work.system;
    system.for_each_run([&]<int K, Bound B>(std::span<const Block<M, K, B>> blocks) {
      for (const auto& block : blocks) {
        const Eigen::Map<const Rows<K>> lambda(&system.lambda[block.row]);
        if (B == Bound::interval) {
          EXPECT_GE(lambda[0], 0) << "seed " << seed;
        }
        if (B == Bound::friction) {
          const double most = system.upper[block.row] * system.lambda[block.normal_row];
          EXPECT_LE(lambda.norm(), most * (1 + 1e-12)) << "seed " << seed;
        }
      }
    });
    converged += newton.work.solution.converged;
    if (!newton.work.solution.converged || !swept.work.solution.converged) continue;
    ++agreed;
    for (int i = 0; i < pile.scene.bodies().size(); ++i)
      EXPECT_LE((newton.scene.bodies().velocity[i] - swept.scene.bodies().velocity[i]).norm(), 1e-7)
          << "seed " << seed << ", body " << i;
  }
  EXPECT_GE(agreed, 6);
  EXPECT_GT(converged, agreed) << "and solves piles on which sweeps stall";
}

// Boxes dropped into each other, of 10⁻³ to 10³ kg: there Newton's method gives up in some steps, and leaves 0.6
// m/s where nothing goes on.
TEST(SemismoothNewton, WhereItGivesUpSweepsGoOn) {
  for (const int seed : {9, 12}) {
    Simulation<M> simulation{box_pile<M>(seed, {.count = 8, .surface = rough})};
    for (int i = 0; i < 90; ++i) {
      simulation.step(h);
      EXPECT_LE(simulation.work.solution.residual, 0.02) << "seed " << seed << ", step " << i;
    }
  }
}

TEST(SemismoothNewton, IsHeldToItsRange) {
  for (const SemismoothNewton& solver :
       {SemismoothNewton{.rounds = 0}, SemismoothNewton{.sweeps = 0}, SemismoothNewton{.tolerance = 0}})
    EXPECT_THROW(require_valid(solver), std::invalid_argument);
  EXPECT_THROW(require_valid(ByGraph{.unlike = 0.5}), std::invalid_argument);
  EXPECT_NO_THROW(require_valid(SemismoothNewton{.rounds = 1, .sweeps = 1, .tolerance = 1}));
  EXPECT_NO_THROW(require_valid(Direct{.regularisation = 1, .rounds = 1, .tolerance = 1, .smallest_pivot = 1}));
}

}  // namespace semismooth_newton_test
}  // namespace byhand
