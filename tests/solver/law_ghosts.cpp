#include <gtest/gtest.h>

#include "tests/solver/law_motion.hpp"

// A body is turned by what it meets, and by nothing that it passes: not by corners ahead, not by the inner edges
// of a floor of tiles, however fast it is. What it does meet stops it, also what only its turning brings there.
namespace law_ghosts_test {

using namespace byhand;
constexpr double h = 1.0 / 60, margin = 0.02;

template <class M>
Linear<M> point(double x, double y) {
  return x * Linear<M>::Unit(0) + y * Linear<M>::Unit(1);
}
template <class M>
Velocity<M> velocity(double x, double y, double spin = 0) {
  return x * Velocity<M>::Unit(0) + y * Velocity<M>::Unit(1) + spin * Velocity<M>::Unit(M::dof - 1);
}
/// A box as wide as high, and in space as deep, as these say.
template <class M>
Box<M> block(double width, double height, double depth = 4) {
  Box<M> box{Linear<M>::Constant(depth)};
  box.sides.template head<2>() = Eigen::Vector2d(width, height);
  return box;
}
template <class M>
int add_block(Scene<M>& scene, const Linear<M>& at, const Box<M>& box, double friction = 0) {
  const int body = scene.add_body(at, fixed<M>());
  scene.set_shape(body, box, {friction});
  return body;
}

template <class M>
class Ghosts : public testing::Test {};
using Models = testing::Types<PlaneBody, SpaceBody>;
TYPED_TEST_SUITE(Ghosts, Models);

// A ball or a box flies up past the corner (-1/2, 0), level or aslant, at more than the margin from it.
TYPED_TEST(Ghosts, ACornerThatIsPassedChangesNoVelocity) {
  using M = TypeParam;
  const double r = 0.1;
  for (const double clearance : {1.05 * margin, 0.1, 0.6})
    for (const double speed : {1.0, 5.0, 30.0, 300.0, 3000.0})
      for (const double slope : {0.0, 0.3})
        for (const bool box : {false, true})
          for (int phase = 0; phase < 20; ++phase) {
            const Eigen::Vector2d way = Eigen::Vector2d(1, slope).normalized(), up(-way.y(), way.x());
            const double extent = box ? r * up.cwiseAbs().sum() : r;
            const Eigen::Vector2d start =
                Eigen::Vector2d(-0.5, 0) + (extent + clearance) * up - (2 + speed * h * phase / 20) * way;
            Scene<M> scene;
            scene.gravity.setZero();
            add_block<M>(scene, point<M>(0, -0.5), block<M>(1, 1));
            const Velocity<M> v = velocity<M>(speed * way.x(), speed * way.y());
            const int body = scene.add_body(point<M>(start.x(), start.y()), ball<M>(1, r), v);
            if (box)
              scene.set_shape(body, block<M>(2 * r, 2 * r, 2 * r));
            else
              scene.set_shape(body, Ball<M>{r});
            Simulation simulation{std::move(scene)};
            run(simulation, 4 / speed + 5 * h, h);
            EXPECT_EQ(simulation.scene.bodies().velocity[body], v) << clearance << ' ' << speed << ' ' << slope;
          }
}

/// Where a ball or box ends that moves for 3 s along a floor without friction, how high it rose and how low it
/// sank.
template <class M>
struct Ride {
  double x, speed, rise = 0, sink = 0;
};
template <class M>
Ride<M> ride(bool box, double speed, double tile, double step_up = 0) {
  Scene<M> scene;
  scene.gravity = point<M>(0, -9.81);
  const int tiles = tile > 0 ? static_cast<int>((3 * speed + 6) / tile) : 1;
  const double length = tile > 0 ? tile : 3 * speed + 6;
  for (int i = 0; i < tiles; ++i)
    add_block<M>(scene, point<M>((i + 0.5) * length - 3, -0.5 + (i > tiles / 2 ? step_up : 0)),
                 block<M>(length, 1));
  const int body =
      scene.add_body(point<M>(0, 0.25), box ? byhand::box<M>(1, block<M>(0.7, 0.5, 0.5).sides) : ball<M>(1, 0.25),
                     velocity<M>(speed, 0));
  if (box)
    scene.set_shape(body, block<M>(0.7, 0.5, 0.5), {0});
  else
    scene.set_shape(body, Ball<M>{0.25}, {0});
  Simulation simulation{std::move(scene)};
  Ride<M> result;
  for (int i = 0; i < 180; ++i) {
    simulation.step(h);
    const double above = simulation.scene.bodies().pose[body].position.y() - 0.25;
    result.rise = std::max(result.rise, above);
    result.sink = std::max(result.sink, -above);
  }
  result.x = simulation.scene.bodies().pose[body].position.x();
  result.speed = simulation.scene.bodies().velocity[body][0];
  return result;
}

TYPED_TEST(Ghosts, TilesThatLieFlushAreOneFloor) {
  using M = TypeParam;
  for (const bool box : {false, true})
    for (const double speed : {0.3, 1.0, 5.0, 20.0}) {
      const Ride<M> slab = ride<M>(box, speed, 0), tiles = ride<M>(box, speed, 1);
      EXPECT_NEAR(tiles.speed, slab.speed, 1e-6 * speed) << box << ' ' << speed;
      EXPECT_NEAR(tiles.x, slab.x, 1e-6 * speed) << box << ' ' << speed;
      EXPECT_LE(tiles.rise, 1e-7) << box << ' ' << speed;
      EXPECT_LE(tiles.sink, slab.sink + 1e-6) << box << ' ' << speed;
    }
}

// Two heavy bricks that only lie there are a floor as fixed tiles are, a slop of 1 mm above and below.
TYPED_TEST(Ghosts, FreeBricksThatLieFlushAreOneFloor) {
  using M = TypeParam;
  for (const bool is_box : {false, true})
    for (const double speed : {0.5, 2.0, 10.0})
      for (int phase = 0; phase < 10; ++phase) {
        Scene<M> scene;
        scene.gravity = point<M>(0, -9.81);
        scene.set_shape(scene.add_body(point<M>(0, 0), fixed<M>()), HalfSpace<M>{point<M>(0, 1)}, {1});
        for (const double x : {-2.0, 2.0})
          scene.set_shape(scene.add_body(point<M>(x, 0.25), box<M>(1000, block<M>(4, 0.5).sides)),
                          block<M>(4, 0.5), {0});
        const Box<M> crate = block<M>(0.5, 0.5, 0.5);
        const int body = scene.add_body(point<M>(-0.8 - speed * h * phase / 10, 0.75),
                                        is_box ? box<M>(1, crate.sides) : ball<M>(1, 0.25), velocity<M>(speed, 0));
        if (is_box)
          scene.set_shape(body, crate, {0});
        else
          scene.set_shape(body, Ball<M>{0.25}, {0});
        Simulation simulation{std::move(scene)};
        run(simulation, 1.6 / speed, h);
        const Velocity<M>& V = simulation.scene.bodies().velocity[body];
        EXPECT_NEAR(V[0], speed, 1e-3 * speed) << is_box << ' ' << phase;
        EXPECT_NEAR(simulation.scene.bodies().pose[body].position.y(), 0.75, 2.2e-3)
            << is_box << ' ' << speed << ' ' << phase;
      }
}

// Beside a seam the ball has the face of one tile below it and the edge of the other, and must keep the former.
TYPED_TEST(Ghosts, ABallBesideASeamRestsAsOnOneSlab) {
  using M = TypeParam;
  for (const double radius : {0.05, 0.2, 1.0})
    for (const double share : {0.0, 1e-9, 1e-6, 1e-4, 1e-3, 5e-3, 0.02, 0.1, 0.5}) {
      Scene<M> scene;
      scene.gravity = point<M>(0, -9.81);
      add_block<M>(scene, point<M>(-0.5, -0.5), block<M>(1, 1));
      add_block<M>(scene, point<M>(0.5, -0.5), block<M>(1, 1));
      const int body = scene.add_body(point<M>(share * radius, radius), ball<M>(1, radius));
      scene.set_shape(body, Ball<M>{radius}, {0});
      Simulation simulation{std::move(scene)};
      run(simulation, 5, h);
      // The slop, and what a warm start leaves of it.
      EXPECT_NEAR(simulation.scene.bodies().pose[body].position.y(), radius, 1.1e-3) << radius << ' ' << share;
      EXPECT_NEAR(simulation.scene.bodies().pose[body].position.x(), share * radius, 1e-6)
          << radius << ' ' << share;
    }
}

// On both sides of what counts as flush: a twentieth of the margin.
TYPED_TEST(Ghosts, AStepUpIsNoInnerEdge) {
  using M = TypeParam;
  EXPECT_NEAR(ride<M>(true, 1, 1, 0.5 * margin / 20).speed, 1, 1e-3);
  EXPECT_LE(ride<M>(true, 1, 1, 2 * margin / 20).speed, 0.5);
  EXPECT_LE(ride<M>(true, 5, 1, 0.3).speed, 0.1);
}

// The circle of its corners stays above the floor, and its corners' tangents do not.
TYPED_TEST(Ghosts, WhatTurnsAboveAPlaneIsNotStruckByIt) {
  using M = TypeParam;
  for (const double clearance : {1.5 * margin, 0.1, 0.3, 3.0})
    for (const double spin : {20.0, 50.0, 200.0, 1000.0})
      for (int phase = 0; phase < 20; ++phase) {
        const Box<M> box = block<M>(2, 0.1, 0.1);
        Scene<M> scene;
        scene.gravity.setZero();
        const int floor = scene.add_body(point<M>(0, 0), fixed<M>());
        scene.set_shape(floor, HalfSpace<M>{point<M>(0, 1)});
        Pose<M> pose;
        pose.position = point<M>(0, clearance + box.half().norm());
        if constexpr (M::angular == 1)
          pose.rotation = plane_rotation(0.16 * phase);
        else
          pose.rotation = Quaternion<double>(std::cos(0.08 * phase), 0, 0, std::sin(0.08 * phase));
        const Velocity<M> v = velocity<M>(0, 0, spin);
        const int body = scene.add_body(pose, byhand::box<M>(1, box.sides), v);
        scene.set_shape(body, box);
        Simulation simulation{std::move(scene)};
        simulation.step(h);
        EXPECT_LE(simulation.scene.bodies().velocity[body].template head<2>().norm(), 1e-9)
            << clearance << ' ' << spin;
      }
}

// The floor's row is below the wall's foot, and the wall rises above it.
TYPED_TEST(Ghosts, AWallOnAFloorStopsWhatSlidesToItsFoot) {
  using M = TypeParam;
  for (const double speed : {0.5, 5.0, 50.0}) {
    Scene<M> scene;
    scene.gravity = point<M>(0, -9.81);
    add_block<M>(scene, point<M>(0, -0.5), block<M>(400, 1));
    add_block<M>(scene, point<M>(3.1, 0.5), block<M>(0.2, 1));
    const int body =
        scene.add_body(point<M>(0, 0.25), box<M>(1, block<M>(0.7, 0.5, 0.5).sides), velocity<M>(speed, 0));
    scene.set_shape(body, block<M>(0.7, 0.5, 0.5), {0});
    Simulation simulation{std::move(scene)};
    run(simulation, 4 / speed + 1, h);
    EXPECT_NEAR(simulation.scene.bodies().pose[body].position.x(), 3 - 0.35, 2e-3) << speed;
  }
}

// A bar of 4 m about its middle, with a post at 1.8 m: the end comes from beside it, not along its velocity.
TEST(GhostsInPlane, TurningBringsABarToAPost) {
  using M = PlaneBody;
  for (const double spin : {1.0, 20.0, 60.0, 200.0, 1000.0})
    for (int phase = 0; phase < 50; ++phase) {
      Scene<M> scene;
      scene.gravity.setZero();
      const int post = scene.add_body(Linear<M>(1.8, 0), fixed<M>());
      scene.set_shape(post, Ball<M>{0.05}, {0});
      Pose<M> pose;
      pose.rotation = plane_rotation(-0.3 - 2.5 * phase / 50);
      const int bar = scene.add_body(pose, box<M>(1, {4, 0.1}), {0, 0, spin});
      scene.set_shape(bar, Box<M>{{4, 0.1}}, {0});
      Simulation simulation{std::move(scene)};
      run(simulation, 0.4 + 3 / spin, h);
      const double struck = simulation.scene.bodies().velocity[bar].head<2>().norm();
      EXPECT_GT(struck, 0.1 * spin) << spin << ' ' << phase;
    }
}

TEST(GhostsInPlane, AThinPlateStopsWhatFallsOnItInLongSteps) {
  using M = PlaneBody;
  for (const double step : {1.0 / 60, 0.1, 0.2})
    for (int phase = 0; phase < 100; ++phase) {
      Scene<M> scene;
      add_block<M>(scene, {0, 0}, block<M>(10, 0.02));
      const int body = scene.add_body(Linear<M>(0, 0.13 + 0.02 * phase), ball<M>(1, 0.1));
      scene.set_shape(body, Ball<M>{0.1});
      Simulation simulation{std::move(scene)};
      run(simulation, 5, step);
      EXPECT_GT(simulation.scene.bodies().pose[body].position.y(), 0.1) << step << ' ' << phase;
    }
}

}  // namespace law_ghosts_test
