#include <gtest/gtest.h>

#include "lessons/scenes/boxes.hpp"
#include "lessons/scenes/chain.hpp"
#include "solver/measure.hpp"

namespace conjugate_sweeps_test {

using namespace byhand;

/// Sweeps that it takes, from nothing, to hold a straight hanging chain still to 1e-9 m/s.
template <class Solver>
int sweeps_for(int links, Solver solver) {
  const auto chain = rod_chain<PlaneParticle, NormalisedDistance>({.links = links});
  solver.warm_start = false;
  solver.order = SweepOrder::natural;
  solver.tolerance = 0;
  const auto hold = [&](int sweeps) {
    auto scene = chain;
    Work<PlaneParticle> work;
    solver.sweeps = sweeps;
    advance(scene, VelocityStepping{solver}, 1.0 / 60, work);
    return residual(work.system, scene.bodies().velocity) <= 1e-9;
  };
  int too_few = 0, enough = 1;
  while (!hold(enough)) too_few = enough, enough *= 2;
  while (enough - too_few > 1) (hold((too_few + enough) / 2) ? enough : too_few) = (too_few + enough) / 2;
  return enough;
}

TEST(ConjugateSweeps, TakeInProportionToAChainsLinksWhatSweepsTakeBySquare) {
  const int conjugate10 = sweeps_for(10, ConjugateSweeps{}), conjugate40 = sweeps_for(40, ConjugateSweeps{});
  const int plain10 = sweeps_for(10, GaussSeidel{}), plain40 = sweeps_for(40, GaussSeidel{});
  EXPECT_NEAR(static_cast<double>(plain40) / plain10, 16, 2);
  EXPECT_LT(static_cast<double>(conjugate40) / conjugate10, 8) << conjugate10 << ' ' << conjugate40;
  EXPECT_LT(conjugate40, plain40 / 10);
}

TEST(ConjugateSweeps, EndWherePlainSweepsEnd) {
  for (const int base : {2, 4, 6}) {
    Scene<PlaneBody> conjugate = pyramid(base), plain = conjugate;
    kick(conjugate, 0.5);
    kick(plain, 0.5);
    Work<PlaneBody> work1, work2;
    advance(conjugate, VelocityStepping{ConjugateSweeps{.sweeps = 20000, .tolerance = 1e-12}}, 1.0 / 60, work1);
    advance(plain, VelocityStepping{GaussSeidel{.sweeps = 20000, .tolerance = 1e-12}}, 1.0 / 60, work2);
    for (int i = 0; i < plain.bodies().size(); ++i)
      EXPECT_LE((conjugate.bodies().velocity[i] - plain.bodies().velocity[i]).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(ConjugateSweeps, KeepEveryBoundAtWhateverSweepTheyStop) {
  for (int sweeps = 1; sweeps <= 12; ++sweeps) {
    Scene<PlaneBody> scene = pyramid(5);
    kick(scene, 2);
    Work<PlaneBody> work;
    for (int i = 0; i < 20; ++i) {
      advance(scene, VelocityStepping{ConjugateSweeps{.sweeps = sweeps}}, 1.0 / 60, work);
      for (std::size_t k = 0; k < work.system.lambda.size(); k += 3) {
        const double* lambda = &work.system.lambda[k];
        ASSERT_GE(std::min(lambda[0], lambda[1]), 0);
        ASSERT_LE(std::abs(lambda[2]), work.system.upper[k] * (lambda[0] + lambda[1]) * (1 + 1e-12));
      }
    }
  }
}

TEST(ConjugateSweeps, LetAKickedWallComeToRest) {
  Scene<PlaneBody> scene = pyramid(10);
  kick(scene, 0.02);
  Simulation<PlaneBody> wall{scene, VelocityStepping{ByGraph{}, Baumgarte{.slop = 0.001}}};
  for (int i = 0; i < 300; ++i) wall.step(1.0 / 60);
  double fastest = 0;
  for (const auto& V : wall.scene.bodies().velocity) fastest = std::max(fastest, V.cwiseAbs().maxCoeff());
  EXPECT_LT(fastest, 1e-4);
  EXPECT_LT(position_error(wall).max, 0.001);
  EXPECT_LT((wall.scene.bodies().pose.back().position - scene.bodies().pose.back().position).norm(), 0.004);
}

}  // namespace conjugate_sweeps_test
