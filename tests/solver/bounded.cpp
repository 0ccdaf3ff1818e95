#include <gtest/gtest.h>

#include "lessons/methods/positions.hpp"
#include "solver/constraints/contact.hpp"
#include "solver/constraints/friction.hpp"
#include "tests/solver/solving.hpp"

// Contacts push and never pull; friction holds no more than the contact presses.
namespace bounded_test {

using namespace byhand;

template <class M>
InverseMass<M> bob(double mass) {
  if constexpr (M::angular == 0)
    return with_mass<M>(mass);
  else
    return ball<M>(mass, 0.1);
}

/// A bob of 3 kg, `gap` above the ground, on a contact and with friction of coefficient `mu`, held by its centre.
template <class M>
Scene<M> on_the_ground(double gap, double mu) {
  Scene<M> scene;
  const Linear<M> up = Linear<M>::Unit(1);
  const int ground = scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>());
  const int body = scene.add_body(Linear<M>(gap * up), bob<M>(3));
  const int contact = scene.add(Contact<M>{{ground, body}, up});
  scene.add(Friction<M>{{ground, body}, tangents_of<M>(up), mu, contact});
  return scene;
}

template <class M>
Linear<M> after_a_step(Scene<M> scene, const RowSolver& solver = GaussSeidel{}) {
  Work<M> work;
  advance(scene, {solver, NoDriftCure{}}, time_step, work);
  return scene.bodies().velocity[1].template head<M::linear>();
}

TEST_IN_ALL_MODELS(Contact, PushesAndNeverPulls) {
  for (const RowSolver& solver : {RowSolver(GaussSeidel{}), RowSolver(Jacobi{})}) {
    auto scene = on_the_ground<M>(0, 0);
    EXPECT_NEAR(after_a_step<M>(scene, solver)[1], 0, 1e-15) << "it carries what falls on it";
    scene.state().velocity[1][1] = 2;
    EXPECT_NEAR(after_a_step<M>(scene, solver)[1], 2 - 9.81 * time_step, 1e-15) << "it lets go";
  }
}

TEST_IN_ALL_MODELS(Contact, CarriesTheWeight) {
  auto scene = on_the_ground<M>(0, 0);
  Work<M> work;
  for (int i = 0; i < 10; ++i) advance(scene, {GaussSeidel{}}, time_step, work);
  EXPECT_NEAR(work.system.lambda[0], 3 * 9.81 * time_step, 1e-12);
  EXPECT_NEAR(scene.bodies().pose[1].position[1], 0, 1e-13);
}

TEST_IN_ALL_MODELS(Contact, ClosesItsGapInAStepAndNotMore) {
  for (const double beta : {0.0, 0.2, 1.0}) {
    auto scene = on_the_ground<M>(0.1, 0);
    scene.state().velocity[1][1] = -30;
    Work<M> work;
    advance(scene, {GaussSeidel{}, Baumgarte{beta}}, time_step, work);
    EXPECT_NEAR(scene.bodies().pose[1].position[1], 0, 1e-15) << "30 m/s would have gone 0.5 m";
    auto slow = on_the_ground<M>(0.1, 0);
    slow.state().velocity[1][1] = -1;
    advance(slow, {GaussSeidel{}, Baumgarte{beta}}, time_step, work = {});
    EXPECT_NEAR(slow.bodies().velocity[1][1], -1 - 9.81 * time_step, 1e-14) << "what does not reach is not held";
  }
}

TEST(Contact, AccumulatesSoThatAnEarlyPushCanBeTakenBack) {
  // Two contacts under a box thrust one corner first: clamping increments instead would leave it tipping.
  Scene<PlaneBody> scene;
  const int ground = scene.add_body({0, 0}, fixed<PlaneBody>());
  const int body = scene.add_body({0, 0.5}, box<PlaneBody>(1, {0.2, 1}));
  for (const double x : {-0.1, 0.1})
    scene.add(Contact<PlaneBody>{between<PlaneBody>(scene.bodies(), ground, {x, 0}, body, {x, 0}), {0, 1}});
  const auto answer = solved(scene, GaussSeidel{500, false}, NoDriftCure{});
  EXPECT_NEAR(answer.lambda[0], 9.81 * time_step / 2, 1e-12);
  EXPECT_NEAR(answer.lambda[1], 9.81 * time_step / 2, 1e-12);
  EXPECT_LE(largest(answer.velocity), 1e-12);
  const auto after_one = solved(scene, GaussSeidel{1, false}, NoDriftCure{});
  EXPECT_GT(after_one.lambda[0], 0.6 * 9.81 * time_step) << "row 1 gave too much before row 2 spoke";
}

TEST_IN_ALL_MODELS(Friction, HoldsUpToMuTimesTheNormalImpulseAndSlidesBeyond) {
  const double mu = 0.4, held = mu * 9.81 * time_step;
  const auto slide = [&](double push) {
    auto scene = on_the_ground<M>(0, mu);
    scene.state().velocity[1][0] = push;
    return after_a_step<M>(scene)[0];
  };
  EXPECT_NEAR(slide(0.999 * held), 0, 1e-15);
  EXPECT_NEAR(slide(-0.999 * held), 0, 1e-15);
  EXPECT_NEAR(slide(2 * held), held, 1e-14);
  EXPECT_NEAR(slide(-2 * held), -held, 1e-14);
}

TEST_IN_ALL_MODELS(Friction, DoesNothingWhereNothingPresses) {
  auto scene = on_the_ground<M>(1, 10);
  scene.state().velocity[1][0] = 1;
  EXPECT_EQ(after_a_step<M>(scene)[0], 1);
}

TEST(Friction, InSpaceHoldsAlikeInEveryDirection) {
  in_models<SpaceParticle, SpaceBody>([]<class M>(Random&) {
    for (int degrees = 0; degrees < 360; degrees += 15) {
      const auto [sin, cos] = sin_cos(degrees * std::acos(-1.0) / 180);
      auto scene = on_the_ground<M>(0, 0.4);
      const double held = 0.4 * 9.81 * time_step, speed = 3 * held;
      scene.state().velocity[1][0] = speed * cos;
      scene.state().velocity[1][2] = speed * sin;
      const Linear<M> left = after_a_step<M>(scene);
      EXPECT_NEAR(left[0], (speed - held) * cos, 1e-14) << degrees << "°";
      EXPECT_NEAR(left[2], (speed - held) * sin, 1e-14) << degrees << "°";
    }
  });
}

TEST_IN_ALL_MODELS(Friction, StaysWithinItsBallOnEveryRandomScene, 30) {
  Scene<M> scene;
  for (int i = 0; i < 6; ++i)
    scene.add_body(random.pose<M>(), i == 0 ? fixed<M>() : random.mass<M>(),
                   i == 0 ? Velocity<M>(Velocity<M>::Zero()) : random.velocity<M>());
  for (int i = 0; i < 8; ++i) {
    const int body1 = random.index(6), body2 = (body1 + 1 + random.index(5)) % 6;
    const Anchors<M> at{body1, body2, random.arms<M>()};
    const Linear<M> n = random.direction<M>();
    const int contact = scene.add(Contact<M>{at, n});
    scene.add(Friction<M>{at, tangents_of<M>(n), random.uniform(0, 1), contact});
  }
  for (const auto order : {SweepOrder::natural, SweepOrder::reverse, SweepOrder::coloured}) {
    Work<M> work;
    auto copy = scene;
    advance(copy, {GaussSeidel{40, true, order}, NoDriftCure{}}, time_step, work);
    for (const auto& friction : scene.template all<Friction>()) {
      const double pressing = work.system.lambda[work.system.row_of[scene.place(friction.contact)]];
      const int row = work.system.row_of[scene.place(friction.contact) + 1];
      const Eigen::Map<const Rows<Friction<M>::rows>> rubbing(&work.system.lambda[row]);
      EXPECT_GE(pressing, 0);
      // In the other orders a contact may still give way after its friction was held within it.
      if (order == SweepOrder::natural) {
        EXPECT_LE(rubbing.norm(), friction.coefficient * pressing + 1e-12);
      }
    }
  }
}

TEST_IN_ALL_MODELS(Friction, SolvedBeforeItsContactDoesNothingOnAColdStart) {
  auto scene = on_the_ground<M>(0, 0.4);
  scene.state().velocity[1][0] = 1;
  EXPECT_EQ(after_a_step<M>(scene, GaussSeidel{1, false, SweepOrder::reverse})[0], 1);
  EXPECT_LT(after_a_step<M>(scene, GaussSeidel{1, false, SweepOrder::natural})[0], 1);
  EXPECT_LT(after_a_step<M>(scene, GaussSeidel{2, false, SweepOrder::reverse})[0], 1);
}

TEST_IN_ALL_MODELS(BoundedRows, MeetAtTheSameAnswerInEveryOrder) {
  auto scene = on_the_ground<M>(0, 0.4);
  scene.state().velocity[1][0] = 1;
  scene.state().velocity[1][1] = -2;
  const Linear<M> expected = after_a_step<M>(scene, GaussSeidel{50, false});
  for (const auto order : {SweepOrder::reverse, SweepOrder::coloured})
    EXPECT_LE(difference(after_a_step<M>(scene, GaussSeidel{50, false, order}), expected), 1e-14);
  Jacobi jacobi{200, false};
  jacobi.relaxation = 0.7;
  EXPECT_LE(difference(after_a_step<M>(scene, jacobi), expected), 1e-13);
  EXPECT_LE(solved(scene, GaussSeidel{50, false}).residual, 1e-13);
}

// Newton's step of methods on positions, held against the conditions of its complementarity problem: first of the
// two normals, then of friction within μ times their new sum.
TEST(BoundedNewton, OfAManifoldSolvesBothNormalsAndThenFriction) {
  Random random;
  int pressing = 0, slipping = 0;
  for (int i = 0; i < 2000; ++i) {
    Eigen::Matrix3d J, A;
    for (double& entry : J.reshaped()) entry = random.uniform(-1, 1);
    A = J * J.transpose() + 0.1 * Eigen::Matrix3d::Identity();
    const double mu = random.uniform(0, 1), first = random.uniform(0, 1), second = random.uniform(0, 1);
    const Rows<3> before(first, second, mu * (first + second) * random.uniform(-1, 1));
    const Rows<3> residual = random.vector<3>(3);
    const Rows<3> change = bounded_newton<Bound::manifold, 3>(A, residual, before, {0, mu, 0}),
                  after = before + change;
    const Eigen::Vector2d rates = residual.head<2>() + A.topLeftCorner<2, 2>() * change.head<2>();
    for (int k = 0; k < 2; ++k) {
      EXPECT_GE(after[k], -1e-13);
      EXPECT_GE(rates[k], -1e-12);
      EXPECT_NEAR(after[k] * rates[k], 0, 1e-11);
      pressing += after[k] > 1e-9;
    }
    const double slip = residual[2] + A.row(2).dot(change), radius = mu * (after[0] + after[1]);
    EXPECT_LE(std::abs(after[2]), radius + 1e-13);
    if (std::abs(after[2]) < radius - 1e-9) {
      EXPECT_NEAR(slip, 0, 1e-11);
    } else {
      EXPECT_LE(slip * after[2], 1e-11) << "at its bound friction opposes the slip";
      ++slipping;
    }
  }
  EXPECT_GT(pressing, 500);
  EXPECT_GT(slipping, 500);
}

TEST_IN_ALL_MODELS(BoundedRows, AreSolvedDirectlyAsSweepsEnd) {
  for (const double mu : {0.0, 0.1, 0.4, 2.0}) {
    auto scene = on_the_ground<M>(0, mu);
    scene.state().velocity[1] = random.velocity<M>();
    const Linear<M> swept = after_a_step<M>(scene, GaussSeidel{5000});
    for (const RowSolver& solver : {RowSolver(Direct{}), RowSolver(ConjugateSweeps{5000}), RowSolver(ByGraph{})})
      EXPECT_LE((after_a_step<M>(scene, solver) - swept).norm(), 1e-6) << mu;
  }
}

}  // namespace bounded_test
