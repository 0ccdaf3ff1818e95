#include <gtest/gtest.h>

#include <functional>
#include <numbers>

#include "lessons/exact/compound_pendulum.hpp"
#include "lessons/exact/free_top.hpp"
#include "lessons/exact/simple_pendulum.hpp"
#include "lessons/exact/spherical_pendulum.hpp"
#include "lessons/methods/accelerations.hpp"
#include "lessons/methods/generalised.hpp"
#include "lessons/methods/rattle.hpp"
#include "lessons/scenes/spherical_pendulum.hpp"
#include "lessons/scenes/top.hpp"
#include "tests/solver/law_motion.hpp"

// The order of each method: the slope of its error over its step, fitted over four steps, of particles and bodies,
// in the plane and in space, wherever the exact motion is known.
namespace orders_test {

using namespace byhand;
constexpr double g = 9.81, pi = std::numbers::pi;

const VelocityStepping symplectic_euler{
    .solver = Direct{}, .drift = Baumgarte{1}, .gyroscopic = Gyroscopic::implicit};
const Accelerations explicit_euler{Scheme::explicit_euler}, rk4{Scheme::rk4}, midpoint{Scheme::implicit_midpoint};

/// The slope of log(error) over log(h) by least squares; each step is half of the one before [s].
double fitted_order(double longest_step, const std::function<double(double)>& error) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (double h = longest_step; n < 4; h /= 2) {
    const double u = std::log(h), v = std::log(error(h));
    n += 1, x += u, y += v, xx += u * u, xy += u * v;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

/// Asserts all orders, by the error that `at_one_second(simulation)` finds in a scene that has run for one second.
template <class M, class F>
void expect_orders(const Scene<M>& scene, F&& at_one_second) {
  const auto order_of = [&](const auto& method, double longest_step) {
    return fitted_order(longest_step, [&](double h) {
      Simulation simulation{scene, method};
      run(simulation, 1, h);
      return at_one_second(simulation.scene.bodies());
    });
  };
  EXPECT_NEAR(order_of(symplectic_euler, 1.0 / 500), 1, 0.05);
  EXPECT_NEAR(order_of(explicit_euler, 1.0 / 2000), 1, 0.05);
  EXPECT_NEAR(order_of(midpoint, 1.0 / 100), 2, 0.05);
  EXPECT_NEAR(order_of(Rattle{}, 1.0 / 100), 2, 0.05);
  EXPECT_NEAR(order_of(rk4, 1.0 / 50), 4, 0.15);
  EXPECT_NEAR(order_of(Generalised{}, 1.0 / 50), 4, 0.15);
  EXPECT_NEAR(order_of(Generalised{JointRule::semi_implicit_euler}, 1.0 / 500), 1, 0.05);
}

TEST(Orders, OfAParticleOnARodInThePlane) {
  const SimplePendulum exact(pi / 2, 2, g);
  expect_orders(pendulum<PlaneParticle>(pi / 2, 2, 3), [&](const Bodies<PlaneParticle>& bodies) {
    return (bodies.pose[1].position - 2 * from_straight_down<PlaneParticle>(exact.angle(1))).norm();
  });
}

TEST(Orders, OfABodyOnAHingeInThePlane) {
  const CompoundPendulum exact(2, 2, 3, g);
  expect_orders(hinged_rod<PlaneBody>(2, 2, 3), [&](const Bodies<PlaneBody>& bodies) {
    return (bodies.pose[1].position - from_straight_down<PlaneBody>(exact.angle(1))).norm() +
           std::abs(bodies.velocity[1][2] - exact.angular_velocity(1));
  });
}

TEST(Orders, OfAParticleOnARodInSpace) {
  const SphericalPendulum exact(1.2, 2.5, 2, g);
  const auto [angle, azimuth, angle_rate, azimuth_rate, uncertainty] = exact.at(1);
  const Eigen::Vector3d position = 2 * Eigen::Vector3d(std::sin(angle) * std::cos(azimuth), -std::cos(angle),
                                                       -std::sin(angle) * std::sin(azimuth));
  expect_orders(spherical_pendulum<SpaceParticle, Distance>(1.2, 2.5, 2, 3),
                [&](const Bodies<SpaceParticle>& bodies) { return (bodies.pose[1].position - position).norm(); });
}

// It keeps its lean and precesses, so that its whole state is known.
TEST(Orders, OfAHeavyTopInSpace) {
  const HeavyTop top{.mass = 2, .arm = 0.3, .moment_along = 0.08, .moment_across = 0.25, .spin = 40};
  const double lean = 0.7, rate = top.precession(lean)[0];
  const Eigen::Vector3d axis(std::sin(lean) * std::cos(rate), std::cos(lean), -std::sin(lean) * std::sin(rate));
  expect_orders(spinning_top(top, lean, rate), [&](const Bodies<SpaceBody>& bodies) {
    return (bodies.pose[1].position - top.arm * axis).norm();
  });
}

// Without a constraint what is left is how a body turns: here about all three axes.
TEST(Orders, OfAFreeBodyInSpace) {
  const Eigen::Vector3d moments(1, 2, 3), spin(3, -2, 4), exact = FreeTop(moments, spin).at(1).value;
  const auto scene = free_top(moments, spin);
  const Eigen::Vector3d momentum = angular_momentum(scene.bodies());
  const auto order_of = [&](const auto& method, double longest_step) {
    return fitted_order(longest_step, [&](double h) {
      Simulation simulation{scene, method};
      run(simulation, 1, h);
      const Bodies<SpaceBody>& bodies = simulation.scene.bodies();
      const Eigen::Vector3d omega = bodies.velocity[0].tail<3>();
      return (rotate(inverse(bodies.pose[0].rotation), omega) - exact).norm() +
             (angular_momentum(bodies) - momentum).norm();
    });
  };
  EXPECT_NEAR(order_of(midpoint, 1.0 / 100), 2, 0.05);
  EXPECT_NEAR(order_of(Rattle{}, 1.0 / 100), 2, 0.05);
  EXPECT_NEAR(order_of(rk4, 1.0 / 100), 4, 0.15);
  EXPECT_NEAR(order_of(Generalised{}, 1.0 / 100), 4, 0.15);
}

}  // namespace orders_test
