#include <gtest/gtest.h>

#include "solver/constraints/axis_friction.hpp"
#include "solver/scenes/incline.hpp"
#include "tests/solver/law_motion.hpp"

// Atlas A7 and B10 in space: friction has two axes there, and what the solver holds within a disc it may also hold
// within a square, axis by axis.
namespace {

using namespace byhand;
using M = SpaceBody;
using Points = Scene<M, Contact, Friction>;
constexpr double g = 9.81, h = 1.0 / 60, mu = 0.5, degree = std::numbers::pi / 180;

/// What a body has gone along the ground (or its slope).
struct Slide {
  double distance = 0, heading = 0;  // [m], [rad] from +x towards +z
};
template <class S>
Slide slide(S scene, const RowSolver& solver, double time) {
  const Linear<M> start = scene.bodies.pose[1].position.template head<3>();
  Simulation<S> simulation{std::move(scene), {solver}};
  run(simulation, time, h);
  const Linear<M> gone = simulation.scene.bodies.pose[1].position - start;
  return {gone.norm(), std::atan2(gone.z(), gone.x())};
}

/// A flat box that sets out at `speed` in a direction of the ground.
Points sliding_box(double heading, double speed) {
  Points scene = box_on_incline<Points>(0, mu, 0, {1, 0.2, 1});
  scene.bodies.velocity[1].head<3>() = speed * Linear<M>(std::cos(heading), 0, std::sin(heading));
  return scene;
}

TEST(LawA7InSpace, ABoxSticksJustBelowTheAngleOfFriction) {
  const double angle = 0.999 * std::atan(mu);
  EXPECT_LT(slide(box_on_incline<Points>(angle, mu), GaussSeidel{1000}, 3).distance, 1e-6);
}

TEST(LawA7InSpace, ABoxSlidesJustAboveTheAngleOfFrictionAsTheFormulaSays) {
  const double angle = 1.01 * std::atan(mu), a = g * (std::sin(angle) - mu * std::cos(angle)), t = 2;
  EXPECT_NEAR(slide(box_on_incline<Points>(angle, mu), GaussSeidel{1000}, t).distance, 0.5 * a * t * (t + h),
              1e-4);
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

/// A particle on the ground with friction within a disc or within a square.
enum class Shape { disc, square };
Slide slide_of_a_particle(Shape shape, double heading, double v0) {
  using P = SpaceParticle;
  Scene<P, Contact, Friction, AxisFriction> scene;
  const Linear<P> up(0, 1, 0);
  const int ground = scene.add_body({0, 0, 0}, fixed<P>());
  const int particle =
      scene.add_body({0, 0, 0}, with_mass<P>(1), v0 * Velocity<P>(std::cos(heading), 0, std::sin(heading)));
  const int contact = scene.add(Contact<P>{{ground, particle}, up});
  if (shape == Shape::disc) {
    scene.add(Friction<P>{{ground, particle}, tangents_of<P>(up), mu, contact});
  } else {
    for (const Linear<P>& tangent : {Linear<P>(1, 0, 0), Linear<P>(0, 0, 1)})
      scene.add(AxisFriction<P>{{ground, particle}, tangent, mu, contact});
  }
  Simulation<decltype(scene)> simulation{std::move(scene), {GaussSeidel{}}};
  run(simulation, 2, h);
  const Linear<P> gone = simulation.scene.bodies.pose[1].position;
  return {gone.norm(), std::atan2(gone.z(), gone.x())};
}

TEST(LawB10, InTheSquareADiagonalSlideStopsInSevenTenthsOfTheDistance) {
  const double heading = 45 * degree, v0 = 3;
  const Slide disc = slide_of_a_particle(Shape::disc, heading, v0),
              square = slide_of_a_particle(Shape::square, heading, v0);
  EXPECT_NEAR(disc.distance, v0 * v0 / (2 * mu * g) - v0 * h / 2, 1e-3);
  EXPECT_NEAR(square.distance, v0 * v0 / (2 * std::sqrt(2) * mu * g) - v0 * h / 2, 1e-3);
  EXPECT_NEAR(square.distance / disc.distance, 0.69, 0.01) << "1/√2, but for half a step";
  EXPECT_NEAR(square.heading, heading, 1e-12) << "on the diagonal both axes stop together";
}

TEST(LawB10, InTheSquareASlideTurnsTowardsItsGreaterPart) {
  const double heading = 30 * degree, v0 = 3;
  EXPECT_NEAR(slide_of_a_particle(Shape::disc, heading, v0).heading, heading, 1e-12);
  // Each axis stops by itself after v²/(2μg), so that tan(heading) is squared.
  const double law = std::atan(std::pow(std::tan(heading), 2));
  EXPECT_NEAR(slide_of_a_particle(Shape::square, heading, v0).heading, law, 0.5 * degree);
}

}  // namespace
