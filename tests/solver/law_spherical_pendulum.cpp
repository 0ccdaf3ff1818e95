#include <gtest/gtest.h>

#include "lessons/exact/spherical_pendulum.hpp"
#include "lessons/scenes/spherical_pendulum.hpp"
#include "tests/solver/law_motion.hpp"

namespace law_spherical_pendulum_test {

using namespace byhand;
constexpr double angle = 1.2, azimuth_rate = 2.5, length = 1.5, g = 9.81;

struct Measured {
  double angle = 0, azimuth = 0;           // after two seconds [rad]
  double lowest = 4, momentum_change = 0;  // its other cone [rad]; about the vertical, relative
};

template <class M>
Measured after_two_seconds(double h) {
  Simulation<M> simulation{spherical_pendulum<M>(angle, azimuth_rate, length, 3), {Direct{}, Baumgarte{1}}};
  const auto& bodies = simulation.scene.bodies();
  const double momentum = angular_momentum(bodies)[1];
  Measured measured;
  Eigen::Vector3d before = bodies.pose[1].position;
  run(simulation, 2, h, [&] {
    const Eigen::Vector3d x = bodies.pose[1].position;
    measured.azimuth +=
        std::atan2(before.z() * x.x() - before.x() * x.z(), before.x() * x.x() + before.z() * x.z());
    measured.angle = std::acos(-x.y() / x.norm());
    measured.lowest = std::min(measured.lowest, measured.angle);
    measured.momentum_change =
        std::max(measured.momentum_change, std::abs(angular_momentum(bodies)[1] / momentum - 1));
    before = x;
  });
  return measured;
}

template <class M>
void expect_exact() {
  const SphericalPendulum exact(angle, azimuth_rate, length, g);
  const auto [theta, phi, theta_rate, phi_rate, uncertainty] = exact.at(2);
  EXPECT_LT(exact.nutation_period(), 2);
  const Measured coarse = after_two_seconds<M>(1.0 / 480), fine = after_two_seconds<M>(1.0 / 960);
  EXPECT_NEAR(fine.angle, theta, 1e-2);
  EXPECT_NEAR(fine.azimuth, phi, 1e-2);
  EXPECT_NEAR(fine.lowest, exact.other_angle(), 1e-2);
  EXPECT_NEAR(order(coarse.angle - theta, fine.angle - theta), 1, 0.3);
  EXPECT_LT(fine.momentum_change, 1e-2);
}

TEST(LawA3, AParticleOnARodNutatesBetweenItsCones) { expect_exact<SpaceParticle>(); }
TEST(LawA3, SoDoesABodyThatTheRodHoldsByItsCentre) { expect_exact<SpaceBody>(); }

}  // namespace law_spherical_pendulum_test
