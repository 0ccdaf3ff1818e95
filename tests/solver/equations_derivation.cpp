#include <gtest/gtest.h>

#include "solver/constraints/contact.hpp"
#include "solver/constraints/distance.hpp"
#include "solver/constraints/friction.hpp"
#include "solver/constraints/normalised_distance.hpp"
#include "solver/constraints/pin.hpp"
#include "tests/solver/compiled.hpp"
#include "tests/solver/dual.hpp"
#include "tests/solver/random.hpp"

// Equations (1)-(4), (9)-(16) and (23): from C to its J.
namespace equations_derivation_test {

using namespace byhand;

constexpr int draws = 100;
constexpr double rounding = 1e-13;  // of sums of a dozen terms of size 10

/// ω × r, which a particle does not have.
template <class M>
Linear<M> turning(const Velocity<M>& V, const Arm<M>& r) {
  if constexpr (M::angular == 0) {
    return Linear<M>::Zero();
  } else if constexpr (M::angular == 1) {
    return V[2] * Linear<M>(-r.y(), r.x());
  } else {
    const Eigen::Vector3d omega = V.template tail<3>();
    return omega.cross(r);
  }
}

template <class M>
Linear<M> linear_part(const Velocity<M>& V) {
  return V.template head<M::linear>();
}

/// The anchor in the world, by rotation matrices rather than by the solver's own `rotate`.
template <class M>
Linear<M> anchor_by_matrix(const Pose<M>& pose, const Arm<M>& arm) {
  if constexpr (M::angular == 0) {
    return pose.position;
  } else if constexpr (M::angular == 1) {
    return pose.position + Eigen::Rotation2Dd(angle(pose.rotation)) * arm;
  } else {
    return pose.position + pose.rotation.toRotationMatrix() * arm;
  }
}

/// Each kind of constraint between the pair, with random numbers of its own.
template <class M, class F>
void for_each_kind(Random& random, const Pair<M>& pair, F&& f) {
  const Linear<M> normal = random.direction<M>();
  f(Distance<M>{pair.at, random.uniform(0.5, 3)});
  f(NormalisedDistance<M>{pair.at, random.uniform(0.5, 3)});
  f(Pin<M>{pair.at});
  f(Contact<M>{pair.at, normal});
  f(Friction<M>{pair.at, tangents_of<M>(normal), 0.5, 0});
}

/// The pair with body 2 moved so that both anchors are one point.
template <class M>
Pair<M> joined(Pair<M> pair) {
  pair.pose2.position += pair.P1() - pair.P2();
  return pair;
}

template <class M, class Kind>
auto value(const Kind& constraint, const Pair<M>& pair) {
  return constraint.template value<double>(pair.pose1, pair.pose2);
}

TEST_IN_ALL_MODELS(Equation1, VanishesWhereTheConstraintHolds, draws) {
  const auto pair = random_pair<M>(random);
  const double length = (pair.P2() - pair.P1()).norm();
  EXPECT_NEAR(value(Distance<M>{pair.at, length}, pair)[0], 0, rounding);
  EXPECT_NEAR(value(NormalisedDistance<M>{pair.at, length}, pair)[0], 0, rounding);
  const auto touching = joined(pair);
  EXPECT_NEAR(value(Pin<M>{pair.at}, touching).norm(), 0, rounding);
  EXPECT_NEAR(value(Contact<M>{pair.at, random.direction<M>()}, touching)[0], 0, rounding);
}

TEST_IN_ALL_MODELS(Equation1, HearsOfEveryMoveAndTurnOfBothBodies, draws) {
  const auto pair = random_pair<M>(random);
  const Distance<M> rod{pair.at, 1};
  for (int i = 0; i < M::dof; ++i) {
    const Velocity<M> nudge = 0.1 * Velocity<M>::Unit(i);
    auto one = pair, two = pair;
    one.pose1 = moved<M, double>(pair.pose1, nudge, 1.0);
    two.pose2 = moved<M, double>(pair.pose2, nudge, 1.0);
    EXPECT_NE(value(rod, pair)[0], value(rod, one)[0]) << "number " << i << " of body 1";
    EXPECT_NE(value(rod, pair)[0], value(rod, two)[0]) << "number " << i << " of body 2";
  }
}

TEST_IN_ALL_MODELS(Equation2, IsHalfTheDifferenceOfTheSquares, draws) {
  const auto pair = random_pair<M>(random);
  const double length = random.uniform(0.5, 3);
  const double distance =
      (anchor_by_matrix<M>(pair.pose2, pair.at.arms.second) - anchor_by_matrix<M>(pair.pose1, pair.at.arms.first))
          .norm();
  EXPECT_NEAR(value(Distance<M>{pair.at, length}, pair)[0], (distance * distance - length * length) / 2, rounding);
  EXPECT_NEAR(value(NormalisedDistance<M>{pair.at, length}, pair)[0], distance - length, rounding);
}

TEST(Equation2, OfARodOfTwoMetresStretchedByTenCentimetres) {
  Pose<PlaneParticle> anchor, bob;
  bob.position = {0, -2.1};
  EXPECT_NEAR((Distance<PlaneParticle>{{0, 1}, 2}.value(anchor, bob)[0]), 0.205, 1e-15);
  EXPECT_NEAR((NormalisedDistance<PlaneParticle>{{0, 1}, 2}.value(anchor, bob)[0]), 0.1, 1e-15);
}

TEST_IN_ALL_MODELS(Equation3, HoldsWhileBothBodiesMoveAsOne, draws) {
  auto pair = random_pair<M>(random);
  const Linear<M> drift = random.vector<M::linear>(2);
  const Eigen::Vector3d spin =
      M::linear == 2 ? Eigen::Vector3d(0, 0, random.uniform(-3, 3)) : Eigen::Vector3d(random.vector<3>(3));
  const auto carried = [&](const Pose<M>& pose) {
    Eigen::Vector3d x = Eigen::Vector3d::Zero();
    x.head<M::linear>() = pose.position;
    Velocity<M> V;
    V.template head<M::linear>() = drift + spin.cross(x).template head<M::linear>();
    V.template tail<M::angular>() = spin.template tail<M::angular>();
    return V;
  };
  pair.V1 = carried(pair.pose1);
  pair.V2 = carried(pair.pose2);
  const Distance<M> rod{pair.at, 1};
  const NormalisedDistance<M> normalised{pair.at, 1};
  EXPECT_NEAR(rate_by_duals(rod, pair.pose1, pair.V1, pair.pose2, pair.V2)[0], 0, 1e-12);
  EXPECT_NEAR(dot(rod.jacobian(pair.pose1, pair.pose2), pair.V1, pair.V2)[0], 0, 1e-12);
  EXPECT_NEAR(dot(normalised.jacobian(pair.pose1, pair.pose2), pair.V1, pair.V2)[0], 0, 1e-12);
  const auto touching = joined(pair);
  const Velocity<M> V2 = carried(touching.pose2);
  EXPECT_NEAR(dot(Pin<M>{pair.at}.jacobian(touching.pose1, touching.pose2), pair.V1, V2).norm(), 0, 1e-12);
}

TEST_IN_ALL_MODELS(Equation4, RateIsJacobianTimesVelocity, draws) {
  const auto pair = random_pair<M>(random);
  for_each_kind(random, pair, [&](const auto& constraint) {
    const auto rate = rate_by_duals(constraint, pair.pose1, pair.V1, pair.pose2, pair.V2);
    const auto JV = dot(constraint.jacobian(pair.pose1, pair.pose2), pair.V1, pair.V2);
    EXPECT_LE(difference(rate, JV), 1e-12);
  });
}

TEST_IN_ALL_MODELS(Equation4, WhatJacobianTimesVelocityMissesIsOfSecondOrder, draws) {
  const auto pair = random_pair<M>(random);
  const Distance<M> rod{pair.at, 1};
  const double JV = dot(rod.jacobian(pair.pose1, pair.pose2), pair.V1, pair.V2)[0];
  const auto missed = [&](double h) {
    return rod.template value<double>(moved<M, double>(pair.pose1, pair.V1, h),
                                      moved<M, double>(pair.pose2, pair.V2, h))[0] -
           value(rod, pair)[0] - h * JV;
  };
  // Halving h divides the rest by 4 in the limit; what is left of third order falls with h.
  const double h = 1e-3;
  EXPECT_NEAR(missed(h), 4 * missed(h / 2), 100 * h * h * h);
  EXPECT_GT(std::abs(missed(h)), 1e-9);
}

TEST_IN_ALL_MODELS(Equation4, AJointIsASystemOfRows, draws) {
  const auto pair = random_pair<M>(random);
  const Jacobian<M, M::linear> J = Pin<M>{pair.at}.jacobian(pair.pose1, pair.pose2);
  static_assert(Pin<M>::rows == M::linear);
  for (int k = 0; k < Pin<M>::rows; ++k) {
    const Contact<M> along_axis{pair.at, Linear<M>::Unit(k)};
    EXPECT_EQ(difference(Dense(J.matrix).row(k), along_axis.jacobian(pair.pose1, pair.pose2).matrix), 0);
  }
}

/// Ċ of the squared rod as each line of the derivation writes it.
template <class M>
struct Derivation {
  double differentiated, by_points, by_bodies, term_by_term, isolated;

  explicit Derivation(const Pair<M>& pair) {
    const Linear<M> d = pair.P2() - pair.P1();
    const Linear<M> v1 = linear_part<M>(pair.V1), v2 = linear_part<M>(pair.V2);
    const Linear<M> turn1 = turning<M>(pair.V1, pair.r1()), turn2 = turning<M>(pair.V2, pair.r2());
    const Angular<M> w1 = pair.V1.template tail<M::angular>(), w2 = pair.V2.template tail<M::angular>();
    // A pin's C is P2 - P1, so that its rate is the difference of the two Ṗ.
    const Linear<M> point_rates = rate_by_duals(Pin<M>{pair.at}, pair.pose1, pair.V1, pair.pose2, pair.V2);
    differentiated = rate_by_duals(Distance<M>{pair.at, 1}, pair.pose1, pair.V1, pair.pose2, pair.V2)[0];
    by_points = d.dot(point_rates);
    by_bodies = d.dot((v2 + turn2) - (v1 + turn1));
    term_by_term = (d.dot(v2) + d.dot(turn2)) - (d.dot(v1) + d.dot(turn1));
    isolated = (d.dot(v2) + w2.dot(cross(pair.r2(), d))) - (d.dot(v1) + w1.dot(cross(pair.r1(), d)));
  }
};

TEST_IN_ALL_MODELS(Equation9, IsTheRateOfTheSquare, draws) {
  const Derivation<M> rate(random_pair<M>(random));
  EXPECT_NEAR(rate.by_points, rate.differentiated, 1e-12);
}

TEST_IN_ALL_MODELS(Equation10, PutsEachPointOnItsBody, draws) {
  const Derivation<M> rate(random_pair<M>(random));
  EXPECT_NEAR(rate.by_bodies, rate.by_points, 1e-12);
}

TEST_IN_ALL_MODELS(Equation11, IsTheSeparationOfTheAnchors, draws) {
  const auto pair = random_pair<M>(random);
  const Linear<M> P1 = anchor_by_matrix<M>(pair.pose1, pair.at.arms.first);
  const Linear<M> P2 = anchor_by_matrix<M>(pair.pose2, pair.at.arms.second);
  const Linear<M> d = pair.at.template separation<double>(pair.pose1, pair.pose2);
  EXPECT_LE(difference(d, P2 - P1), rounding);
}

TEST_IN_ALL_MODELS(Equation12, IsTheSumOfFourTerms, draws) {
  const Derivation<M> rate(random_pair<M>(random));
  EXPECT_NEAR(rate.term_by_term, rate.by_bodies, 1e-12);
}

TEST_IN_ALL_MODELS(Equation13, IsolatesTheVelocitiesByTheTripleProduct, draws) {
  const auto pair = random_pair<M>(random);
  const Derivation<M> rate(pair);
  EXPECT_NEAR(rate.isolated, rate.term_by_term, 1e-12);
  const auto J = Distance<M>{pair.at, 1}.jacobian(pair.pose1, pair.pose2);
  EXPECT_NEAR(dot(J, pair.V1, pair.V2)[0], rate.isolated, 1e-12);
}

TEST_IN_ALL_MODELS(Equation14, DistanceJacobianIsTheGradientOfC, draws) {
  const auto pair = random_pair<M>(random);
  const Distance<M> rod{pair.at, random.uniform(0.5, 3)};
  const NormalisedDistance<M> normalised{pair.at, random.uniform(0.5, 3)};
  EXPECT_LE(
      difference(rod.jacobian(pair.pose1, pair.pose2).matrix, gradient_by_duals(rod, pair.pose1, pair.pose2)),
      rounding);
  EXPECT_LE(difference(normalised.jacobian(pair.pose1, pair.pose2).matrix,
                       gradient_by_duals(normalised, pair.pose1, pair.pose2)),
            rounding);
}

/// Checks the row that (14)-(16) share against its four parts as they are printed.
template <class M, int K>
void expect_row_along(const Jacobian<M, K>& J, int k, const Linear<M>& u, const Pair<M>& pair) {
  const Angular<M> lever1 = cross(pair.r1(), u), lever2 = cross(pair.r2(), u);
  Dense printed(2 * M::dof, 1);
  printed.set_block(0, 0, -1 * Dense(u));
  printed.set_block(M::linear, 0, -1 * Dense(lever1));
  printed.set_block(M::dof, 0, u);
  printed.set_block(M::dof + M::linear, 0, lever2);
  EXPECT_LE(difference(Dense(J.matrix).row(k), printed.transposed()), rounding);
}

TEST_IN_ALL_MODELS(Equation14, HasTheFourPartsOfThePage, draws) {
  const auto pair = random_pair<M>(random);
  const Linear<M> d = pair.P2() - pair.P1();
  expect_row_along<M>(Distance<M>{pair.at, 1}.jacobian(pair.pose1, pair.pose2), 0, d, pair);
  expect_row_along<M>(NormalisedDistance<M>{pair.at, 1}.jacobian(pair.pose1, pair.pose2), 0,
                      Linear<M>(d / d.norm()), pair);
}

TEST_IN_ALL_MODELS(Equation14, PointsWhereTheRodGrows, draws) {
  const auto pair = random_pair<M>(random);
  const Distance<M> rod{pair.at, 1};
  const Velocity<M> uphill = rod.jacobian(pair.pose1, pair.pose2).side2().transpose();
  const auto further = rod.template value<double>(pair.pose1, moved<M, double>(pair.pose2, uphill, 1e-4));
  EXPECT_GT(further[0], value(rod, pair)[0]);
}

TEST_IN_ALL_MODELS(Equation14, ChangesOnlyItsSidesWhenTheBodiesAreSwapped, draws) {
  const auto pair = random_pair<M>(random);
  const auto swapped_arms = [&] {
    Anchors<M> at = pair.at;
    if constexpr (M::angular > 0) std::swap(at.arms.first, at.arms.second);
    return at;
  };
  const auto J = Distance<M>{pair.at, 1}.jacobian(pair.pose1, pair.pose2);
  const auto swapped = Distance<M>{swapped_arms(), 1}.jacobian(pair.pose2, pair.pose1);
  EXPECT_EQ(difference(J.side1(), swapped.side2()), 0);
  EXPECT_EQ(difference(J.side2(), swapped.side1()), 0);
}

TEST_IN_ALL_MODELS(Equation15, ContactJacobianIsTheGradientOfCWithTheNormalHeldStill, draws) {
  const auto pair = random_pair<M>(random);
  const Contact<M> contact{pair.at, random.direction<M>()};
  const auto J = contact.jacobian(pair.pose1, pair.pose2);
  EXPECT_LE(difference(J.matrix, gradient_by_duals(contact, pair.pose1, pair.pose2)), rounding);
  expect_row_along<M>(J, 0, contact.normal, pair);
}

TEST_IN_ALL_MODELS(Equation15, TurnsRoundWithTheNormal, draws) {
  const auto pair = random_pair<M>(random);
  const Linear<M> n = random.direction<M>();
  const Dense J = Contact<M>{pair.at, n}.jacobian(pair.pose1, pair.pose2).matrix;
  const Dense turned = Contact<M>{pair.at, -n}.jacobian(pair.pose1, pair.pose2).matrix;
  EXPECT_EQ(difference(J, -1 * turned), 0);
}

TEST_IN_ALL_MODELS(Equation16, FrictionJacobianIsTheGradientOfTheSlip, draws) {
  const auto pair = random_pair<M>(random);
  const Friction<M> friction{pair.at, tangents_of<M>(random.direction<M>()), 0.5, 0};
  static_assert(Friction<M>::rows == M::linear - 1, "one axis in the plane, two in space");
  const auto J = friction.jacobian(pair.pose1, pair.pose2);
  EXPECT_LE(difference(J.matrix, gradient_by_duals(friction, pair.pose1, pair.pose2)), rounding);
  for (int k = 0; k < Friction<M>::rows; ++k) expect_row_along<M>(J, k, Linear<M>(friction.tangents.col(k)), pair);
}

TEST_IN_ALL_MODELS(Equation16, OnOneAxisByItselfIsThatRowOfFriction, draws) {
  const auto pair = random_pair<M>(random);
  const auto tangents = tangents_of<M>(random.direction<M>());
  const auto both = Friction<M>{pair.at, tangents, 0.5, 0}.jacobian(pair.pose1, pair.pose2);
  for (int k = 0; k < M::linear - 1; ++k) {
    const AxisFriction<M> friction{pair.at, tangents.col(k), 0.5, 0};
    const auto J = friction.jacobian(pair.pose1, pair.pose2);
    EXPECT_EQ(difference(J.matrix, Dense(both.matrix).row(k)), 0);
    EXPECT_LE(difference(J.matrix, gradient_by_duals(friction, pair.pose1, pair.pose2)), rounding);
  }
}

TEST_IN_ALL_MODELS(Equation16, AxesAreOrthonormalAndTouchTheSurface, draws) {
  const Linear<M> n = random.direction<M>();
  Eigen::Matrix<double, M::linear, M::linear> axes;
  axes << tangents_of<M>(n), n;
  EXPECT_LE(difference(Dense(axes).transposed() * axes, axes.Identity()), rounding);
  EXPECT_NEAR(axes.determinant(), 1, rounding) << "right-handed with the normal";
}

TEST_IN_ALL_MODELS(Equation23, IsTheSeparationAlongTheNormalFromBody1ToBody2, draws) {
  const auto pair = random_pair<M>(random);
  const Linear<M> n = random.direction<M>();
  const double as_printed = -pair.pose1.position.dot(n) - (pair.P1() - pair.pose1.position).dot(n) +  //
                            pair.pose2.position.dot(n) + (pair.P2() - pair.pose2.position).dot(n);
  EXPECT_NEAR(value(Contact<M>{pair.at, n}, pair)[0], as_printed, rounding);
  auto touching = joined(pair);
  touching.pose2.position += 0.3 * n;
  EXPECT_NEAR(value(Contact<M>{pair.at, n}, touching)[0], 0.3, rounding) << "apart";
  touching.pose2.position -= 0.4 * n;
  EXPECT_NEAR(value(Contact<M>{pair.at, n}, touching)[0], -0.1, rounding) << "overlapping";
}

TEST_IN_ALL_MODELS(Pin, JacobianIsTheGradientOfC, draws) {
  const auto pair = random_pair<M>(random);
  const Pin<M> pin{pair.at};
  EXPECT_LE(
      difference(pin.jacobian(pair.pose1, pair.pose2).matrix, gradient_by_duals(pin, pair.pose1, pair.pose2)),
      rounding);
}

TEST_IN_ALL_MODELS(Pin, HoldsTheWorldPointItWasMadeAt, draws) {
  auto pair = random_pair<M>(random);
  const Linear<M> point = random.vector<M::linear>(2);
  if constexpr (M::angular == 0) pair.pose1.position = pair.pose2.position = point;
  const Pin<M> made = pin<M>(pair.bodies(), 0, 1, point);
  EXPECT_NEAR(value(made, pair).norm(), 0, rounding);
  EXPECT_LE(difference(anchor_by_matrix<M>(pair.pose1, made.at.arms.first), point), rounding);
  EXPECT_LE(difference(anchor_by_matrix<M>(pair.pose2, made.at.arms.second), point), rounding);
}

}  // namespace equations_derivation_test
