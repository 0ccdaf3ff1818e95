#include <gtest/gtest.h>

#include <numbers>

#include "solver/constraints/limit.hpp"
#include "solver/constraints/pin.hpp"
#include "tests/solver/dual.hpp"
#include "tests/solver/law_motion.hpp"
#include "tests/solver/random.hpp"

// Stops on the twist of two bodies in space: p and −p are one orientation.
namespace joints_twist_test {

using namespace byhand;
using M = SpaceBody;
constexpr double pi = std::numbers::pi, h = 1.0 / 240;

Pose<M> opposite(Pose<M> pose) {
  pose.rotation.coeffs() *= -1;
  return pose;
}

/// The twist about an axis that both bodies have, counted from equal orientations.
Turn<M> twist_about(const Linear<M>& axis) { return {0, 1, Pose<M>().rotation, axis}; }

/// A body that is twisted about `axis` by φ and then swung by ψ about `across`, as `torso` sees it.
Pose<M> twisted(const Pose<M>& torso, const Linear<M>& axis, double phi, const Linear<M>& across, double psi) {
  Pose<M> pose;
  pose.rotation =
      torso.rotation * space_rotation(Angular<M>(psi * across)) * space_rotation(Angular<M>(phi * axis));
  return pose;
}

// Just within half a turn and just beyond: w changes its sign there, and φ jumps from π to -π.
TEST(TwistLimit, ReadsTheShorterWayRoundOnBothSidesOfHalfATurn) {
  Random random;
  for (int i = 0; i < 100; ++i) {
    const Pose<M> torso = random.pose<M>();
    const Linear<M> axis = random.direction<M>(), across = tangents_of<M>(axis).col(0);
    const double psi = random.uniform(0, 2.5);
    for (const double phi : {-pi + 0.01, -0.5, 0.0, 1.0, pi - 0.01, pi + 0.01, 2 * pi - 0.5}) {
      const Pose<M> arm = twisted(torso, axis, phi, across, psi);
      const double expected = std::remainder(phi, 2 * pi);
      for (const auto& [one, two] : {std::pair{torso, arm}, std::pair{opposite(torso), arm}})
        ASSERT_NEAR(twist_about(axis).value<double>(one, two), expected, 1e-11) << "of " << phi << " at " << psi;
    }
  }
}

TEST(TwistLimit, JacobianIsTheGradientOfC) {
  Random random;
  int with_negative_w = 0;
  for (int i = 0; i < 200; ++i) {
    const Pose<M> torso = random.pose<M>();
    const Linear<M> axis = random.direction<M>(), across = tangents_of<M>(axis).col(0);
    const Pose<M> arm = twisted(torso, axis, random.uniform(-3, 3), across, random.uniform(-2.5, 2.5));
    const Linear<M> a = rotate(torso.rotation, axis), b = rotate(arm.rotation, axis);
    for (const Pose<M>& seen : {arm, opposite(arm)}) {
      with_negative_w += (inverse(torso.rotation) * seen.rotation).w() < 0;
      for (const auto& stop : {at_least<M>(-0.5, twist_about(axis)), at_most<M>(0.5, twist_about(axis))}) {
        const auto J = stop.jacobian(torso, seen);
        ASSERT_LE(difference(J.matrix, gradient_by_duals(stop, torso, seen)), 1e-11);
        const Linear<M> g = (a + b) / (1 + a.dot(b)) * (stop.stop == Stop::lower ? 1 : -1);
        ASSERT_LE((J.matrix.row(0).tail<3>().transpose() - g).norm(), 1e-11);
      }
    }
  }
  EXPECT_EQ(with_negative_w, 200);
}

// There is no twist to speak of, whichever way the body has gone over: φ and its row are zero, not NaN.
TEST(TwistLimit, HasNoRowAtHalfATurnAboutAnAxisAcross) {
  const Pose<M> torso;
  Pose<M> arm;
  arm.rotation = Rotation<M>(0, 1, 0, 0);
  const Turn<M> twist = twist_about(Linear<M>::Unit(2));
  EXPECT_EQ(twist.value<double>(torso, arm), 0);
  EXPECT_TRUE(twist.jacobian(torso, arm).matrix.isZero(0));
}

// 1 mrad before its stop an arm at rest feels nothing; 1 mrad beyond it is pushed back, whichever sign its
// orientation has.
TEST(TwistLimit, PushesOnlyBeyondItsStopAndOnlyBack) {
  constexpr double stop = 0.8;
  for (const double sign : {1.0, -1.0})
    for (const double side : {-1.0, 1.0})
      for (const double beyond : {-1e-3, 1e-3}) {
        Scene<M> scene;
        scene.gravity.setZero();
        Pose<M> torso, arm;
        torso.rotation.coeffs() *= sign;
        arm.rotation = space_rotation(Angular<M>(side * (stop + beyond), 0, 0));
        scene.add_body(torso, fixed<M>());
        scene.add_body(arm, box<M>(2, {0.6, 0.2, 0.1}));
        const auto twist = twist_about(Linear<M>::UnitX());
        scene.add(pin<M>(scene.bodies(), 0, 1, Linear<M>::Zero()));
        scene.add(at_least<M>(-stop, twist));
        scene.add(at_most<M>(stop, twist));
        Simulation<M> simulation{std::move(scene), {Direct{}, Baumgarte{0.2}}};
        simulation.step(h);
        EXPECT_NEAR(simulation.scene.bodies().velocity[1][3], beyond > 0 ? -side * 0.2 * beyond / h : 0, 1e-9)
            << "sign " << sign << ", side " << side << ", beyond by " << beyond;
      }
}

}  // namespace joints_twist_test
