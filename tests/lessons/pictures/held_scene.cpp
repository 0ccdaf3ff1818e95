#include "lessons/pictures/held_scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lessons/page/words.hpp"
#include "lessons/pictures/faces.hpp"
#include "lessons/scenes/boxes.hpp"
#include "lessons/scenes/four_bar.hpp"
#include "lessons/scenes/pendulum.hpp"
#include "renderer/svg_canvas.hpp"
#include "solver/measure.hpp"
#include "tests/solver/dual.hpp"

namespace byhand::pictures {
namespace held_scene_test {

using renderer::Point;
using testing::HasSubstr;
using Bob = HeldScene<PlaneParticle>;
using Boxes = HeldScene<PlaneBody>;

constexpr double h = 1.0 / 60;
constexpr renderer::Rectangle view{-3, -3, 6, 6};

template <class M>
HeldScene<M> held(Scene<M> scene, const VelocityStepping& method = {}) {
  return HeldScene<M>(
      {.start = {std::move(scene), method}, .h = h, .view = view, .body = "bob", .law = "The law."});
}

Scene<PlaneParticle> two_bobs_on_a_rod() {
  Scene<PlaneParticle> scene;
  scene.gravity.setZero();
  scene.add_body({0, 0}, with_mass<PlaneParticle>(1));
  scene.add_body({1, 0}, with_mass<PlaneParticle>(3));
  scene.add(Distance<PlaneParticle>{{0, 1}, 1});
  return scene;
}

Scene<PlaneBody> two_boxes() {
  Scene<PlaneBody> scene;
  add_ground(scene);
  add_unit_box(scene, -1, 0.5);
  add_unit_box(scene, 1, 0.5);
  return scene;
}

/// The rod of lesson 4: one cold sweep, and β.
Bob rod(double beta, double angle = 0) {
  return held(pendulum<PlaneParticle, NormalisedDistance>(angle, 2, 3),
              {GaussSeidel{.sweeps = 1, .warm_start = false}, Baumgarte{beta}});
}

template <class M>
void steps(HeldScene<M>& scene, int count) {
  for (int i = 0; i < count; ++i) scene.step();
}

/// Takes body `index` in its middle and pulls by so many points, y up.
template <class M>
void drag(HeldScene<M>& scene, int index, const Point& by) {
  const Point at = scene.bodies()[static_cast<std::size_t>(index)].at;
  scene.grab(at);
  scene.move(at + by);
}

template <class M>
std::string picture(const HeldScene<M>& scene, std::optional<double> part = {}) {
  renderer::SvgCanvas canvas(course::Held::width, "held");
  scene.draw(canvas, part);
  return canvas.svg("");
}

TEST(Pull, JacobianIsTheGradientOfItsValue) {
  const Pose<PlaneBody> pose1{{0.3, -0.2}, plane_rotation(0.4)}, pose2{{1.1, 0.7}, plane_rotation(-1.2)};
  Pull<PlaneBody> pull;
  pull.along = {0.6, 0.8};
  pull.at.arms = {{0.5, 0.1}, {-0.2, 0.9}};
  const auto J = pull.jacobian(pose1, pose2).matrix;
  const Dense gradient = gradient_by_duals(pull, pose1, pose2);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(J(0, i), gradient(0, i), 1e-15) << i;
}

TEST(HeldScene, TheMomentumThatADragAddsIsTheImpulseOfTheHand) {
  Bob scene = held(two_bobs_on_a_rod(), {GaussSeidel{.sweeps = 3}});
  drag(scene, 1, {40, 200});
  steps(scene, 30);
  scene.move({500, 100});
  steps(scene, 30);
  const Linear<PlaneParticle> momentum = linear_momentum(scene.simulation().scene.bodies());
  EXPECT_GT(momentum.norm(), 0.1);
  EXPECT_LT((momentum - scene.hand_impulse()).norm(), 1e-12);
}

TEST(HeldScene, GravityAddsToTheMomentumWhatItDoesWithoutAHand) {
  Scene<PlaneParticle> bob;
  bob.add_body({0, 0}, with_mass<PlaneParticle>(2));
  Bob scene = held(bob);
  drag(scene, 0, {30, 60});
  steps(scene, 20);
  const Linear<PlaneParticle> momentum = linear_momentum(scene.simulation().scene.bodies());
  EXPECT_LT((momentum - scene.hand_impulse() - 2 * 20 * h * bob.gravity).norm(), 1e-12);
}

TEST(HeldScene, LettingGoKeepsEveryVelocityAndTheEnergy) {
  Boxes scene = held(two_boxes());
  drag(scene, 0, {60, 120});
  steps(scene, 10);
  const auto before = scene.simulation();
  scene.release();
  const auto& after = scene.simulation();
  EXPECT_EQ(after.scene.bodies().velocity, before.scene.bodies().velocity);
  EXPECT_EQ(energy(after.scene), energy(before.scene));
  EXPECT_GT(after.scene.bodies().velocity[1].norm(), 0.1);
  EXPECT_EQ(scene.held(), -1);
}

TEST(HeldScene, AfterLettingGoItMovesAsIfItHadNeverBeenHeld) {
  Bob scene = rod(0.2, 0.5);
  drag(scene, 0, {150, 0});
  steps(scene, 15);
  scene.release();
  Bob never = rod(0.2, 0.5);
  Simulation<PlaneParticle> alone = never.simulation();
  alone.scene.state() = scene.simulation().scene.bodies();
  for (int i = 0; i < 60; ++i) {
    scene.step();
    alone.step(h);
  }
  EXPECT_EQ(scene.simulation().scene.bodies().pose[1].position, alone.scene.bodies().pose[1].position);
}

TEST(HeldScene, TakingEmptySpaceDoesNothing) {
  Boxes scene = held(two_boxes()), untouched = scene;
  scene.grab({480, 650});
  scene.move({100, 100});
  EXPECT_EQ(scene.held(), -1);
  EXPECT_EQ(scene.simulation().scene.count(), untouched.simulation().scene.count());
  EXPECT_EQ(picture(scene), picture(untouched));
  steps(scene, 5);
  steps(untouched, 5);
  EXPECT_EQ(picture(scene), picture(untouched));
}

TEST(HeldScene, TheBodyUnderThePointIsTaken) {
  Boxes scene = held(two_boxes());
  for (int body = 0; body < 2; ++body) {
    const auto [name, at, reach] = scene.bodies()[static_cast<std::size_t>(body)];
    const double corner = reach / std::sqrt(2.0);
    scene.grab(at + Point(0.95 * corner, 0.95 * corner));
    EXPECT_EQ(scene.held(), body);
    EXPECT_EQ(name, "bob " + std::to_string(body + 1));
    scene.grab(at + Point(0, corner + 20));  // above it
    EXPECT_EQ(scene.held(), -1);
  }
}

TEST(HeldScene, TheHandIsNoStrongerThanItsStrength) {
  Scene<PlaneParticle> bob;
  bob.add_body({0, 0}, with_mass<PlaneParticle>(2));
  const auto share = [&](const Point& by) {
    Bob scene = held(bob);
    drag(scene, 0, by);
    scene.step();
    return Linear<PlaneParticle>(scene.hand_impulse() / (scene.strength() * h));
  };
  EXPECT_LT(share({1, 0}).x(), 0.05);
  EXPECT_GT(share({1, 0}).x(), 0);
  EXPECT_NEAR(share({5000, 0}).x(), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(share({5000, 5000}).norm(), 1, 1e-12);
}

TEST(HeldScene, APullStretchesTheRodOfLesson4ByFhhOverMBeta) {
  for (const double beta : {0.1, 0.5, 1.0}) {
    Bob scene = rod(beta);
    drag(scene, 0, {0, -5000});
    steps(scene, 400);
    const double force = scene.strength() / std::sqrt(2.0);
    EXPECT_NEAR(position_error(scene.simulation().scene).max, force * h * h / (3 * beta), 1e-9) << beta;
    scene.release();
    steps(scene, 1);
    EXPECT_NEAR(position_error(scene.simulation().scene).max, (1 - beta) * force * h * h / (3 * beta), 1e-9)
        << beta;
  }
}

TEST(HeldScene, PinsHoldWhileABarIsDragged) {
  Boxes scene =
      held(four_bar({.arm = 1, .coupler = 1.5, .angle = 0.6}), {.solver = Direct{}, .drift = Baumgarte{1}});
  const Point begin = scene.bodies()[2].at;
  drag(scene, 2, {-120, 60});
  for (int i = 0; i < 90; ++i) {
    scene.step();
    ASSERT_LT(position_error(scene.simulation().scene).max, 0.02) << i;
  }
  EXPECT_EQ(scene.stopped(), "");
  EXPECT_LT(scene.bodies()[2].at.x(), begin.x() - 40);
}

TEST(HeldScene, TheSameEventsGiveTheSameBytes) {
  const auto told = [] {
    Boxes scene = held(two_boxes());
    drag(scene, 1, {-80, 40});
    steps(scene, 25);
    scene.release();
    steps(scene, 25);
    return picture(scene) + picture(scene, 3.5) + scene.words();
  };
  EXPECT_EQ(told(), told());
}

TEST(HeldScene, GoesOnAtOtherParametersWithItsHand) {
  Bob scene = rod(0.2, 0.5), other = rod(1, 0.5);
  drag(scene, 0, {100, 50});
  steps(scene, 10);
  other.go_on_from(scene);
  EXPECT_EQ(other.simulation().scene.bodies().pose[1].position,
            scene.simulation().scene.bodies().pose[1].position);
  EXPECT_EQ(other.time(), scene.time());
  EXPECT_EQ(other.held(), 0);
  scene.step();
  other.step();
  EXPECT_NE(other.simulation().scene.bodies().pose[1].position,
            scene.simulation().scene.bodies().pose[1].position);
}

TEST(HeldScene, BeginsAnewWhereItsBodiesBeginElsewhere) {
  Bob scene = rod(0.2, 0.5), other = rod(0.2, 0.6);
  const Point begin = other.bodies()[0].at;
  steps(scene, 10);
  other.go_on_from(scene);
  EXPECT_EQ(other.bodies()[0].at, begin);
  EXPECT_EQ(other.time(), 0);
}

TEST(HeldScene, StopsWithTheLawWhenItFliesApart) {
  Bob stable = rod(1.9), unstable = rod(2.1);
  for (Bob* scene : {&stable, &unstable}) {
    drag(*scene, 0, {0, -300});
    steps(*scene, 5);
    scene->release();
    steps(*scene, 300);
  }
  EXPECT_EQ(stable.stopped(), "");
  EXPECT_THAT(unstable.stopped(), HasSubstr("flown apart"));
  EXPECT_THAT(unstable.stopped(), HasSubstr("The law."));
  const double stopped = unstable.time();
  unstable.step();
  EXPECT_EQ(unstable.time(), stopped);
  unstable.reset();
  EXPECT_EQ(unstable.stopped(), "");
  EXPECT_EQ(unstable.time(), 0);
}

TEST(HeldScene, LookingIntoAStepLeavesItAsItIs) {
  Bob scene = rod(0.2, 0.5);
  steps(scene, 3);
  const std::string before = picture(scene);
  for (double part = 0; part < course::Held::parts; part += 0.5) EXPECT_NE(picture(scene, part), before);
  EXPECT_EQ(picture(scene), before);
}

TEST(HeldScene, AStepFromRestShowsGravityItsPartAlongTheRodAndTheImpulse) {
  const double angle = 0.5, gain = 9.81 * h, along = gain * std::cos(angle);
  const Bob scene = rod(0.2, angle);
  const auto shows = [&](int part, double number) {
    EXPECT_THAT(picture(scene, part + 0.9), HasSubstr(course::number(number, 3))) << part;
  };
  shows(1, gain);
  shows(2, along);
  shows(3, -3 * along);
  shows(4, gain * std::sin(angle));
  shows(5, 1000 * h * gain * std::sin(angle));
}

// In space the hand pulls along the two directions of the picture alone.
using Book = HeldScene<SpaceBody>;

Book held_book(bool pinned, bool shape = true) {
  Scene<SpaceBody> scene;
  scene.gravity.setZero();
  const int ground = scene.add_body(Linear<SpaceBody>(0, 0, 0), fixed<SpaceBody>());
  const Linear<SpaceBody> sides(1.2, 0.8, 0.2);
  const int book = scene.add_body(Linear<SpaceBody>(0, 0, 0), box<SpaceBody>(3, sides));
  if (shape) scene.set_shape(book, Box<SpaceBody>{sides});
  if (pinned) scene.add(pin<SpaceBody>(scene.bodies(), ground, book, Linear<SpaceBody>(0, 0, 0)));
  VelocityStepping method{Direct{}, Baumgarte{0.2}};
  method.gyroscopic = Gyroscopic::implicit;
  return Book({.start = {std::move(scene), method},
               .h = h,
               .view = view,
               .body = "book",
               .seen = seen_from_aside(0.5, 0.35)});
}

TEST(HeldScene, InSpaceTheHandPullsInThePlaneOfThePicture) {
  Book scene = held_book(false);
  drag(scene, 0, {60, 40});
  steps(scene, 40);
  const Linear<SpaceBody> momentum = linear_momentum(scene.simulation().scene.bodies());
  const auto seen = seen_from_aside(0.5, 0.35);
  const Eigen::Vector3d right = seen.row(0), up = seen.row(1);
  EXPECT_GT(momentum.norm(), 0.1);
  EXPECT_LT((momentum - scene.hand_impulse()).norm(), 1e-12);
  EXPECT_LT(std::abs(momentum.dot(right.cross(up))), 1e-12);
}

TEST(HeldScene, ABookPulledByItsMiddleFrontTurnsOnItsPin) {
  Book scene = held_book(true);
  drag(scene, 0, {80, 0});
  steps(scene, 20);
  scene.release();
  const Bodies<SpaceBody>& bodies = scene.simulation().scene.bodies();
  EXPECT_LT(bodies.pose[1].position.norm(), 1e-3);
  // To the right on the side towards the viewer: about the picture's upward direction.
  const Eigen::Vector3d omega = bodies.velocity[1].tail<3>(), up = seen_from_aside(0.5, 0.35).row(1);
  EXPECT_GT(omega.dot(up), 0.5 * omega.norm());
  const double whole = energy(scene.simulation().scene), momentum = angular_momentum(bodies).norm();
  steps(scene, 600);
  EXPECT_NEAR(energy(scene.simulation().scene), whole, 1e-9 * whole);
  EXPECT_NEAR(angular_momentum(scene.simulation().scene.bodies()).norm(), momentum, 1e-9 * momentum);
}

TEST(HeldScene, WithoutAShapeABodyInSpaceIsHeldByItsMiddle) {
  Book scene = held_book(true, false);
  drag(scene, 0, {80, 0});
  steps(scene, 20);
  EXPECT_LT(scene.simulation().scene.bodies().velocity[1].tail<3>().norm(), 1e-12);
}

}  // namespace held_scene_test
}  // namespace byhand::pictures
