#include <gtest/gtest.h>

#include "lessons/laws/friction.hpp"
#include "lessons/scenes/incline.hpp"
#include "tests/solver/law_motion.hpp"

// Atlas A7 and B10 in space: friction has two axes there, and what the solver holds within a disc it may also hold
// within a square, axis by axis.
namespace friction_in_space_test {

using namespace byhand;
using M = SpaceBody;
constexpr double g = 9.81, h = 1.0 / 60, mu = 0.5, degree = std::numbers::pi / 180;

/// What a body has gone along the ground (or its slope).
struct Slide {
  double distance = 0, heading = 0;  // [m], [rad] from +x towards +z
};
Slide slide(Scene<M> scene, const RowSolver& solver, double time) {
  const Linear<M> start = scene.bodies().pose[1].position;
  Simulation<M> simulation{std::move(scene), {solver}};
  run(simulation, time, h);
  const Linear<M> gone = simulation.scene.bodies().pose[1].position - start;
  return {gone.norm(), std::atan2(gone.z(), gone.x())};
}

/// A flat box that sets out at `speed` in a direction of the ground.
Scene<M> sliding_box(double heading, double speed) {
  Scene<M> scene = box_on_incline<M>(0, mu, 0, {1, 0.2, 1});
  scene.state().velocity[1].head<3>() = speed * Linear<M>(std::cos(heading), 0, std::sin(heading));
  return scene;
}

TEST(LawA7InSpace, ABoxSticksJustBelowTheAngleOfFriction) {
  const double angle = 0.999 * std::atan(mu);
  EXPECT_LT(slide(box_on_incline<M>(angle, mu), GaussSeidel{1000}, 3).distance, 1e-6);
}

TEST(LawA7InSpace, ABoxSlidesJustAboveTheAngleOfFrictionAsTheFormulaSays) {
  const double angle = 1.01 * std::atan(mu), a = g * (std::sin(angle) - mu * std::cos(angle)), t = 2;
  EXPECT_NEAR(slide(box_on_incline<M>(angle, mu), GaussSeidel{1000}, t).distance, 0.5 * a * t * (t + h), 1e-4);
}

// The box's corners resist a push along x otherwise than one along z: if λ came to rest along that answer rather
// than against the slip, a box would go further straight ahead than diagonally, and turn.
TEST(LawB10, InTheDiscABoxStopsAlikeInEveryDirectionAndKeepsItsHeading) {
  const int steps = 36;
  const double v0 = steps * mu * g * h, law = v0 * v0 / (2 * mu * g) - v0 * h / 2;
  for (const double heading : {0.0, 17.0, 30.0, 45.0, 90.0, 200.0}) {
    const Slide slid = slide(sliding_box(heading * degree, v0), GaussSeidel{100}, 1);
    EXPECT_NEAR(slid.distance, law, 1e-6) << heading << "°";
    EXPECT_NEAR(std::remainder(slid.heading - heading * degree, 2 * std::numbers::pi), 0, 1e-6) << heading << "°";
  }
}

// Law 10's square is among the laws' boundaries; the disc it is compared with is not turned.
TEST(LawB10, InTheDiscAParticleStopsAlikeInEveryDirectionAndKeepsItsHeading) {
  for (const double heading : {0 * degree, 30 * degree, 45 * degree, 80 * degree}) {
    const laws::Slide disc = laws::slide(laws::FrictionBound::disc, heading, 3);
    EXPECT_NEAR(disc.distance, 9 / (2 * mu * g) - 3 * h / 2, 1e-3);
    EXPECT_NEAR(disc.heading, heading, 1e-12);
  }
}

TEST(LawB10, InTheSquareADiagonalSlideKeepsItsHeadingForBothAxesStopTogether) {
  EXPECT_NEAR(laws::slide(laws::FrictionBound::square, 45 * degree, 3).heading, 45 * degree, 1e-12);
}

}  // namespace friction_in_space_test
