#include "tests/solver/colliding.hpp"

namespace collide_space_test {

using namespace byhand;
using Eigen::Vector3d, Eigen::Quaterniond;
using M = SpaceBody;

constexpr double pi = std::numbers::pi;

Solid<M> box(const Vector3d& sides, const Vector3d& at, const Vector3d& turn = Vector3d::Zero()) {
  return {Box<M>{sides}, {at, space_rotation<double>(turn)}};
}
TEST(CollideSpace, SeparationIsTheLeastTranslationThatPartsToTheHysteresis) {
  int overlaps = 0, several = 0;
  on_box_pairs<M>(2000, [&](Random&, const auto& first, const auto& second) {
    const auto manifold = touch(first, second, 0);
    ASSERT_NO_FATAL_FAILURE(expect_sound(first, second, 0, manifold));
    const double truth = largest_gap(first, second);
    if (manifold.empty()) {
      EXPECT_GT(truth, -1e-3) << "they overlap";
      return;
    }
    ++overlaps;
    several += manifold.size > 1;
    const double along = gap_along<M>(first, second, manifold.normal);
    EXPECT_GE(along, truth - hysteresis_of(first, second) - rounding) << "a shorter way out";
    EXPECT_GE(least_separation(manifold), along - rounding);
    EXPECT_LE(least_separation(manifold), along + 2 * hysteresis_of(first, second));
  });
  EXPECT_GT(overlaps, 500);
  EXPECT_GT(several, 200);
}

TEST(CollideSpace, FeaturesStayWhileTheBoxesHardlyMove) { expect_lasting_features<M>(); }

TEST(CollideSpace, FeaturesOfEqualBoxesOnEachOtherOutlastSwayAndTilt) {
  Random random;
  const Solid<M> below = box({1, 1, 1}, {0, 0, 0});
  for (const double quarter_turn : {0.0, pi / 2}) {
    Solid<M> above = box({1, 1, 1}, {0, 0, 1}, {0, 0, quarter_turn});
    const auto at_rest = above.pose;
    const auto first = touch(below, above, 0.02);
    ASSERT_EQ(first.size, 4);
    std::uint32_t reference = first.reference;
    for (int i = 0; i < 1000; ++i) {
      above.pose.position = {random.uniform(-5e-3, 5e-3), random.uniform(-5e-3, 5e-3),
                             random.uniform(0.996, 0.998)};
      above.pose.rotation = rotated_by<double>(at_rest.rotation, random.vector<3>(1e-3));
      const auto manifold = touch(below, above, 0.02, reference);
      reference = manifold.reference;
      EXPECT_GT(manifold.normal.z(), 0.99);
      for (const auto& point : first) EXPECT_TRUE(has_feature(manifold, point.feature));
    }
  }
}

// Edge i of the one along x and edge j of the other along z are nearest, apart or not.
TEST(CollideSpace, CrossedEdgesHaveTheirNormalAndItsAxisAsTheReference) {
  const auto cube = [](double height, int axis, const Vector3d& along) {
    Eigen::Matrix3d axes;
    axes.col(axis) = along;
    axes.col((axis + 1) % 3) = (Vector3d(1, 1, 1) - along).normalized();
    axes.col((axis + 2) % 3) = along.cross(axes.col((axis + 1) % 3));
    return Solid<M>{Box<M>{{1, 1, 1}}, {{0, height, 0}, Quaterniond(axes)}};
  };
  for (const double gap : {-0.05, 0.1})
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const auto manifold = touch(cube(0, i, {1, 0, 0}), cube(std::sqrt(2) + gap, j, {0, 0, 1}), 0.2);
        ASSERT_EQ(manifold.size, 1);
        EXPECT_EQ(manifold.reference, 7u + 3 * i + j);
        EXPECT_LE((manifold.normal - Vector3d(0, 1, 0)).norm(), rounding);
        EXPECT_NEAR(least_separation(manifold), gap, rounding);
      }
}

// Features 256 + 20 a + b are of two edges or, from 12 on, of the corners at their ends.
TEST(CollideSpace, CornerToCornerFeaturesAreThoseOfOppositeCorners) {
  std::set<std::uint32_t> seen;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3d to(corner & 1 ? -1.1 : 1.1, corner & 2 ? -1.1 : 1.1, corner & 4 ? -1.1 : 1.1);
    const auto manifold = touch(box({1, 1, 1}, {0, 0, 0}), box({1, 1, 1}, to), 0.5);
    ASSERT_EQ(manifold.size, 1);
    const std::uint32_t feature = manifold.points[0].feature, a = (feature - 256) / 20, b = (feature - 256) % 20;
    EXPECT_GE(std::min(a, b), 12u);
    EXPECT_EQ(a - 12 + b - 12, 7u);
    seen.insert(feature);
  }
  EXPECT_EQ(seen.size(), 8u);
}

TEST(CollideSpace, FeaturesDoNotDependOnWhichBoxIsTheReference) {
  Random random;
  for (int draw = 0; draw < 1000; ++draw) {
    const auto quarter_turned = [&](const Vector3d& sides, const Vector3d& at) {
      Solid<M> result = box(sides, at, random.vector<3>(3e-4));
      for (int axis = 0; axis < 3; ++axis)
        result.pose.rotation =
            result.pose.rotation * space_rotation<double>(Vector3d::Unit(axis) * (pi / 2 * random.index(4)));
      return result;
    };
    const auto below = quarter_turned({1, 1, 1}, {0, 0, 0});
    const auto above =
        quarter_turned({0.8, 0.8, 0.8}, {random.uniform(0.2, 0.7), random.uniform(-0.7, -0.2), 0.895});
    std::array<Manifold<M>, 6> by_hint;
    std::array<bool, 2> seen = {};
    for (std::uint32_t hint = 1; hint <= 6; ++hint) {
      const auto manifold = touch(below, above, 0.02, hint);
      ASSERT_EQ(manifold.size, 4);
      seen[(manifold.reference - 1) / 3] = true;
      by_hint[hint - 1] = manifold;
    }
    EXPECT_TRUE(seen[0] && seen[1]) << "both boxes have been the reference";
    for (const auto& manifold : by_hint)
      for (const auto& point : manifold) EXPECT_TRUE(has_feature(by_hint[0], point.feature));
  }
}

TEST(CollideSpace, ABoxThatLiesOnAnotherTouchesAtTheCornersOfTheOverlap) {
  for (const double turn : {0.0, pi / 2, 0.3, pi / 4}) {
    const auto manifold = touch(box({4, 4, 1}, {0, 0, 0}), box({1, 1, 1}, {1, 0, 0.99}, {0, 0, turn}), 0.02);
    ASSERT_EQ(manifold.size, 4);
    EXPECT_LE(difference(manifold.normal, Vector3d(0, 0, 1)), rounding);
    for (const auto& point : manifold) {
      EXPECT_NEAR(point.separation, -0.01, rounding);
      EXPECT_NEAR((point.p1 - Vector3d(1, 0, 0.5)).norm(), std::sqrt(0.5), rounding);
    }
  }
}

// Rounding decides whether such boxes overlap or are apart, and by which of two axes.
TEST(CollideSpace, BoxesThatMeetFaceToFaceTouchAtFourPointsWhereverTheyAre) {
  Random random;
  for (int draw = 0; draw < 2000; ++draw) {
    const auto turn = random.pose<M>().rotation;
    const auto a = Vector3d(random.vector<3>(0.4) + Vector3d::Ones()),
               b = Vector3d(random.vector<3>(0.4) + Vector3d::Ones());
    const Vector3d at = random.vector<3>(200),
                   apart(random.uniform(-0.3, 0.3), 0.5 * (a.y() + b.y()), random.uniform(-0.3, 0.3));
    const Solid<M> below{Box<M>{a}, {at, turn}}, above{Box<M>{b}, {at + rotate(turn, apart), turn}};
    const auto manifold = touch(below, above, 0.02);
    EXPECT_EQ(manifold.size, 4) << "draw " << draw;
    EXPECT_NEAR(manifold.normal.dot(rotate(turn, Vector3d(0, 1, 0))), 1, 1e-12) << "draw " << draw;
  }
}

TEST(CollideSpace, OfEightCornersFourAreKeptThatHoldTheMiddle) {
  const auto manifold = touch(box({1, 1, 1}, {0, 0, 0}), box({1, 1, 1}, {0, 0, 0.99}, {0, 0, pi / 4}), 0.02);
  ASSERT_EQ(manifold.size, 4);
  for (const auto& direction : directions<PlaneBody>(16)) {
    double furthest = 0;
    for (const auto& point : manifold) furthest = std::max(furthest, point.p1.head<2>().dot(direction));
    EXPECT_GT(furthest, 0.15) << direction.transpose();
  }
}

// Of corners that lean over the other box some are too far to count; they took the places of others that overlap.
TEST(CollideSpace, NoCornerIsLeftOutForOneBeyondTheMargin) {
  Random random;
  const Solid<M> below = box({2, 2, 2}, {0, 0, 0});
  int leaning = 0;
  for (int draw = 0; draw < 2000; ++draw) {
    const Vector3d tilt(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), random.uniform(0, pi));
    const Solid<M> above = box({1.4, 1.2, 0.5}, {random.uniform(-1, 1), random.uniform(-1, 1), 1.29}, tilt);
    const auto manifold = touch(below, above, 0.01);
    if (manifold.size == 0 || manifold.size == 4 || manifold.normal.z() < 1 - 1e-12) continue;
    for (const double x : {-0.7, 0.7})
      for (const double y : {-0.6, 0.6}) {
        const Vector3d corner = above.pose.position + rotate(above.pose.rotation, Vector3d(x, y, -0.25));
        if (corner.z() > 1.01 || std::max(std::abs(corner.x()), std::abs(corner.y())) > 1) continue;
        ++leaning;
        EXPECT_TRUE(std::any_of(manifold.begin(), manifold.end(),
                                [&](const auto& point) { return (point.p2 - corner).norm() < 1e-12; }))
            << "of " << manifold.size << " points none is the corner at " << corner.transpose();
      }
  }
  EXPECT_GT(leaning, 500);
}

TEST(CollideSpace, EdgesThatCrossTouchAtOnePoint) {
  const double height = std::sqrt(0.5);
  const auto manifold = touch(box({4, 1, 1}, {0, 0, 0}, {pi / 4, 0, 0}),
                              box({1, 4, 1}, {0, 0, 2 * height - 0.01}, {0, pi / 4, 0}), 0.02);
  ASSERT_EQ(manifold.size, 1);
  EXPECT_LE(difference(manifold.normal, Vector3d(0, 0, 1)), rounding);
  EXPECT_NEAR(manifold.points[0].separation, -0.01, rounding);
  EXPECT_LE(difference(manifold.points[0].p1, Vector3d(0, 0, height)), rounding);
}

TEST(CollideSpace, BoxesWhoseCornersAreNearestTouchThere) {
  const auto manifold = touch(box({1, 1, 1}, {0, 0, 0}), box({1, 1, 1}, {1.001, 1.002, 1.002}), 0.02);
  ASSERT_EQ(manifold.size, 1);
  EXPECT_NEAR(manifold.points[0].separation, 0.003, rounding);
  EXPECT_LE(difference(manifold.normal, Vector3d(1, 2, 2) / 3), 1e-10);
}

TEST(CollideSpace, ATurnAboutOneAxisIsThePlane) {
  Random random;
  for (int draw = 0; draw < 2000; ++draw) {
    const auto flat = [&] {
      return Solid<PlaneBody>{random_box<PlaneBody>(random),
                              {random.vector<2>(1), plane_rotation(random.uniform(-4, 4))}};
    };
    const auto raised = [](const Solid<PlaneBody>& solid) {
      const auto& sides = std::get<Box<PlaneBody>>(solid.shape).sides;
      return Solid<M>{Box<M>{{sides.x(), sides.y(), 10}},
                      {{solid.pose.position.x(), solid.pose.position.y(), 0},
                       space_rotation<double>({0, 0, angle(solid.pose.rotation)})}};
    };
    const auto first = flat(), second = flat();
    const auto plane = touch(first, second, 0);
    const auto space = touch(raised(first), raised(second), 0);
    ASSERT_EQ(plane.empty(), space.empty());
    if (plane.empty()) continue;
    EXPECT_LE(difference(space.normal.head<2>(), plane.normal), rounding);
    EXPECT_NEAR(least_separation(space), least_separation(plane), rounding);
    EXPECT_EQ(space.size, 2 * plane.size);
  }
}

TEST(CollideSpace, DegenerateBoxesGiveSoundAnswers) {
  const auto degenerate = [](Random& random) {
    const auto side = [&] { return degenerate_side(random); };
    const auto place = [&] { return 0.25 * random.index(5) + off_by_rounding(random); };
    Solid<M> result = box({side(), side(), side()}, {place(), place(), place()});
    for (int axis = 0; axis < 3; ++axis)
      result.pose.rotation = rotated_by<double>(
          result.pose.rotation, Vector3d::Unit(axis) * (pi / 4 * random.index(8) + off_by_rounding(random)));
    return result;
  };
  const auto size = [](const auto&, const auto&) { return 4000.0; };
  expect_sound_where_degenerate<M>(degenerate, 17, size, [](const auto&, const auto&, const auto&) {});
}

}  // namespace collide_space_test
