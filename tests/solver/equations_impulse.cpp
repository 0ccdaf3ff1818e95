#include <gtest/gtest.h>

#include <array>

#include "lessons/scenes/pendulum.hpp"
#include "solver/constraints/contact.hpp"
#include "solver/constraints/distance.hpp"
#include "solver/constraints/friction.hpp"
#include "solver/constraints/normalised_distance.hpp"
#include "solver/constraints/pin.hpp"
#include "solver/measure.hpp"
#include "tests/solver/compiled.hpp"
#include "tests/solver/random.hpp"

// Equations (5)-(8) and (17)-(22): from J to impulses, and the bias.
namespace equations_impulse_test {

using namespace byhand;

constexpr int draws = 100;

template <class M, int K>
Dense dense(const Jacobian<M, K>& J) {
  return J.matrix;
}

template <class M>
Dense stacked(const Velocity<M>& V1, const Velocity<M>& V2) {
  Dense V(2 * M::dof, 1);
  V.set_block(0, 0, V1);
  V.set_block(M::dof, 0, V2);
  return V;
}

/// The matrix of (18) as it is printed, the inertia of a body in space turned into the world: R I Rᵀ, inverted
/// as a matrix.
template <class M>
Dense dense_inverse_mass(const Pair<M>& pair) {
  Dense result(2 * M::dof, 2 * M::dof);
  const auto set = [&](int first, const InverseMass<M>& m, const Pose<M>& pose) {
    for (int i = 0; i < M::linear; ++i) result(first + i, first + i) = m.linear;
    if constexpr (M::angular > 0) {
      Dense I(M::angular, M::angular);
      for (int i = 0; i < M::angular; ++i) I(i, i) = 1 / m.angular[i];
      if constexpr (M::angular == 3) {
        const Dense R = pose.rotation.toRotationMatrix();
        I = R * I * R.transposed();
      }
      result.set_block(first + M::linear, first + M::linear, I.inverse());
    }
  };
  set(0, pair.m1, pair.pose1);
  set(M::dof, pair.m2, pair.pose2);
  return result;
}

template <class M>
Jacobian<M, 1> rod_row(const Pair<M>& pair) {
  return Distance<M>{pair.at, 1}.jacobian(pair.pose1, pair.pose2);
}
template <class M, int K>
Jacobian<M, K> weighted(const Jacobian<M, K>& J, const Pair<M>& pair) {
  return times_inverse_mass(J, pair.m1, pair.pose1, pair.m2, pair.pose2);
}

/// A number's share of the sum of sizes that it came from.
double relative(double x, double scale) { return std::abs(x) / std::max(1.0, scale); }

TEST_IN_ALL_MODELS(Equation5, ForceIsLambdaTimesTheRow, draws) {
  const auto pair = random_pair<M>(random);
  const auto J = rod_row(pair);
  const double lambda = random.uniform(-5, 5);
  Velocity<M> V1 = pair.V1, V2 = pair.V2;
  apply_impulse(weighted(J, pair), Rows<1>(lambda), V1, V2);
  const Dense momentum_gained =
      dense_inverse_mass(pair).inverse() * (stacked<M>(V1, V2) - stacked<M>(pair.V1, pair.V2));
  EXPECT_LE(difference(momentum_gained, lambda * dense(J).transposed()), 1e-11);
}

TEST(Equation6, HasSixNumbersInThePlaneAndTwelveInSpace) {
  EXPECT_EQ((decltype(Jacobian<PlaneBody, 1>::matrix)::SizeAtCompileTime), 6);
  EXPECT_EQ((decltype(Jacobian<SpaceBody, 1>::matrix)::SizeAtCompileTime), 12);
  EXPECT_EQ((decltype(Jacobian<PlaneParticle, 1>::matrix)::SizeAtCompileTime), 4);
  EXPECT_EQ((decltype(Jacobian<SpaceParticle, 1>::matrix)::SizeAtCompileTime), 6);
}

TEST_IN_ALL_MODELS(Equation6, ListsLinearAndAngularOfBody1ThenOfBody2) {
  const Linear<M> l1 = random.vector<M::linear>(1), l2 = random.vector<M::linear>(1);
  const Angular<M> a1 = random.vector<M::angular>(1), a2 = random.vector<M::angular>(1);
  Jacobian<M, 1> J;
  J.set_row(0, l1, a1, l2, a2);
  Dense listed(2 * M::dof, 1);
  listed.set_block(0, 0, l1);
  listed.set_block(M::linear, 0, a1);
  listed.set_block(M::dof, 0, l2);
  listed.set_block(M::dof + M::linear, 0, a2);
  EXPECT_EQ(difference(dense(J).transposed(), listed), 0);
  EXPECT_EQ(difference(J.l1(), Dense(l1).transposed()), 0);
  EXPECT_EQ(difference(J.l2(), Dense(l2).transposed()), 0);
  EXPECT_EQ(difference(J.a1(), Dense(a1).transposed()), 0);
  EXPECT_EQ(difference(J.a2(), Dense(a2).transposed()), 0);
}

TEST_IN_ALL_MODELS(Equation7, IsTheMatrixProductWithTheStackedVelocities, draws) {
  const auto pair = random_pair<M>(random);
  const auto J = Pin<M>{pair.at}.jacobian(pair.pose1, pair.pose2);
  EXPECT_LE(difference(dot(J, pair.V1, pair.V2), dense(J) * stacked<M>(pair.V1, pair.V2)), 1e-13);
}

TEST_IN_ALL_MODELS(Equation8, IsFourDotProducts, draws) {
  const auto pair = random_pair<M>(random);
  const auto J = rod_row(pair);
  double sum = 0;
  for (int i = 0; i < M::linear; ++i) sum += J.l1()(0, i) * pair.V1[i] + J.l2()(0, i) * pair.V2[i];
  for (int i = 0; i < M::angular; ++i)
    sum += J.a1()(0, i) * pair.V1[M::linear + i] + J.a2()(0, i) * pair.V2[M::linear + i];
  EXPECT_NEAR(dot(J, pair.V1, pair.V2)[0], sum, 1e-12);
}

TEST_IN_ALL_MODELS(Equation17, MakesTheRowVanish, draws) {
  const auto pair = random_pair<M>(random);
  const auto J = rod_row(pair), W = weighted(J, pair);
  const double b = random.uniform(-2, 2);
  Velocity<M> V1 = pair.V1, V2 = pair.V2;
  apply_impulse(W, Rows<1>(impulse(J, W, V1, V2, b)), V1, V2);
  EXPECT_LE(relative(dot(J, V1, V2)[0] + b, dot(J, pair.V1, pair.V2).norm()), 1e-13);
}

TEST_IN_ALL_MODELS(Equation17, IsTheSmallestChangeOfVelocityInTheMetricOfTheMasses, draws) {
  const auto pair = random_pair<M>(random);
  const auto J = rod_row(pair), W = weighted(J, pair);
  const Dense change = impulse(J, W, pair.V1, pair.V2, 0) * dense(W).transposed();
  const Dense mass = dense_inverse_mass(pair).inverse();
  // Any other change that also makes JV vanish differs by something that J does not see.
  const Dense row = dense(J).transposed(), any = stacked<M>(random.velocity<M>(), random.velocity<M>());
  const Dense unseen = any - dot(row, any) / dot(row, row) * row;
  const Dense other = change + unseen;
  EXPECT_LT(dot(change, mass * change), dot(other, mass * other));
  EXPECT_LE(std::abs(dot(change, mass * unseen)), 1e-10);
}

TEST(Equation17, OfAPendulumAtThirtyDegrees) {
  auto scene = pendulum<PlaneParticle, NormalisedDistance>(std::acos(-1.0) / 6, 2, 3);
  Work<PlaneParticle> work;
  advance(scene, {GaussSeidel{1}, NoDriftCure{}}, 1.0 / 60, work);
  EXPECT_NEAR(work.system.lambda[0], -3 * 9.81 / 60 * std::sqrt(3) / 2, 1e-14) << "it pulls: λ < 0";
}

TEST_IN_ALL_MODELS(Equation17, GivesNoImpulseWhereItWouldDivideByZero) {
  auto pair = random_pair<M>(random);
  Jacobian<M, 1> zero;
  zero.matrix.setZero();
  EXPECT_EQ(impulse(zero, weighted(zero, pair), pair.V1, pair.V2, 1), 0) << "J is zero";
  pair.m1 = pair.m2 = fixed<M>();
  const auto J = rod_row(pair);
  EXPECT_EQ(impulse(J, weighted(J, pair), pair.V1, pair.V2, 1), 0) << "neither body moves";
}

TEST_IN_ALL_MODELS(Equation18, IsTheProductWithTheMatrixThatIsNeverMade, draws) {
  const auto pair = random_pair<M>(random);
  const auto J = Pin<M>{pair.at}.jacobian(pair.pose1, pair.pose2);
  const Dense expected = (dense_inverse_mass(pair) * dense(J).transposed()).transposed();
  EXPECT_LE(difference(weighted(J, pair).matrix, expected), 1e-12 * expected.largest());
}

TEST_IN_ALL_MODELS(Equation19, IsTheDenseProduct, draws) {
  const auto pair = random_pair<M>(random);
  const auto J = Pin<M>{pair.at}.jacobian(pair.pose1, pair.pose2);
  const auto K = inverse_effective_mass(J, weighted(J, pair));
  const Dense expected = dense(J) * dense_inverse_mass(pair) * dense(J).transposed();
  EXPECT_LE(difference(K, expected), 1e-12 * expected.norm());
}

TEST_IN_ALL_MODELS(Equation19, IsTheSumOfFourTerms, draws) {
  const auto pair = random_pair<M>(random);
  const auto J = rod_row(pair);
  const Dense inverse_mass = dense_inverse_mass(pair);
  const Dense row = dense(J).transposed();
  const auto part = [&](int first, int size) {
    const Dense a = row.block(first, 0, size, 1);
    return dot(a, inverse_mass.block(first, first, size, size) * a);
  };
  const double sum = part(0, M::linear) + part(M::dof, M::linear) + part(M::linear, M::angular) +
                     part(M::dof + M::linear, M::angular);
  EXPECT_NEAR(inverse_effective_mass(J, weighted(J, pair))(0, 0), sum, 1e-12 * sum);
}

TEST_IN_ALL_MODELS(Equation19, OfOneAndFourKilogramsIsFiveQuarters) {
  Pair<M> pair = random_pair<M>(random);
  pair.at.arms = {};  // held by the centres, so that turning takes no part
  const auto weigh = [&](double m1, double m2) {
    if constexpr (M::angular == 0) {
      pair.m1 = with_mass<M>(m1), pair.m2 = with_mass<M>(m2);
    } else {
      pair.m1 = ball<M>(m1, 1), pair.m2 = ball<M>(m2, 1);
    }
    const auto J = NormalisedDistance<M>{pair.at, 1}.jacobian(pair.pose1, pair.pose2);
    return inverse_effective_mass(J, weighted(J, pair))(0, 0);
  };
  EXPECT_NEAR(weigh(1, 4), 1.25, 1e-14);
  EXPECT_NEAR(weigh(2, 8), 0.625, 1e-14) << "doubled masses halve it";
}

TEST_IN_ALL_MODELS(Equation20, AddsTheInverseMassTimesTheForce, draws) {
  const auto pair = random_pair<M>(random);
  const auto J = Pin<M>{pair.at}.jacobian(pair.pose1, pair.pose2);
  const Rows<Pin<M>::rows> lambda = random.vector<Pin<M>::rows>(3);
  Velocity<M> V1 = pair.V1, V2 = pair.V2;
  apply_impulse(weighted(J, pair), lambda, V1, V2);
  const Dense gained = dense_inverse_mass(pair) * dense(J).transposed() * lambda;
  const Dense expected = stacked<M>(pair.V1, pair.V2) + gained;
  EXPECT_LE(difference(stacked<M>(V1, V2), expected), 1e-12 * expected.norm());
}

TEST_IN_ALL_MODELS(Equation20, KeepsMomentumAndStopsTheRow, draws) {
  const auto pair = random_pair<M>(random);
  const auto J = rod_row(pair), W = weighted(J, pair);
  Bodies<M> bodies = pair.bodies();
  const Linear<M> about = random.vector<M::linear>(1);
  const auto linear = linear_momentum(bodies);
  const auto angular = angular_momentum(bodies, about);
  apply_impulse(W, Rows<1>(impulse(J, W, pair.V1, pair.V2, 0)), bodies.velocity[0], bodies.velocity[1]);
  EXPECT_LE(relative(dot(J, bodies.velocity[0], bodies.velocity[1])[0], dot(J, pair.V1, pair.V2).norm()), 1e-13);
  EXPECT_LE(difference(linear_momentum(bodies), linear), 1e-12);
  EXPECT_LE(difference(angular_momentum(bodies, about), angular), 1e-12);
}

TEST_IN_ALL_MODELS(Equation21, BiasIsTheRateThatRemains, draws) {
  const auto pair = random_pair<M>(random);
  Scene<M> scene = pair.scene();
  scene.gravity.setZero();
  scene.add(Pin<M>{pair.at});
  Work<M> work;
  const auto J = Pin<M>{pair.at}.jacobian(pair.pose1, pair.pose2);
  const auto C = Pin<M>{pair.at}.template value<double>(pair.pose1, pair.pose2);
  const double h = 0.25, beta = 0.5;
  advance(scene, {.solver = GaussSeidel{1}, .drift = Baumgarte{beta}, .gyroscopic = Gyroscopic::none}, h, work);
  const auto JV = dot(J, scene.bodies().velocity[0], scene.bodies().velocity[1]);
  EXPECT_LE(difference(JV, -beta / h * Dense(C)), 1e-11);
}

TEST(Equation22, IsBetaOverHTimesC) {
  EXPECT_DOUBLE_EQ(Baumgarte{0.2}.correction(1.0 / 60).per_second * 0.1, 0.2 * 60 * 0.1);
  EXPECT_DOUBLE_EQ((Baumgarte{0.2, BetaReading::literal}.correction(1.0 / 60).per_second) * 0.1, 0.02)
      << "as it is printed";
  EXPECT_EQ(Correction{}.per_second, 0);
}

/// J of `rows` random rows of which the last repeats the first, and its JM⁻¹Jᵀ.
template <int K>
Eigen::Matrix<double, K, K> with_a_row_twice(Random& random) {
  Eigen::Matrix<double, K, K + 2> J;
  for (double& entry : J.reshaped()) entry = random.uniform(-1, 1);
  J.row(K - 1) = J.row(0);
  return J * J.transpose();
}

TEST(Equation17, GivesARowThatRepeatsAnotherNoImpulse) {
  Random random;
  const auto check = [&]<int K>(std::integral_constant<int, K>) {
    for (int i = 0; i < draws; ++i) {
      const auto A = with_a_row_twice<K>(random), E = inverse_or_zero<K>(A);
      EXPECT_TRUE(E.row(K - 1).isZero(0) && E.col(K - 1).isZero(0)) << E;
      EXPECT_LE((A * E * A - A).norm(), 1e-9 * A.norm()) << "the others do its work";
    }
  };
  check(std::integral_constant<int, 2>());
  check(std::integral_constant<int, 3>());
  check(std::integral_constant<int, 6>());
}

/// The share of a normalised rod's error that is left after each of four steps without gravity.
template <class M>
std::array<double, 4> shares_left(const Baumgarte& cure, double h, double error = 0.1) {
  auto scene = pendulum<M, NormalisedDistance>(0, 2, 3);
  scene.gravity.setZero();
  scene.state().pose[1].position *= 1 + error / 2;
  Work<M> work;
  std::array<double, 4> left{};
  for (double& share : left) {
    advance(scene, {GaussSeidel{1}, cure}, h, work);
    share = (scene.bodies().pose[1].position.norm() - 2) / error;
  }
  return left;
}

TEST_IN_ALL_MODELS(Equation22, AStepLeavesOneMinusBetaOfTheError) {
  for (int tenth = 0; tenth <= 30; ++tenth)
    for (const double error : {0.1, -0.1})
      for (const double h : {1.0 / 30, 1.0 / 60, 1.0 / 120}) {
        const double beta = tenth / 10.0;
        const auto left = shares_left<M>(Baumgarte{beta}, h, error);
        for (int i = 0; i < 4; ++i) EXPECT_NEAR(left[i], std::pow(1 - beta, i + 1), 1e-12) << beta << ", " << h;
      }
}

TEST_IN_ALL_MODELS(Equation22, ReadLiterallyAStepLeavesOneMinusBetaTimesItsDuration) {
  for (const double beta : {0.2, 60.0, 119.0, 121.0})
    for (const double h : {1.0 / 60, 1.0 / 120}) {
      const auto left = shares_left<M>({beta, BetaReading::literal}, h);
      for (int i = 0; i < 4; ++i) EXPECT_NEAR(left[i], std::pow(1 - beta * h, i + 1), 1e-12) << beta << ", " << h;
    }
}

}  // namespace equations_impulse_test
