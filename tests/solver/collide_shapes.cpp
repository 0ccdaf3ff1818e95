#include <gmock/gmock.h>

#include "tests/solver/colliding.hpp"

namespace collide_shapes_test {

using namespace byhand;
using testing::HasSubstr, testing::ThrowsMessage;

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST_IN_ALL_MODELS(CollideBounds, HoldTheShapeAndAreTouchedByItOnEverySide, 200) {
  const Solid<M> solid = random_solid<M>(random);
  const Bounds<M> box = bounds<M>(solid.shape, solid.pose);
  for (int axis = 0; axis < M::linear; ++axis) {
    EXPECT_NEAR(box.max()[axis], reach<M>(solid, Linear<M>::Unit(axis)), rounding);
    EXPECT_NEAR(box.min()[axis], -reach<M>(solid, -Linear<M>::Unit(axis)), rounding);
  }
}

TEST_IN_ALL_MODELS(CollideBounds, AreEmptyWithoutAShapeAndEndlessForAHalfSpace) {
  const auto pose = random.pose<M>();
  EXPECT_TRUE(fattened(bounds<M>(Shape<M>(), pose), 0.1).isEmpty());
  const Bounds<M> all = bounds<M>(random_half_space<M>(random), pose);
  EXPECT_EQ(all.min(), Linear<M>::Constant(-infinity));
  EXPECT_EQ(all.max(), Linear<M>::Constant(infinity));
}

TEST(CollideBounds, ReachFurtherByTheMargin) {
  const auto box = fattened(Bounds<PlaneBody>(Eigen::Vector2d(1, 2), Eigen::Vector2d(3, 4)), 0.5);
  EXPECT_EQ(box.min(), Eigen::Vector2d(0.5, 1.5));
  EXPECT_EQ(box.max(), Eigen::Vector2d(3.5, 4.5));
}

template <class M>
auto refusing(const Shape<M>& shape) {
  return [shape] { require_valid<M>(shape); };
}

TEST(CollideShapes, ThatCannotBeAreRefusedInOneSentence) {
  in_all_models([]<class M>(Random& random) {
    for (const double radius : {0.0, -1.0, infinity, std::nan("")})
      EXPECT_THAT(refusing<M>(Ball<M>{radius}), ThrowsMessage<std::invalid_argument>(HasSubstr("radius is")));
    for (const double length : {0.0, 0.5, infinity, std::nan("")})
      EXPECT_THAT(refusing<M>(HalfSpace<M>{length * Linear<M>::Unit(0)}),
                  ThrowsMessage<std::invalid_argument>(HasSubstr("normal is")));
    EXPECT_NO_THROW(refusing<M>(random_half_space<M>(random))());
    EXPECT_NO_THROW(refusing<M>(random_ball<M>(random))());
    EXPECT_NO_THROW(refusing<M>({})());
  });
  in_both_bodies([]<class M>(Random& random) {
    for (const double side : {0.0, -1.0, infinity, std::nan("")}) {
      Box<M> box{Linear<M>::Ones()};
      box.sides[1] = side;
      EXPECT_THAT(refusing<M>(box), ThrowsMessage<std::invalid_argument>(HasSubstr("side is")));
    }
    EXPECT_NO_THROW(refusing<M>(random_box<M>(random))());
  });
}

TEST_IN_ALL_MODELS(CollideBalls, TouchWhereTheLineOfTheirCentresLeavesThem, 500) {
  const Solid<M> first{random_ball<M>(random), random.pose<M>()}, second{random_ball<M>(random), random.pose<M>()};
  const auto manifold = touch(first, second, 10);
  expect_sound(first, second, 10, manifold);
  ASSERT_EQ(manifold.size, 1);
  EXPECT_NEAR(gap_along<M>(first, second, manifold.normal), manifold.points[0].separation, rounding);
  EXPECT_GE(manifold.points[0].separation, largest_gap(first, second) - rounding);
}

TEST_IN_ALL_MODELS(CollideBalls, WithOneCentrePartAlongTheLastAxis) {
  const auto pose = random.pose<M>();
  const Solid<M> large{Ball<M>{1}, pose}, small{Ball<M>{0.5}, pose};
  const auto manifold = touch(large, small, 0);
  ASSERT_EQ(manifold.size, 1);
  EXPECT_EQ(difference(manifold.normal, Linear<M>::Unit(M::linear - 1)), 0);
  EXPECT_EQ(manifold.points[0].separation, -1.5);
  expect_sound(large, small, 0, manifold);
}

TEST_IN_ALL_MODELS(CollideBalls, TouchNothingBeyondTheMargin) {
  Solid<M> ball{Ball<M>{0.5}, {}}, other = ball;
  other.pose.position[0] = 1.25;
  EXPECT_TRUE(touch(ball, other, 0.2499).empty());
  EXPECT_EQ(touch(ball, other, 0.25).size, 1);
}

TEST_IN_ALL_MODELS(CollideHalfSpaces, ReachUpToTheirSurfaceAndPushBallsOut, 500) {
  const Solid<M> ground{random_half_space<M>(random), random.pose<M>()},
      ball{random_ball<M>(random), random.pose<M>()};
  const auto manifold = touch(ground, ball, 10);
  expect_sound(ground, ball, 10, manifold);
  ASSERT_EQ(manifold.size, 1);
  EXPECT_NEAR(manifold.points[0].separation, gap_along<M>(ground, ball, manifold.normal), rounding);
  EXPECT_LT(gap_along<M>(ground, ball, random.direction<M>()), -1e9) << "no other direction parts them";
}

TEST_IN_BOTH_BODIES(CollideHalfSpaces, TouchTheDeepestCornersOfABox, 500) {
  const Solid<M> ground{random_half_space<M>(random), random.pose<M>()},
      box{random_box<M>(random), random.pose<M>()};
  const double margin = random.uniform(-2, 2);
  const auto manifold = touch(ground, box, margin);
  expect_sound(ground, box, margin, manifold);

  std::vector<double> heights;
  for (unsigned corner = 0; corner < 1u << M::linear; ++corner) {
    Linear<M> at = std::get<Box<M>>(box.shape).half();
    for (int i = 0; i < M::linear; ++i)
      if (corner >> i & 1) at[i] = -at[i];
    heights.push_back(height_over(ground, to_world<M>(box.pose, at)));
  }
  std::sort(heights.begin(), heights.end());
  EXPECT_EQ(manifold.empty(), heights[0] > margin);
  if (manifold.empty()) return;
  std::vector<double> found;
  for (const auto& point : manifold) found.push_back(point.separation);
  std::sort(found.begin(), found.end());
  // In space the fourth may be missing: a whole face serves better than a corner sooner.
  for (int i = 0; i < M::linear && heights[i] <= margin; ++i) {
    ASSERT_GT(static_cast<int>(found.size()), i);
    EXPECT_NEAR(found[i], heights[i], rounding);
  }
}

TEST_IN_BOTH_BODIES(CollideHalfSpaces, TouchAWholeFaceThatLiesOnThem) {
  const Solid<M> ground{HalfSpace<M>{}, {}};
  Solid<M> box{Box<M>{Linear<M>::Ones()}, {}};
  box.pose.position[1] = 0.5;
  EXPECT_EQ(touch(ground, box, 0).size, Manifold<M>::capacity);
}

TEST_IN_ALL_MODELS(CollideHalfSpaces, DoNotTouchEachOther) {
  const Solid<M> a{random_half_space<M>(random), random.pose<M>()},
      b{random_half_space<M>(random), random.pose<M>()};
  EXPECT_TRUE(touch(a, b, 1).empty());
}

TEST_IN_ALL_MODELS(CollideShapes, WithoutAShapeTouchNothing) {
  const Solid<M> nothing{{}, random.pose<M>()};
  EXPECT_TRUE(touch(nothing, random_solid<M>(random), 10).empty());
  EXPECT_TRUE(touch(random_solid<M>(random), nothing, 10).empty());
}

TEST_IN_BOTH_BODIES(CollideBoxAndBall, TouchWhereTheBallIsNearest, 1000) {
  const Solid<M> box{random_box<M>(random), random.pose<M>()}, ball{random_ball<M>(random), random.pose<M>()};
  const auto manifold = touch(box, ball, 10);
  expect_sound(box, ball, 10, manifold);
  ASSERT_EQ(manifold.size, 1);
  EXPECT_NEAR(manifold.points[0].separation, gap_along<M>(box, ball, manifold.normal), rounding);
  EXPECT_GE(manifold.points[0].separation, largest_gap(box, ball) - rounding);
}

TEST_IN_BOTH_BODIES(CollideBoxAndBall, PartByTheNearestSideWhenTheCentreIsInside) {
  const Solid<M> box{Box<M>{Linear<M>::Constant(2)}, {}};
  Solid<M> ball{Ball<M>{0.25}, {}};
  ball.pose.position[1] = -0.75;
  const auto manifold = touch(box, ball, 0);
  ASSERT_EQ(manifold.size, 1);
  EXPECT_EQ(difference(manifold.normal, -Linear<M>::Unit(1)), 0);
  EXPECT_EQ(manifold.points[0].separation, -0.5);
  ball.pose.position.setZero();
  EXPECT_EQ(difference(touch(box, ball, 0).normal, Linear<M>::Unit(0)), 0)
      << "one centre: the first axis of the box";
}

}  // namespace collide_shapes_test
