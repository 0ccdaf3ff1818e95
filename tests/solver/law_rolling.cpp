#include <gtest/gtest.h>

#include "lessons/methods/avbd.hpp"
#include "lessons/methods/xpbd.hpp"
#include "lessons/scenes/boxes.hpp"
#include "tests/solver/law_motion.hpp"

// Discs in the plane and balls in space that roll and slide, by every family of methods that takes contacts. The
// moment of inertia is k m r², k = 1/2 for the disc and 2/5 for the ball; closed forms from Coulomb's friction.
namespace law_rolling_test {

using namespace byhand;
constexpr double g = 9.81, h = 1.0 / 60, r = 0.3, mass = 2;

template <class M>
constexpr double k = M::linear == 2 ? 0.5 : 0.4;

/// Forward along the ground, and the spin that goes with it, which is about -z.
template <class M>
Velocity<M> moving(double speed, double spin) {
  Velocity<M> V = Velocity<M>::Zero();
  V[0] = speed;
  V[M::dof - 1] = -spin;
  return V;
}

/// A ball that touches a slope of `angle` [rad] down towards +x. Body 0 is the slope, body 1 the ball.
template <class M>
Scene<M> ball_on_slope(double angle, double friction, const Velocity<M>& velocity) {
  const Linear<M> up = std::sin(angle) * Linear<M>::Unit(0) + std::cos(angle) * Linear<M>::Unit(1);
  Scene<M> scene;
  add_ground(scene, {friction}, up);
  const int body = scene.add_body(Linear<M>(r * up), ball<M>(mass, r), velocity);
  scene.set_shape(body, Ball<M>{r}, {friction});
  return scene;
}

template <class M>
struct Ended {
  double x, height, speed, spin;
};
template <class M, class Method>
Ended<M> after(double time, const Scene<M>& scene, const Method& method, double step = h) {
  Simulation simulation{scene, method};
  run(simulation, time, step);
  const auto& bodies = simulation.scene.bodies();
  return {bodies.pose[1].position.x(), bodies.pose[1].position.y(), bodies.velocity[1][0],
          -bodies.velocity[1][M::dof - 1]};
}

/// How far a ball at rest sinks into the ground: springs of angular frequency ω give way by g/ω².
double sag(const VelocityStepping& method) {
  const auto* soft = std::get_if<SoftConstraints>(&method.drift);
  return soft ? g / (soft->frequency * soft->frequency) : 0;
}
double sag(const auto&) { return 0; }

/// Calls f(method, name) for one or more methods of each family, with this many substeps.
void for_each_family(int substeps, auto&& f) {
  const auto stepping = [&](const RowSolver& solver, const DriftCure& cure, const char* name) {
    f(VelocityStepping{.solver = solver, .drift = cure, .substeps = substeps}, name);
  };
  stepping(ByGraph{}, Baumgarte{.slop = 0.001}, "default");
  stepping(GaussSeidel{}, Baumgarte{}, "Gauss-Seidel, Baumgarte");
  stepping(Direct{}, NoDriftCure{}, "direct, no cure");
  stepping(GaussSeidel{}, SplitImpulse{}, "Gauss-Seidel, split impulse");
  stepping(GaussSeidel{}, Projection{}, "Gauss-Seidel, projection");
  stepping(GaussSeidel{}, SoftConstraints{}, "Gauss-Seidel, soft");
  stepping(GaussSeidel{}, SoftConstraints{.refresh = false}, "Gauss-Seidel, soft, rows kept");
  f(Xpbd{.substeps = substeps}, "XPBD");
  if (substeps == 1) f(Avbd{}, "AVBD");
}

template <class M>
class Rolling : public testing::Test {};
using Bodies = testing::Types<PlaneBody, SpaceBody>;
TYPED_TEST_SUITE(Rolling, Bodies);

TYPED_TEST(Rolling, ABallKeepsItsSpeedAndHeightForAMinute) {
  using M = TypeParam;
  for (const int substeps : {1, 2, 7, 32})
    for (const double speed : {0.003, 0.1, 1.0, 5.0})
      for_each_family(substeps, [&](const auto& method, const char* name) {
        const auto end = after(60, ball_on_slope<M>(0, 0.5, moving<M>(speed, speed / r)), method);
        EXPECT_NEAR(end.speed, speed, 1e-3 * speed) << name << ", " << substeps << " substeps";
        EXPECT_NEAR(end.spin * r, speed, 1e-3 * speed) << name << ", " << substeps << " substeps";
        EXPECT_NEAR(end.height, r - sag(method), 1e-4 * r)
            << name << ", " << substeps << " substeps, " << speed << " m/s";
      });
}

TYPED_TEST(Rolling, ALaunchedBallSlidesUntilItRolls) {
  using M = TypeParam;
  const double mu = 0.2, v0 = 6, rolls_at = v0 / (1 + k<M>), until = k<M> / (1 + k<M>)*v0 / (mu * g),
               way = 0.5 * (v0 + rolls_at) * until, time = 2;
  ASSERT_LT(until, time);
  for (const int substeps : {1, 8})
    for_each_family(substeps, [&](const auto& method, const char* name) {
      const auto end = after(time, ball_on_slope<M>(0, mu, moving<M>(v0, 0)), method);
      EXPECT_NEAR(end.speed, rolls_at, 1e-3 * v0) << name << ", " << substeps << " substeps";
      EXPECT_NEAR(end.spin * r, rolls_at, 1e-3 * v0) << name << ", " << substeps << " substeps";
      EXPECT_NEAR(end.x, way + rolls_at * (time - until), 0.6 * mu * g * until * h / substeps + 1e-3 * v0 * time)
          << name << ", " << substeps << " substeps";
    });
}

TYPED_TEST(Rolling, OnASlopeItRollsUpToAnAngleAndSlidesBeyond) {
  using M = TypeParam;
  const double mu = 0.2, critical = std::atan(mu * (1 + k<M>) / k<M>), time = 1;
  for (const int substeps : {1, 8})
    for (const double share : {0.5, 0.98, 1.02, 1.3})
      for_each_family(substeps, [&](const auto& method, const char* name) {
        const double angle = share * critical, a = g * std::sin(angle);
        const double slides = a - mu * g * std::cos(angle), spins = mu * g * std::cos(angle) / k<M>;
        const double expected = share < 1 ? a / (1 + k<M>) : slides;
        const auto end = after(time, ball_on_slope<M>(angle, mu, moving<M>(0, 0)), method);
        EXPECT_NEAR(end.speed / std::cos(angle), expected * time, 2e-3 * expected * time)
            << name << ", " << substeps << " substeps, " << share;
        EXPECT_NEAR(end.spin * r, (share < 1 ? expected : spins) * time, 2e-3 * expected * time)
            << name << ", " << substeps << " substeps, " << share;
      });
}

TYPED_TEST(Rolling, AFastSpinPullsTheBallForwardByFrictionAlone) {
  using M = TypeParam;
  const double mu = 0.3, spin = 2000, time = 1;
  for (const int substeps : {1, 8})
    for_each_family(substeps, [&](const auto& method, const char* name) {
      const auto end = after(time, ball_on_slope<M>(0, mu, moving<M>(0, spin)), method);
      // AVBD's first step begins with soft springs, which take a tenth of its gain.
      EXPECT_NEAR(end.speed, mu * g * time, 0.1 * mu * g * h) << name << ", " << substeps << " substeps";
      EXPECT_NEAR(end.spin, spin - mu * g * time / (k<M> * r), 0.1 * mu * g * h / (k<M> * r))
          << name << ", " << substeps;
      EXPECT_NEAR(end.height, r - sag(method), 1e-4 * r) << name << ", " << substeps << " substeps";
    });
}

}  // namespace law_rolling_test
