#include <gtest/gtest.h>

#include "lessons/scenes/chain.hpp"
#include "lessons/scenes/pendulum.hpp"
#include "solver/constraints/distance.hpp"
#include "solver/constraints/normalised_distance.hpp"
#include "solver/measure.hpp"
#include "tests/solver/compiled.hpp"
#include "tests/solver/random.hpp"

// Where the article speaks loosely: each statement that is true instead, as a check.
namespace article_corrections_test {

using namespace byhand;

constexpr int draws = 100;

template <class M>
Jacobian<M, 1> unit_row(const Pair<M>& pair) {
  return NormalisedDistance<M>{pair.at, 1}.jacobian(pair.pose1, pair.pose2);
}
template <class M>
Jacobian<M, 1> weighted(const Jacobian<M, 1>& J, const Pair<M>& pair) {
  return times_inverse_mass(J, pair.m1, pair.pose1, pair.m2, pair.pose2);
}

TEST(Transpose, IsNoInverse) {
  in_models<PlaneParticle, SpaceParticle>(
      []<class M>(Random& random) {
        const auto J = unit_row(random_pair<M>(random));
        EXPECT_NEAR((J.matrix * J.matrix.transpose())(0, 0), 2, 1e-14);
      },
      draws);
}

TEST_IN_ALL_MODELS(Transpose, MadeInverseByTheMasses, draws) {
  const auto pair = random_pair<M>(random);
  const auto J = unit_row(pair), W = weighted(J, pair);
  const auto pseudo_inverse = W.matrix.transpose() / inverse_effective_mass(J, W)(0, 0);
  EXPECT_NEAR((J.matrix * pseudo_inverse)(0, 0), 1, 1e-14);
}

TEST_IN_ALL_MODELS(Transpose, GivesAForceThatDoesNoWorkOnMotionsThatObey, draws) {
  auto pair = random_pair<M>(random);
  const auto J = unit_row(pair), W = weighted(J, pair);
  apply_impulse(W, Rows<1>(impulse(J, W, pair.V1, pair.V2, 0)), pair.V1, pair.V2);
  const Eigen::Matrix<double, 2 * M::dof, 1> force = random.uniform(-9, 9) * J.matrix.transpose();
  EXPECT_NEAR(force.template head<M::dof>().dot(pair.V1) + force.template tail<M::dof>().dot(pair.V2), 0, 1e-12);
}

TEST_IN_ALL_MODELS(Impulse, DividedByTheStepIsTheWeightForEveryStep) {
  for (const double h : {1.0 / 10, 1.0 / 60, 1.0 / 1000}) {
    auto scene = pendulum<M, NormalisedDistance>(0, 2, 3);
    Work<M> work;
    advance(scene, {GaussSeidel{1}, NoDriftCure{}}, h, work);
    EXPECT_NEAR(-work.system.lambda[0] / h, 3 * 9.81, 1e-11) << "h = " << h;
  }
}

TEST(Gravity, IsInTheVelocityBeforeTheRowIsSolvedOrTheBobSinksAtGTimesH) {
  const double h = 1.0 / 60;
  const auto speed_after = [&](bool gravity_first) {
    auto scene = pendulum<PlaneParticle, NormalisedDistance>(0, 2, 3);
    auto& bodies = scene.state();
    for (int step = 0; step < 60; ++step) {
      if (gravity_first) add_gravity(bodies, scene.gravity, h);
      const auto J = scene.all<NormalisedDistance>()[0].jacobian(bodies.pose[0], bodies.pose[1]);
      const auto W =
          times_inverse_mass(J, bodies.inverse_mass[0], bodies.pose[0], bodies.inverse_mass[1], bodies.pose[1]);
      const Rows<1> lambda(impulse(J, W, bodies.velocity[0], bodies.velocity[1], 0));
      Velocity<PlaneParticle> anchor = bodies.velocity[0];
      apply_impulse(W, lambda, anchor, bodies.velocity[1]);
      if (!gravity_first) add_gravity(bodies, scene.gravity, h);
      advance_poses(bodies, h);
    }
    return bodies.velocity[1].norm();
  };
  EXPECT_NEAR(speed_after(true), 0, 1e-14);
  EXPECT_NEAR(speed_after(false), 9.81 * h, 1e-12);
}

TEST(WorldInertia, KeepsAngularMomentumWhichTheInertiaOfTheBodyFrameDoesNot) {
  in_models<SpaceBody>(
      []<class M>(Random& random) {
        const auto pair = random_pair<M>(random);
        const auto J = unit_row(pair);
        const auto change_of_momentum = [&](const Pose<M>& frame1, const Pose<M>& frame2) {
          const auto W = times_inverse_mass(J, pair.m1, frame1, pair.m2, frame2);
          Bodies<M> bodies = pair.bodies();
          const auto before = angular_momentum(bodies);
          apply_impulse(W, Rows<1>(impulse(J, W, pair.V1, pair.V2, 0)), bodies.velocity[0], bodies.velocity[1]);
          EXPECT_NEAR(dot(J, bodies.velocity[0], bodies.velocity[1])[0], 0, 1e-13) << "JV = 0 either way";
          return difference(angular_momentum(bodies), before);
        };
        EXPECT_LE(change_of_momentum(pair.pose1, pair.pose2), 1e-12);
        EXPECT_GE(change_of_momentum({}, {}), 1e-6);
      },
      draws);
}

TEST_IN_ALL_MODELS(SquaredAndNormalisedRod, GiveTheSameImpulseWithoutBias, draws) {
  const auto pair = random_pair<M>(random);
  const auto squared = Distance<M>{pair.at, 1}.jacobian(pair.pose1, pair.pose2), unit = unit_row(pair);
  const double by_squared = impulse(squared, weighted(squared, pair), pair.V1, pair.V2, 0);
  const double by_unit = impulse(unit, weighted(unit, pair), pair.V1, pair.V2, 0);
  const double distance = (pair.P2() - pair.P1()).norm();
  EXPECT_NEAR(by_squared * distance, by_unit, 1e-12 * std::max(1.0, std::abs(by_unit)));
  EXPECT_LE(difference(squared.matrix * by_squared, unit.matrix * by_unit),
            1e-12 * std::max(1.0, std::abs(by_unit)));
}

/// C of the squared rod beside J of the normalised one: what must not be mixed.
template <class M>
struct MixedRod : NormalisedDistance<M> {
  template <class T>
  Rows<1, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    return Distance<M>{this->at, this->length}.template value<T>(pose1, pose2);
  }
};

/// |d| - L after 30 steps without gravity, for a rod that began 1 mm too long.
template <template <class> class Rod>
double stretch_after(double length, double beta) {
  using M = PlaneParticle;
  Scene<M> scene;
  scene.gravity.setZero();
  scene.add_body(Linear<M>(0, 0), fixed<M>());
  scene.add_body(Linear<M>(0, -length - 1e-3), with_mass<M>(3));
  Rod<M> rod;
  rod.at = {0, 1};
  rod.length = length;
  scene.add(rod);
  Work<M> work;
  for (int i = 0; i < 30; ++i) advance(scene, {GaussSeidel{1}, Baumgarte{beta}}, 1.0 / 60, work);
  return std::abs(scene.bodies().pose[1].position.norm() - length);
}

TEST(MixedRod, OfTenMetresDivergesWhereEitherFormByItselfConverges) {
  for (const double length : {1.0, 10.0}) {
    EXPECT_LT(stretch_after<NormalisedDistance>(length, 0.21), 1e-5);
    EXPECT_LT(stretch_after<Distance>(length, 0.21), 1e-5);
  }
  EXPECT_LT(stretch_after<MixedRod>(1, 0.21), 1e-5);
  EXPECT_LT(stretch_after<MixedRod>(10, 0.19), 1e-3) << "βL = 1.9";
  EXPECT_GT(stretch_after<MixedRod>(10, 0.21), 1e-2) << "βL = 2.1";
}

TEST(OneScalarFormula, IsOneRowAndNotASystem) {
  auto scene = rod_chain<PlaneParticle, NormalisedDistance>({2});
  Work<PlaneParticle> work;
  const double h = 1.0 / 60;
  advance(scene, {GaussSeidel{1, false}, NoDriftCure{}}, h, work);
  EXPECT_NEAR(residual(work.system, scene.bodies().velocity), 9.81 * h / 2, 1e-12)
      << "row 2 undoes half of what row 1 did";
  auto exact = rod_chain<PlaneParticle, NormalisedDistance>({2});
  Work<PlaneParticle> exact_work;
  advance(exact, {Direct{}, NoDriftCure{}}, h, exact_work);
  EXPECT_NEAR(residual(exact_work.system, exact.bodies().velocity), 0, 1e-15);
}

}  // namespace article_corrections_test
