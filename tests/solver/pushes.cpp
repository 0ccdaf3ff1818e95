#include <gtest/gtest.h>

#include "lessons/methods/method.hpp"
#include "solver/byhand.hpp"
#include "tests/solver/compiled.hpp"
#include "tests/solver/random.hpp"

// Forces and impulses of a program on single bodies.
namespace pushes_test {

using namespace byhand;
constexpr double h = 1.0 / 64;

template <class M>
InverseMass<M> three_kilograms() {
  if constexpr (M::angular == 0)
    return with_mass<M>(3);
  else
    return box<M>(3, Linear<M>::Ones() + Linear<M>::Unit(0));
}

template <class M>
Scene<M> in_a_void(Random& random, int bodies) {
  Scene<M> scene;
  scene.gravity.setZero();
  for (int i = 0; i < bodies; ++i) scene.add_body(random.pose<M>(), three_kilograms<M>(), random.velocity<M>());
  return scene;
}

TEST(AppliedImpulse, ChangesMomentumByItselfAndAngularMomentumByItsMoment) {
  in_all_models(
      []<class M>(Random& random) {
        Scene<M> scene = in_a_void<M>(random, 3);
        const Linear<M> momentum = linear_momentum(scene.bodies()), impulse = random.vector<M::linear>(5);
        const auto turning = angular_momentum(scene.bodies());
        Linear<M> at = scene.bodies().pose[1].position;
        if constexpr (M::angular > 0) {
          at += random.vector<M::linear>(2);
          scene.apply_impulse(1, impulse, at);
        } else {
          scene.apply_impulse(1, impulse);
        }
        EXPECT_LE((linear_momentum(scene.bodies()) - momentum - impulse).norm(), 1e-13);
        EXPECT_LE((angular_momentum(scene.bodies()) - turning - cross(at, impulse)).norm(), 1e-12);
      },
      50);
}

TEST(AppliedImpulse, OfTurningAddsItselfToTheAngularMomentum) {
  in_all_models(
      []<class M>(Random& random) {
        if constexpr (M::angular > 0) {
          Scene<M> scene = in_a_void<M>(random, 2);
          const auto turning = angular_momentum(scene.bodies());
          const Angular<M> impulse = random.vector<M::angular>(5);
          scene.apply_angular_impulse(0, impulse);
          EXPECT_LE((angular_momentum(scene.bodies()) - turning - impulse).norm(), 1e-12);
        }
      },
      50);
}

TEST(AppliedImpulse, MovesNoFixedBody) {
  Scene<PlaneBody> scene;
  scene.add_body({0, 0}, fixed<PlaneBody>());
  scene.apply_impulse(0, {3, 4}, {1, 1});
  scene.apply_angular_impulse(0, Angular<PlaneBody>(2));
  scene.add_force(0, {3, 4});
  Simulation simulation{scene};
  simulation.step(h);
  EXPECT_EQ(simulation.scene.bodies().velocity[0], Velocity<PlaneBody>(0, 0, 0));
}

// v = v0 + F t/m, by every method; x as each method's rule has it: half a step ahead where velocities come first.
template <class M, class Method>
void expect_free_flight(const Method& method, double ahead, double tolerance) {
  Scene<M> scene;
  scene.gravity.setZero();
  scene.add_body(Linear<M>(Linear<M>::Zero()), three_kilograms<M>());
  const Linear<M> force = 6 * Linear<M>::Unit(0) - 3 * Linear<M>::Unit(1);
  Simulation<M, Method> simulation{scene, method};
  for (int i = 0; i < 64; ++i) {
    simulation.scene.add_force(0, 0.25 * force);
    simulation.scene.add_force(0, 0.75 * force);  // they add up
    simulation.step(h);
  }
  const auto& bodies = simulation.scene.bodies();
  EXPECT_LE((bodies.velocity[0].template head<M::linear>() - force / 3).norm(), tolerance);
  EXPECT_LE((bodies.pose[0].position - force / 6 * (1 + ahead)).norm(), tolerance);
  simulation.step(h);
  EXPECT_LE((bodies.velocity[0].template head<M::linear>() - force / 3).norm(), tolerance) << "and is forgotten";
}

TEST(AppliedForce, GivesAFreeBodyTheVelocityOfItsClosedForm) {
  in_all_models([]<class M>(Random&) {
    expect_free_flight<M>(VelocityStepping{}, h, 1e-13);
    expect_free_flight<M>(VelocityStepping{.substeps = 4}, h / 4, 1e-13);
    expect_free_flight<M>(Xpbd{.substeps = 4}, h / 4, 1e-12);
    expect_free_flight<M>(Avbd{}, h, 1e-9);
    expect_free_flight<M>(Rattle{}, 0, 1e-13);
    expect_free_flight<M>(Controlled<Rattle>{}, 0, 1e-13);
    expect_free_flight<M>(Controlled<Generalised>{}, 0, 1e-13);
    expect_free_flight<M>(Accelerations{}, 0, 1e-13);
  });
}

// A torque on a body that turns about one of its principal axes: ω = τ t/I.
TEST(AppliedForce, AtALeverTurnsABodyLikeATorque) {
  in_all_models([]<class M>(Random&) {
    if constexpr (M::angular > 0) {
      Scene<M> scene;
      scene.gravity.setZero();
      for (int i = 0; i < 2; ++i) scene.add_body(Linear<M>(Linear<M>::Zero()), ball<M>(2, 0.5));
      const Angular<M> torque = 0.3 * Angular<M>::Unit(M::angular - 1);
      const double moment = 1 / scene.bodies().inverse_mass[0].angular[M::angular - 1];
      Simulation simulation{scene};
      for (int i = 0; i < 64; ++i) {
        const Linear<M> centre = simulation.scene.bodies().pose[1].position;
        simulation.scene.add_torque(0, torque);
        // A couple: 1 N up at 0.15 m to the right and 1 N down at 0.15 m to the left.
        simulation.scene.add_force(1, Linear<M>::Unit(1), centre + 0.15 * Linear<M>::Unit(0));
        simulation.scene.add_force(1, -Linear<M>::Unit(1), centre - 0.15 * Linear<M>::Unit(0));
        simulation.step(h);
      }
      for (const auto& V : simulation.scene.bodies().velocity) {
        EXPECT_LE(V.template head<M::linear>().norm(), 1e-13);
        EXPECT_LE((V.template tail<M::angular>() - torque / moment).norm(), 1e-13);
      }
    }
  });
}

// A rod holds a weight against gravity and a pull: its tension is their sum.
TEST(AppliedForce, IsHeldByTheConstraints) {
  in_all_models([]<class M>(Random&) {
    Scene<M> scene;
    scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>());
    scene.add_body(Linear<M>(-Linear<M>::Unit(1)), three_kilograms<M>());
    const auto rod = scene.add(Distance<M>{{0, 1}, 1});
    Simulation simulation{scene};
    for (int i = 0; i < 10; ++i) {
      simulation.scene.add_force(1, -7 * Linear<M>::Unit(1));
      simulation.step(h);
    }
    EXPECT_NEAR(simulation.reaction(rod).force.y(), 3 * 9.81 + 7, 1e-9);
    EXPECT_NEAR(simulation.impulse(rod)[0], -(3 * 9.81 + 7) * h, 1e-9) << "it pulls: λ < 0";
  });
}

TEST(AppliedForce, IsKeptWhereAStepIsTakenBack) {
  Scene<PlaneParticle> scene;
  scene.add_body({0, 0}, with_mass<PlaneParticle>(1), {1e308, 0});
  Simulation simulation{scene};
  simulation.scene.add_force(0, {1, 2});
  EXPECT_THROW(simulation.step(1e10), NotFinite);
  simulation.scene.set_velocity(0, {0, 0});
  simulation.scene.gravity.setZero();
  simulation.step(0.5);
  EXPECT_EQ(simulation.scene.bodies().velocity[0], Velocity<PlaneParticle>(0.5, 1));
}

TEST(AppliedForce, OfABodyThatIsRemovedIsNotLeftToTheNext) {
  Scene<PlaneParticle> scene;
  scene.gravity.setZero();
  scene.add_body({0, 0}, with_mass<PlaneParticle>(1));
  scene.add_force(0, {1, 0});
  scene.add_body({1, 0}, with_mass<PlaneParticle>(1));
  scene.remove_body(0);
  ASSERT_EQ(scene.add_body({0, 0}, with_mass<PlaneParticle>(1)), 0);
  Simulation simulation{scene};
  simulation.step(h);
  for (const auto& V : simulation.scene.bodies().velocity) EXPECT_EQ(V, Velocity<PlaneParticle>(0, 0));
}

TEST(Push, OfABodyThatIsNotThereOrIsNoNumberIsRefused) {
  using M = PlaneBody;
  Scene<M> scene;
  scene.add_body({0, 0}, box<M>(1, {1, 1}));
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(scene.add_force(1, {1, 0}), std::invalid_argument);
  EXPECT_THROW(scene.add_force(0, {nan, 0}), std::invalid_argument);
  EXPECT_THROW(scene.add_force(0, {1, 0}, {0, nan}), std::invalid_argument);
  EXPECT_THROW(scene.add_torque(-1, Angular<M>(1)), std::invalid_argument);
  EXPECT_THROW(scene.add_torque(0, Angular<M>(nan)), std::invalid_argument);
  EXPECT_THROW(scene.apply_impulse(1, {1, 0}), std::invalid_argument);
  EXPECT_THROW(scene.apply_impulse(0, {1, nan}, {0, 0}), std::invalid_argument);
  EXPECT_THROW(scene.apply_angular_impulse(0, Angular<M>(nan)), std::invalid_argument);
  EXPECT_EQ(scene.bodies().velocity[0], Velocity<M>(0, 0, 0));
  EXPECT_TRUE(scene.bodies().applied.empty());
}

}  // namespace pushes_test
