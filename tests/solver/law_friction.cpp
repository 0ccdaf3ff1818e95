#include <gtest/gtest.h>

#include "lessons/scenes/incline.hpp"
#include "tests/solver/law_motion.hpp"

// Atlas A7 and B10 in the plane: a box on a slope, found as a face or as two points with friction each.
namespace law_friction_test {

using namespace byhand;
constexpr double g = 9.81, h = 1.0 / 60, mu = 0.5;
const double critical = std::atan(mu);

/// What a box does on a slope in a few seconds: how far it has slid and how fast it is at last, along the slope.
struct Slide {
  double distance = 0, speed = 0;
};
template <class M>
Slide slide(const Scene<M>& scene, double angle, const RowSolver& solver, double time = 5, double step = h) {
  Simulation simulation{scene, {solver}};
  run(simulation, time, step);
  const auto [sin, cos] = sin_cos(angle);
  const Linear<PlaneBody> along(cos, -sin);
  return {(simulation.scene.bodies().pose[1].position - scene.bodies().pose[1].position).dot(along),
          simulation.scene.bodies().velocity[1].template head<2>().dot(along)};
}

TEST(LawA7, ABoxSticksJustBelowTheAngleOfFrictionAndSlidesJustAboveIt) {
  for (const double coefficient : {0.1, 0.5, 0.9}) {
    const double angle = std::atan(coefficient);
    const Slide below = slide(box_on_incline(0.999 * angle, coefficient), 0.999 * angle, Direct{});
    EXPECT_NEAR(below.distance, 0, 1e-12) << coefficient;
    EXPECT_NEAR(below.speed, 0, 1e-12);
    const Slide above = slide(box_on_incline(1.001 * angle, coefficient), 1.001 * angle, Direct{});
    EXPECT_GT(above.speed, 1e-3) << coefficient;
  }
}

TEST(LawA7, ASlidingBoxHasExactlyTheSpeedOfTheFormulaAndGoesHalfAStepFurther) {
  for (const double angle : {1.001 * critical, 1.1 * critical, 1.0})
    for (const double step : {h, h / 4}) {
      const double a = g * (std::sin(angle) - mu * std::cos(angle)), t = 2;
      const Slide slid = slide(box_on_incline(angle, mu, 0, {1, 0.2}), angle, Direct{}, t, step);
      EXPECT_NEAR(slid.speed, a * t, 1e-11) << angle;
      EXPECT_NEAR(slid.distance, 0.5 * a * t * (t + step), 1e-11) << angle;
    }
}

TEST(LawA7, ABoxOneDegreeAboveTheAngleOfFrictionSlidesAsTheAtlasSays) {
  const double theta = std::atan(mu) + std::numbers::pi / 180, t = 5;
  EXPECT_NEAR(slide(box_on_incline(theta, mu), theta, Direct{}).distance, 2.401, 5e-4);
  EXPECT_NEAR(0.5 * g * (std::sin(theta) - mu * std::cos(theta)) * t * t, 2.3927, 5e-5) << "without a time step";
}

TEST(LawA7, TheDistanceToStopIsShortByHalfAStepOfTheFirstSpeed) {
  // v0 is a whole number of steps' worth of friction, so that the last one ends at rest.
  for (const int steps : {10, 40})
    for (const double step : {h, h / 2}) {
      const double v0 = steps * mu * g * step;
      const Slide slid = slide(box_on_incline(0, mu, v0, {1, 0.2}), 0, Direct{}, 4, step);
      EXPECT_NEAR(slid.speed, 0, 1e-12);
      EXPECT_NEAR(slid.distance, v0 * v0 / (2 * mu * g) - v0 * step / 2, 1e-11);
    }
}

TEST(LawA7, SweepsAgreeWithTheDirectSolve) {
  for (const double angle : {0.999 * critical, 1.001 * critical, 1.2 * critical}) {
    const Slide direct = slide(box_on_incline(angle, mu), angle, Direct{});
    const Slide face = slide(box_on_incline(angle, mu), angle, GaussSeidel{40});
    const Slide points = slide(by_points(box_on_incline(angle, mu)), angle, GaussSeidel{400});
    EXPECT_NEAR(face.distance, direct.distance, 1e-7) << angle;
    EXPECT_NEAR(points.distance, direct.distance, 1e-7) << angle;
  }
}

TEST(LawB10, FrictionBeforeTheNormalDoesNothingInOneColdSweep) {
  const auto after_a_step = [](const GaussSeidel& solver) {
    Simulation<PlaneBody> simulation{by_points(box_on_incline(0, mu, 1)), {solver}};
    simulation.step(h);
    return simulation.scene.bodies().velocity[1].x();
  };
  EXPECT_EQ(after_a_step({1, false, SweepOrder::reverse}), 1);
  EXPECT_LT(after_a_step({1, false, SweepOrder::natural}), 1 - 0.9 * mu * g * h);
  EXPECT_LT(after_a_step({2, false, SweepOrder::reverse}), 1 - 0.5 * mu * g * h);
}

TEST(LawB10, AWarmStartGivesTheFrictionThatComesFirstItsBound) {
  const auto distance = [](bool warm) {
    return slide(by_points(box_on_incline(0, mu, 3, {1, 0.2})), 0, GaussSeidel{1, warm, SweepOrder::reverse}, 2)
        .distance;
  };
  EXPECT_NEAR(distance(false), 6, 1e-12) << "nothing stops it";
  EXPECT_LT(distance(true), 1.2 * 9 / (2 * mu * g));
}

}  // namespace law_friction_test
