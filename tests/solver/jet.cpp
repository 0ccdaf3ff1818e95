#include "solver/integrate/jet.hpp"

#include <functional>
#include <vector>

#include "solver/constraints/distance.hpp"
#include "solver/constraints/hinge.hpp"
#include "solver/constraints/normalised_distance.hpp"
#include "solver/constraints/slider.hpp"
#include "solver/constraints/weld.hpp"
#include "tests/solver/compiled.hpp"
#include "tests/solver/random.hpp"

namespace jet_test {

using namespace byhand;

void expect_near(const Jet& a, const Jet& b, double tolerance) {
  EXPECT_NEAR(a.at, b.at, tolerance);
  EXPECT_NEAR(a.rate, b.rate, tolerance);
  EXPECT_NEAR(a.bend, b.bend, tolerance);
}

TEST(Jet, DerivativesOfPowersRootsAndQuotientsAreThoseOfSchool) {
  const double t = 1.7;
  const Jet time(t, 1, 0);
  expect_near(time * time * time, {t * t * t, 3 * t * t, 6 * t}, 1e-14);
  expect_near(1.0 / time, {1 / t, -1 / (t * t), 2 / (t * t * t)}, 1e-15);
  const double r = std::sqrt(t);
  expect_near(sqrt(time), {r, 1 / (2 * r), -1 / (4 * t * r)}, 1e-15);
  expect_near(-time + 3.0 - time * 2.0, {3 - 3 * t, -3, 0}, 1e-15);
}

TEST(Jet, WhatIsDoneCanBeUndone) {
  Random random;
  for (int i = 0; i < 100; ++i) {
    const auto jet = [&] { return Jet(random.uniform(1, 3), random.uniform(-2, 2), random.uniform(-2, 2)); };
    const Jet a = jet(), b = jet();
    expect_near(a * b / b, a, 1e-13);
    expect_near(sqrt(a) * sqrt(a), a, 1e-14);
    expect_near(sqrt(a * a), a, 1e-13);
    expect_near((a + b) - b, a, 1e-14);
  }
}

template <class M>
struct Paths {
  explicit Paths(const Pair<M>& pair)
      : first(on_its_way<M>(pair.pose1, pair.V1)), second(on_its_way<M>(pair.pose2, pair.V2)) {}
  Pose<M, Jet> first, second;
};

/// The rows of C along a path, whose value at a time is `at`: its first derivative against JV, and its second
/// against differences of C of fourth order.
void expect_rows(const std::vector<Jet>& C, const Dense& JV, const Dense& bias,
                 const std::function<Dense(double)>& at) {
  const double e = 1e-3;
  const Dense now = at(0);
  const Dense second = 1 / (12 * e * e) * (16 * (at(e) + at(-e)) - at(2 * e) - at(-2 * e) - 30 * now);
  for (int k = 0; k < now.rows(); ++k) {
    EXPECT_NEAR(C[k].at, now(k, 0), 1e-13);
    EXPECT_NEAR(C[k].rate, JV(k, 0), 1e-12 * (1 + std::abs(JV(k, 0))));
    EXPECT_NEAR(bias(k, 0), second(k, 0), 1e-7 * (1 + std::abs(bias(k, 0)))) << "row " << k;
  }
}

template <class Kind, class M>
void expect_derivatives(const Kind& kind, const Pair<M>& pair) {
  const Paths<M> paths(pair);
  const auto C = kind.template value<Jet>(paths.first, paths.second);
  expect_rows({C.begin(), C.end()}, dot(kind.jacobian(pair.pose1, pair.pose2), pair.V1, pair.V2),
              bias_acceleration<Kind, M>(kind, paths.first, paths.second), [&](double time) {
                return kind.template value<double>(moved<M, double>(pair.pose1, pair.V1, time),
                                                   moved<M, double>(pair.pose2, pair.V2, time));
              });
}

TEST_IN_ALL_MODELS(BiasAcceleration, IsTheSecondDerivativeAtConstantVelocityOfRods, 20) {
  const auto pair = random_pair<M>(random);
  expect_derivatives(Distance<M>{pair.at, 1.3}, pair);
  if ((pair.P2() - pair.P1()).norm() > 0.5) expect_derivatives(NormalisedDistance<M>{pair.at, 1.3}, pair);
}

TEST_IN_BOTH_BODIES(BiasAcceleration, IsTheSecondDerivativeAtConstantVelocityOfJoints, 20) {
  const auto pair = random_pair<M>(random);
  const Bodies<M> bodies = pair.bodies();
  const Linear<M> point = random.vector<M::linear>(2), axis = random.direction<M>();
  auto moved = pair;  // from where the joint holds
  move<M, double>(moved.pose1, pair.V2, 0.1);
  move<M, double>(moved.pose2, pair.V1, 0.1);
  expect_derivatives(pin<M>(bodies, 0, 1, point), moved);
  expect_derivatives(weld<M>(bodies, 0, 1, point), moved);
  expect_derivatives(slider<M>(bodies, 0, 1, point, axis), moved);
  if constexpr (M::angular == 3) expect_derivatives(hinge<M>(bodies, 0, 1, point, axis), moved);
}

// C = ½(d² - L²): C̈ = |ḋ|² + d·d̈, and d̈ is the arms' ω × (ω × r) alone.
TEST_IN_ALL_MODELS(BiasAcceleration, OfARodIsItsEndsSpeedSquaredAndTheirPullInwards, 50) {
  const auto pair = random_pair<M>(random);
  const Paths<M> paths(pair);
  const Linear<M> d = pair.P2() - pair.P1();
  Linear<M> d_rate = pair.V2.template head<M::linear>() - pair.V1.template head<M::linear>();
  Linear<M> d_bend = Linear<M>::Zero();
  const auto turn = [&](const auto& r, const Velocity<M>& V, double sign) {
    if constexpr (M::angular == 1) {
      const double w = V[2];
      d_rate += sign * w * Linear<M>(-r.y(), r.x());
      d_bend -= sign * w * w * r;
    }
    if constexpr (M::angular == 3) {
      const Linear<M> w = V.template tail<3>();
      d_rate += sign * w.cross(r);
      d_bend += sign * w.cross(w.cross(r));
    }
  };
  turn(pair.r2(), pair.V2, 1);
  turn(pair.r1(), pair.V1, -1);
  const double expected = d_rate.squaredNorm() + d.dot(d_bend);
  const double bias = bias_acceleration<Distance<M>, M>({pair.at}, paths.first, paths.second)[0];
  EXPECT_NEAR(bias, expected, 1e-12 * (1 + std::abs(expected)));
}

}  // namespace jet_test
