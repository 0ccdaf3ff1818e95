#include <gtest/gtest.h>

#include "solver/constraints/hinge.hpp"
#include "solver/constraints/limit.hpp"
#include "solver/constraints/motor.hpp"
#include "solver/constraints/slider.hpp"
#include "solver/constraints/weld.hpp"
#include "tests/solver/random.hpp"

// What the C of joints measures.
namespace joints_rest_test {

using namespace byhand;
constexpr int draws = 200;

template <class M>
Turn<M> random_turn(Random& random, const Bodies<M>& bodies) {
  if constexpr (M::angular == 1)
    return turn<M>(bodies, 0, 1);
  else
    return turn<M>(bodies, 0, 1, random.direction<M>());
}

template <class M, class Freedom>
void expect_one_jacobian(const Freedom& freedom, const Pair<M>& pair) {
  const auto J = freedom.jacobian(pair.pose1, pair.pose2).matrix;
  const double q = freedom.value(pair.pose1, pair.pose2);
  const auto expect = [&](const auto& kind, double sign, double place) {
    EXPECT_EQ(difference(kind.jacobian(pair.pose1, pair.pose2).matrix, sign * Dense(J)), 0);
    EXPECT_EQ(kind.value(pair.pose1, pair.pose2)[0], sign * (q - place));
  };
  expect(motor<M>(freedom, 1, 1), 1, 0);
  expect(servo<M>(freedom, 0.2, Elastic{1, 1}, 1), 1, 0.2);
  expect(at_least<M>(-0.3, freedom), 1, -0.3);
  expect(at_most<M>(0.4, freedom), -1, 0.4);
}

TEST_IN_BOTH_BODIES(Joints, LimitsMotorsAndServosOfAFreedomShareItsJacobian, draws) {
  const auto made = random_pair<M>(random), moved = random_pair<M>(random);
  expect_one_jacobian(random_turn(random, made.bodies()), moved);
  expect_one_jacobian(slide<M>(made.bodies(), 0, 1, random.vector<M::linear>(2), random.direction<M>()), moved);
}

TEST_IN_BOTH_BODIES(Joints, HoldWhereTheyAreMade, draws) {
  const auto pair = random_pair<M>(random);
  const auto at_rest = [&](const auto& joint) {
    return joint.template value<double>(pair.pose1, pair.pose2).cwiseAbs().maxCoeff();
  };
  const Linear<M> point = random.vector<M::linear>(2), axis = random.direction<M>();
  const Bodies<M> bodies = pair.bodies();
  EXPECT_LE(at_rest(weld<M>(bodies, 0, 1, point)), 1e-14);
  EXPECT_LE(at_rest(slider<M>(bodies, 0, 1, point, axis)), 1e-14);
  EXPECT_LE(at_rest(motor<M>(slide<M>(bodies, 0, 1, point, axis), 1, 1)), 1e-14);
  EXPECT_LE(at_rest(motor<M>(random_turn(random, bodies), 1, 1)), 1e-14);
  if constexpr (M::angular == 3) {
    EXPECT_LE(at_rest(hinge<M>(bodies, 0, 1, point, axis)), 1e-14);
  }
}

/// The pair with body 2 moved as a joint lets it: turned about an axis of body 1's at a world point, or gone along
/// it.
template <class M>
Pose<M> turned_about(const Pose<M>& pose, const Linear<M>& point, const Angular<M>& turn) {
  Pose<M> result = pose;
  result.rotation = rotated_by(pose.rotation, [&] {
    if constexpr (M::angular == 1)
      return turn[0];
    else
      return turn;
  }());
  result.position = point - rotate(result.rotation, arm_to<M>(pose, point));
  return result;
}

TEST_IN_BOTH_BODIES(Joints, AngleIsHowFarBody2HasTurnedAnticlockwise, draws) {
  const auto pair = random_pair<M>(random);
  const double angle = random.uniform(-3.14, 3.14);
  Angular<M> axis;
  Turn<M> measured;
  if constexpr (M::angular == 1) {
    axis = Angular<M>(1);
    measured = turn<M>(pair.bodies(), 0, 1);
  } else {
    axis = random.direction<M>();
    measured = turn<M>(pair.bodies(), 0, 1, 7 * axis);
  }
  const Linear<M> point = random.vector<M::linear>(2);
  const Pose<M> turned = turned_about<M>(pair.pose2, point, angle * axis);
  EXPECT_NEAR(measured.value(pair.pose1, turned), angle, 2e-13 / (3.15 - std::abs(angle)));
  // Both turned and carried together, nothing is seen.
  const Angular<M> any = random.vector<M::angular>(2);
  EXPECT_NEAR(measured.value(turned_about<M>(pair.pose1, point, any), turned_about<M>(turned, point, any)), angle,
              2e-13 / (3.15 - std::abs(angle)));
  if constexpr (M::angular == 3) {
    const auto door = hinge<M>(pair.bodies(), 0, 1, point, axis);
    EXPECT_LE(door.value(pair.pose1, turned).norm(), 1e-13);
  }
}

TEST_IN_BOTH_BODIES(Joints, WayIsHowFarBody2HasGoneAlongTheAxis, draws) {
  auto pair = random_pair<M>(random);
  const Linear<M> point = random.vector<M::linear>(2), axis = random.direction<M>();
  const auto way = slide<M>(pair.bodies(), 0, 1, point, 5 * axis);
  const auto guide = slider<M>(pair.bodies(), 0, 1, point, axis);
  const double gone = random.uniform(-3, 3);
  pair.pose2.position += gone * axis;
  EXPECT_NEAR(way.value(pair.pose1, pair.pose2), gone, 1e-13);
  EXPECT_LE(guide.value(pair.pose1, pair.pose2).norm(), 1e-13);
}

TEST(Joints, AWeldMeasuresAWholeTurnAndItsJacobianNeverGoesFlat) {
  Random random;
  for (int i = 0; i < draws; ++i) {
    const auto pair = random_pair<SpaceBody>(random);
    const auto joint = weld<SpaceBody>(pair.bodies(), 0, 1, Eigen::Vector3d::Zero());
    const Eigen::Vector3d axis = random.direction<SpaceBody>();
    const double angle = random.uniform(0, 3.1);
    const auto turned = turned_about<SpaceBody>(pair.pose2, Eigen::Vector3d::Zero(), angle * axis);
    const Eigen::Vector3d off = joint.value(pair.pose1, turned).tail<3>();
    EXPECT_LE((off - 4 * std::tan(angle / 4) * axis).norm(), 1e-13);
    const Eigen::Matrix3d B = joint.right.slope(pair.pose1, turned);
    const double stretch = 1 + off.squaredNorm() / 16;
    EXPECT_LE((B * B.transpose() - stretch * stretch * Eigen::Matrix3d::Identity()).norm(), 1e-13);
  }
}

TEST(Joints, AnglesAreLibmsToAFewUlps) {
  Random random;
  for (int i = 0; i < 100'000; ++i) {
    const double expected = random.uniform(-3.1415926, 3.1415926);
    const PlaneRotation<> r{std::cos(expected), std::sin(expected)};
    // Rounding of cosine and sine alone leaves ½ ulp of 1 in the angle.
    EXPECT_NEAR(principal_angle<double>(r), std::atan2(r.sin, r.cos), 4e-16 + 4e-16 * std::abs(expected));
  }
  EXPECT_EQ(principal_angle<double>({1, 0}), 0);
  EXPECT_NEAR(principal_angle<double>({-1, 0}), M_PI, 1e-15);
  EXPECT_NEAR(principal_angle<double>({0, -1}), -M_PI / 2, 1e-15);
}

}  // namespace joints_rest_test
