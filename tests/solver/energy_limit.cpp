#include "solver/direct/energy_limit.hpp"

#include <gtest/gtest.h>

#include "solver/constraints/hinge.hpp"
#include "solver/constraints/motor.hpp"
#include "solver/constraints/weld.hpp"
#include "solver/direct/correction_limit.hpp"
#include "tests/solver/solving.hpp"

// The parts of the limit of energy, each against its own law.
namespace energy_limit_test {

using namespace byhand;

template <class M>
Linear<M> point(double x, double y) {
  return x * Linear<M>::Unit(0) + y * Linear<M>::Unit(1);
}

/// The bodies before a step and the rows that the step wrote for them, with its λ.
template <class M>
struct Written {
  Bodies<M> bodies;
  System<M> system;

  explicit Written(Scene<M> scene, double h = time_step) : bodies(scene.bodies()) {
    Work<M> work;
    advance(scene, VelocityStepping{.gyroscopic = Gyroscopic::none}, h, work);
    system = work.system;
  }
  double energy() const { return kinetic_energy(bodies, bodies.velocity); }
  double pushed() {
    std::vector<double> still;
    return pushed_energy(system, bodies, still);
  }
};

template <class M>
std::vector<Velocity<M>> velocities_of(const Bodies<M>& bodies, double size, Random& random) {
  std::vector<Velocity<M>> result;
  for (const InverseMass<M>& mass : bodies.inverse_mass)
    result.push_back(moves(mass) ? Velocity<M>(random.vector<M::dof>(size)) : Velocity<M>(Velocity<M>::Zero()));
  return result;
}

/// Bodies on rods and pins, of which the first moves.
template <class M>
Written<M> graph(Random& random) {
  while (true) {
    const Scene<M> scene = random_graph<M>(random, 5, 6);
    if (moves(scene.bodies().inverse_mass[0]) && scene.count() > 0) return Written<M>(scene);
  }
}

// Towards another answer the energy is a parabola, which may fall at first. On the way as far as the energy lets
// it, and not beyond.
TEST_IN_ALL_MODELS(MoveTowards, StopsWhereTheEnergyIsTheMostOrArrives, 40) {
  const Written<M> from = graph<M>(random);
  Solved<M> to{from.system.lambda, velocities_of(from.bodies, 20, random)};
  for (double& lambda : to.lambda) lambda += random.uniform(-1, 1);
  const double now = from.energy(), end = kinetic_energy(from.bodies, to.velocity);
  ASSERT_GT(end, now);
  for (const double most : {0.5 * now, now, 0.7 * now + 0.3 * end, 0.01 * now + 0.99 * end, 1.01 * end, 4 * end}) {
    Written<M> there = from;
    move_towards(to, most, there.system, there.bodies);
    EXPECT_NEAR(there.energy(), std::clamp(most, now, end), 1e-9 * end);
    const double share = (there.bodies.velocity[0][0] - from.bodies.velocity[0][0]) /
                         (to.velocity[0][0] - from.bodies.velocity[0][0]);
    if (most > end) {
      EXPECT_NEAR(share, 1, 1e-12);
    }
    for (int body = 0; body < from.bodies.size(); ++body)
      EXPECT_LE(
          (there.bodies.velocity[body] - (1 - share) * from.bodies.velocity[body] - share * to.velocity[body])
              .norm(),
          1e-9);
    for (int row = 0; row < from.system.rows(); ++row)
      EXPECT_NEAR(there.system.lambda[row], (1 - share) * from.system.lambda[row] + share * to.lambda[row], 1e-9);
  }
}

TEST_IN_ALL_MODELS(MoveTowards, LeavesBodiesAtRestThatMayHaveNoEnergy) {
  Written<M> still = graph<M>(random);
  const Solved<M> to{still.system.lambda, velocities_of(still.bodies, 1, random)};
  for (Velocity<M>& V : still.bodies.velocity) V.setZero();
  move_towards(to, 0, still.system, still.bodies);
  EXPECT_EQ(still.energy(), 0);
}

// A rod asks for (β/h)|C|/|J|; what it may make is that speed of all bodies, those that it does not hold, too.
TEST_IN_ALL_MODELS(PushedEnergy, OfARodIsAllBodiesAsFastAsItAsks, 10) {
  Scene<M> scene;
  scene.gravity.setZero();
  const double length = random.uniform(1, 3), distance = length + random.uniform(-0.05, 0.05), h = 1e-4;
  double mass = 0;
  for (const double x : {0.0, distance, -4.0}) {
    const double own = random.uniform(0.2, 5);
    mass += own;
    if constexpr (M::angular == 0)
      scene.add_body(point<M>(x, 0), with_mass<M>(own));
    else
      scene.add_body(point<M>(x, 0), box<M>(own, Linear<M>(Linear<M>::Constant(0.5))));
  }
  scene.add_body(point<M>(0, 9), fixed<M>());
  scene.add(Distance<M>{{0, 1}, length});
  // C = d² - l² and |J| = 2d, of which all but a slop is asked back.
  const double asked = 0.2 / h * std::abs(distance * distance - length * length) / (2 * distance);
  EXPECT_NEAR(Written<M>(scene, h).pushed(), 1.01 * 0.5 * mass * asked * asked, 1e-9 * mass * asked * asked);
}

/// Bodies that a motor may turn about a pin, from their centres `arm` away: the last stands elsewhere.
template <class M>
Scene<M> motor_and_others(const Linear<M>& arm, double speed, Random& random) {
  Scene<M> scene;
  scene.gravity.setZero();
  const auto add = [&](const Linear<M>& place) {
    Linear<M> sides = Linear<M>::Constant(0.2);
    sides[0] = 1;
    return scene.add_body(place, box<M>(random.uniform(0.2, 5), sides));
  };
  const int bar = add(arm), ground = scene.add_body(point<M>(50, 30), fixed<M>());
  add(point<M>(-5, 1));
  add(point<M>(-2, -4));
  if constexpr (M::linear == 2) {
    scene.add(pin<M>(scene.bodies(), bar, ground, point<M>(0, 0)));
    scene.add(motor<M>(turn(scene.bodies(), bar, ground), speed, 1e300));
  } else {
    scene.add(hinge<M>(scene.bodies(), bar, ground, point<M>(0, 0), Linear<M>::Unit(2)));
    scene.add(motor<M>(turn(scene.bodies(), bar, ground, Linear<M>::Unit(2)), speed, 1e300));
  }
  return scene;
}

// Of a turn it is that of all bodies at the farthest from its axis: the extent of those that move and the longest
// arm, in space at most √2 of it, and with the turn's own energy.
TEST_IN_BOTH_BODIES(PushedEnergy, OfAMotorIsAllBodiesAtTheFarthest, 10) {
  const double angle = random.uniform(0, 6), length = random.uniform(0.1, 8), speed = random.uniform(0.1, 3);
  const Linear<M> arm = length * point<M>(std::cos(angle), std::sin(angle));
  Written<M> written(motor_and_others<M>(arm, speed, random));
  const Linear<M> others[] = {point<M>(-5, 1), point<M>(-2, -4)};
  const Linear<M> extent =
      arm.cwiseMax(others[0]).cwiseMax(others[1]) - arm.cwiseMin(others[0]).cwiseMin(others[1]);
  double mass = 0;
  for (const InverseMass<M>& inverse : written.bodies.inverse_mass)
    if (moves(inverse)) mass += 1 / inverse.linear;
  const double gyration2 = (1 + 0.04) / 12, reach = extent.norm() + (M::linear == 2 ? 1 : std::sqrt(2)) * length;
  const double asked2 = speed * speed * (gyration2 + reach * reach);
  EXPECT_NEAR(written.pushed(), 1.01 * 0.5 * mass * asked2, 1e-9 * mass * asked2);
}

// What a contact does not yet press does not count, only what the ground rises by.
TEST_IN_BOTH_BODIES(PushedEnergy, OfAGroundThatRisesIsThatOfItsSpeed, 10) {
  const double gap = random.uniform(0.001, 0.01), rise = random.uniform(1, 4), mass = random.uniform(0.2, 5);
  Scene<M> scene;
  scene.gravity.setZero();
  Velocity<M> V = Velocity<M>::Zero();
  V[1] = rise;
  scene.set_shape(scene.add_body(point<M>(0, 0), fixed<M>(), V), HalfSpace<M>{point<M>(0, 1)}, {});
  scene.set_shape(scene.add_body(point<M>(0, 0.5 + gap), ball<M>(mass, 0.5)), Ball<M>{0.5}, {});
  EXPECT_NEAR(Written<M>(scene).pushed(), 1.01 * 0.5 * mass * rise * rise, 1e-9 * mass);
}

// Whatever the overlap asks back: it parts faster by itself.
TEST_IN_BOTH_BODIES(PushedEnergy, OfAGroundThatFallsAwayIsNone, 10) {
  Scene<M> scene;
  const Velocity<M> falling = -random.uniform(2, 4) * Velocity<M>::Unit(1);
  scene.set_shape(scene.add_body(point<M>(0, 0), fixed<M>(), falling), HalfSpace<M>{point<M>(0, 1)}, {});
  scene.set_shape(scene.add_body(point<M>(0, 0.5 - random.uniform(0, 0.02)), ball<M>(1, 0.5)), Ball<M>{0.5}, {});
  EXPECT_EQ(Written<M>(scene).pushed(), 0);
}

// A body that is welded on by its centre, and turned by φ, is asked to turn at βφ/h, and nothing else.
TEST(PushedEnergy, OfAWeldThatIsTurnedIsThatOfItsTurn) {
  using M = PlaneBody;
  const double mass = 3, moment = 0.7, angle = 0.01;
  Scene<M> scene;
  scene.gravity.setZero();
  scene.add_body(point<M>(0, 0), fixed<M>());
  scene.add_body(point<M>(2, 0), with_mass<M>(mass, Angular<M>(moment)));
  scene.add(weld<M>(scene.bodies(), 0, 1, point<M>(2, 0)));
  scene.state().pose[1].rotation = plane_rotation(angle);
  const double rate = 0.2 * angle / time_step;
  EXPECT_NEAR(Written<M>(scene).pushed(), 1.01 * 0.5 * moment * rate * rate, 1e-9);
}

// Without what they push with, rows ask for what bodies have that move: two-sided ones for JV = 0 of those, and
// one-sided ones leave them what they may approach by.
TEST_IN_BOTH_BODIES(PushedEnergy, LeavesABiasThatPushesNothing, 20) {
  Scene<M> scene = motor_and_others<M>(Linear<M>(random.vector<M::linear>(2)), 2, random);
  scene.set_velocity(1, random.velocity<M>());
  Velocity<M> lifted = random.velocity<M>();
  scene.set_shape(scene.add_body(point<M>(0, -20), fixed<M>(), lifted), HalfSpace<M>{point<M>(0, 1)}, {});
  for (int i = 0; i < 3; ++i)
    scene.set_shape(scene.add_body(point<M>(3 * i, -19.5 + random.uniform(-0.01, 0.02)), ball<M>(1, 0.5)),
                    Ball<M>{0.5}, {});
  Written<M> written(scene);
  std::vector<double> still;
  pushed_energy(written.system, written.bodies, still);
  int pressed = 0;
  for_each_block(written.system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run&) {
    const Rows<K> rate = led(written.bodies, block);
    for (int k = 0, row = block.row; k < K; ++k, ++row) {
      const bool pushes_only = one_sided(written.system, block, k);
      pressed += pushes_only;
      const double asked = written.system.bias[row] + rate[k];
      EXPECT_NEAR(still[row] + rate[k], pushes_only ? std::max(asked, 0.0) : 0.0, 1e-9);
    }
  });
  EXPECT_GE(pressed, 1);
}

/// Two free bodies joined by a rod of the wrong length, which may make `made`; and velocities of any energy.
template <class M>
struct Limited {
  Written<M> at;
  double made = at.pushed();
  std::vector<Velocity<M>> without;

  explicit Limited(Random& random) : at(rod(random)), without(velocities_of(at.bodies, 3, random)) {}

  static Scene<M> rod(Random& random) {
    Scene<M> scene;
    scene.add_body(point<M>(0, 0), random.mass<M>());
    scene.add_body(point<M>(2, 0), random.mass<M>());
    scene.add(Distance<M>{{0, 1}, 1.8});
    return scene;
  }
  double before() const { return kinetic_energy(at.bodies, without); }
  /// These velocities, scaled to an energy [J].
  std::vector<Velocity<M>> of_energy(double energy) const {
    std::vector<Velocity<M>> result = without;
    for (Velocity<M>& V : result) V *= std::sqrt(energy / before());
    return result;
  }
  /// Limits what a solve made, where a solve that pushes with nothing makes another energy.
  bool limit(double solved, bool converged, double still, bool* asked = nullptr) {
    at.bodies.velocity = of_energy(solved);
    at.system.lambda = {7};
    const double bias = at.system.bias[0];
    std::vector<double> scratch;
    const bool changed = limit_energy(without, converged, at.system, at.bodies, scratch, [&] {
      if (asked) *asked = true;
      EXPECT_EQ(at.bodies.velocity, without);
      EXPECT_EQ(at.system.lambda[0], 0);
      EXPECT_EQ(at.system.bias[0], 0);
      at.bodies.velocity = of_energy(still);
      at.system.lambda = {3};
    });
    EXPECT_EQ(at.system.bias[0], bias);
    return changed;
  }
};

TEST_IN_ALL_MODELS(LimitEnergy, LeavesWhatMayBe, 5) {
  Limited<M> limited(random);
  const double before = limited.before(), made = limited.made;
  bool asked = false;
  for (const double energy : {0.5 * before, before}) EXPECT_FALSE(limited.limit(energy, false, 0, &asked));
  for (const double energy : {before + 0.5 * made, before + made}) {
    EXPECT_FALSE(limited.limit(energy, true, 0, &asked));
    EXPECT_NEAR(limited.at.energy(), energy, 1e-12 * energy);
  }
  EXPECT_FALSE(asked);
}

// What did not converge counts from where the rows push with nothing.
TEST_IN_ALL_MODELS(LimitEnergy, TakesBackWhatIsBeyond, 5) {
  Limited<M> limited(random);
  const double before = limited.before(), made = limited.made;
  for (const double share : {1.001, 1.5, 4.0})
    for (const double still : {0.2 * before, before - 0.5 * made, before}) {
      if (still <= 0) continue;
      EXPECT_TRUE(limited.limit(share * (before + made), true, still));
      EXPECT_NEAR(limited.at.energy(), std::min(share * (before + made), still + made), 1e-9 * (before + made));
      EXPECT_GT(limited.at.system.lambda[0], 3);
      EXPECT_LT(limited.at.system.lambda[0], 7);
    }
  EXPECT_TRUE(limited.limit(before + 0.9 * made, false, 0.2 * before));
  EXPECT_NEAR(limited.at.energy(), std::min(before + 0.9 * made, 0.2 * before + made), 1e-9 * (before + made));
}

// A solve without pushes that makes energy is no solution: then the energy counts from before it.
TEST_IN_ALL_MODELS(LimitEnergy, OfASolveThatFailsCountsFromBefore, 5) {
  Limited<M> limited(random);
  const double before = limited.before(), made = limited.made;
  EXPECT_TRUE(limited.limit(4 * (before + made), true, 9 * (before + made)));
  EXPECT_NEAR(limited.at.energy(), before + made, 1e-9 * (before + made));
  // It goes there from no λ.
  EXPECT_GT(limited.at.system.lambda[0], 0);
  EXPECT_LT(limited.at.system.lambda[0], 3);
}

}  // namespace energy_limit_test
