#include "tests/solver/colliding.hpp"

namespace collide_plane_test {

using namespace byhand;
using Eigen::Vector2d;
using M = PlaneBody;

constexpr double pi = std::numbers::pi;

Solid<M> box(double width, double height, const Vector2d& at, double angle = 0) {
  return {Box<M>{{width, height}}, {at, plane_rotation(angle)}};
}

TEST(CollidePlane, SeparationIsTheLeastTranslationThatParts) {
  int overlaps = 0;
  on_box_pairs<M>(3000, [&](Random&, const auto& first, const auto& second) {
    const auto manifold = touch(first, second, 0);
    ASSERT_NO_FATAL_FAILURE(expect_sound(first, second, 0, manifold));
    const double truth = largest_gap(first, second);
    if (manifold.empty()) {
      EXPECT_GT(truth, -1e-4) << "they overlap";
      return;
    }
    ++overlaps;
    EXPECT_NEAR(gap_along<M>(first, second, manifold.normal), least_separation(manifold), rounding);
    EXPECT_GE(least_separation(manifold), truth - rounding) << "a shorter way out";
  });
  EXPECT_GT(overlaps, 500);
}

TEST(CollidePlane, FeaturesStayWhileTheBoxesHardlyMove) { expect_lasting_features<M>(); }

TEST(CollidePlane, FeaturesOfEqualBoxesOnEachOtherOutlastSwayAndTilt) {
  const Solid<M> below = box(1, 1, {0, 0});
  const auto first = touch(below, box(1, 1, {0, 1}), 0.02);
  ASSERT_EQ(first.size, 2);
  Random random;
  std::uint32_t reference = first.reference;
  for (int i = 0; i < 1000; ++i) {
    const Solid<M> above =
        box(1, 1, {random.uniform(-5e-3, 5e-3), random.uniform(0.997, 1)}, random.uniform(-2e-3, 2e-3));
    const auto manifold = touch(below, above, 0.02, reference);
    reference = manifold.reference;
    ASSERT_EQ(manifold.size, 2);
    for (const auto& point : manifold)
      EXPECT_TRUE(point.feature == first.points[0].feature || point.feature == first.points[1].feature);
    EXPECT_GT(manifold.normal.y(), 0.99);
  }
}

TEST(CollidePlane, FeaturesDoNotDependOnWhichBoxIsTheReference) {
  Random random;
  for (int draw = 0; draw < 1000; ++draw) {
    const auto quarter_turns = [&] { return pi / 2 * random.index(4) + random.uniform(-1e-3, 1e-3); };
    const Solid<M> below = box(1, 1, {0, 0}, quarter_turns());
    const Solid<M> above = box(0.8, 0.8, {random.uniform(-0.7, 0.7), 0.897}, quarter_turns());
    std::array<Manifold<M>, 4> by_hint;
    std::array<bool, 2> seen = {};
    for (std::uint32_t hint = 1; hint <= 4; ++hint) {
      const auto manifold = touch(below, above, 0.02, hint);
      ASSERT_EQ(manifold.size, 2);
      seen[(manifold.reference - 1) / 2] = true;
      by_hint[hint - 1] = manifold;
    }
    EXPECT_TRUE(seen[0] && seen[1]) << "both boxes have been the reference";
    for (const auto& manifold : by_hint)
      for (const auto& point : manifold)
        EXPECT_TRUE(point.feature == by_hint[0].points[0].feature ||
                    point.feature == by_hint[0].points[1].feature);
  }
}

TEST(CollidePlane, ADrawBetweenTwoFacesFallsAlikeForSwappedBoxes) {
  for (const Vector2d& apart : {Vector2d(0, 1.08), Vector2d(1.08, 0)})
    for (const double tilt : {0.1, -0.1}) {
      const Solid<M> first = box(1, 1, {0, 0}, tilt), second = box(1, 1, apart, -tilt);
      const auto manifold = touch(first, second, 0.02);
      ASSERT_FALSE(manifold.empty());
      expect_same(manifold, mirrored<M>(touch(second, first, 0.02)), rounding);
    }
}

TEST(CollidePlane, TheReferenceFaceYieldsOnlyToOneBetterByTheHysteresis) {
  const Solid<M> corner = box(1, 1, {0, 0});
  const auto in_corner = [](double x, double y) { return box(1, 1, {1 - x, 1 - y}); };
  const auto before = touch(corner, in_corner(0.02, 0.01), 0);
  EXPECT_EQ(before.normal, Vector2d(0, 1));
  const double almost = 0.9 * reference_hysteresis, enough = 1.1 * reference_hysteresis;
  EXPECT_EQ(touch(corner, in_corner(0.02, 0.02 + almost), 0).normal, Vector2d(1, 0));
  EXPECT_EQ(touch(corner, in_corner(0.02, 0.02 + almost), 0, before.reference).normal, Vector2d(0, 1));
  EXPECT_EQ(touch(corner, in_corner(0.02, 0.02 + enough), 0, before.reference).normal, Vector2d(1, 0));
}

TEST(CollidePlane, AnOldReferenceNeverSaysThatBoxesApartOverlapNorTheReverse) {
  const Solid<M> ledge = box(1, 1, {0, 0});
  const auto on_it = touch(ledge, box(1, 1, {0.9, 0.999}), 0.02);
  EXPECT_EQ(on_it.normal, Vector2d(0, 1));
  const auto past_it = touch(ledge, box(1, 1, {1.001, 0.999}), 0.02, on_it.reference);
  EXPECT_EQ(past_it.normal, Vector2d(1, 0));
  EXPECT_NEAR(least_separation(past_it), 0.001, rounding);

  on_box_pairs<M>(3000, [](Random&, const auto& first, const auto& second) {
    const auto plain = touch(first, second, 1);
    for (std::uint32_t hint = 1; hint <= 4; ++hint) {
      const auto hinted = touch(first, second, 1, hint);
      ASSERT_NO_FATAL_FAILURE(expect_sound(first, second, 1, hinted));
      EXPECT_EQ(least_separation(hinted) > 0, least_separation(plain) > 0);
      if (least_separation(plain) > 0) continue;
      EXPECT_NEAR(least_separation(hinted), least_separation(plain), hysteresis_of(first, second));
    }
  });
}

TEST(CollidePlane, ABoxOnABoxTouchesAtBothEndsOfTheOverlap) {
  const auto manifold = touch(box(2, 1, {0, 0}), box(1, 1, {1, 0.99}), 0.02);
  ASSERT_EQ(manifold.size, 2);
  EXPECT_LE(difference(manifold.normal, Vector2d(0, 1)), rounding);
  for (const auto& point : manifold) EXPECT_NEAR(point.separation, -0.01, rounding);
  EXPECT_NEAR(std::min(manifold.points[0].p1.x(), manifold.points[1].p1.x()), 0.5, rounding);
  EXPECT_NEAR(std::max(manifold.points[0].p1.x(), manifold.points[1].p1.x()), 1, rounding);
}

TEST(CollidePlane, BoxesWhoseCornersAreNearestTouchThere) {
  const auto manifold = touch(box(1, 1, {0, 0}), box(1, 1, {1.003, 1.004}), 0.02);
  ASSERT_EQ(manifold.size, 1);
  EXPECT_NEAR(manifold.points[0].separation, 0.005, rounding);
  EXPECT_LE(difference(manifold.normal, Vector2d(0.6, 0.8)), 1e-10);
  EXPECT_TRUE(touch(box(1, 1, {0, 0}), box(1, 1, {1.003, 1.004}), 0.0049).empty());
}

TEST(CollidePlane, BoxesWithOneCentrePartAlongTheFirstsShorterWayOut) {
  const auto manifold = touch(box(1, 2, {3, 4}), box(1, 2, {3, 4}), 0);
  EXPECT_EQ(manifold.normal, Vector2d(1, 0));
  EXPECT_EQ(least_separation(manifold), -1);
}

TEST(CollidePlane, DegenerateBoxesGiveSoundAnswers) {
  const auto degenerate = [](Random& random) {
    const auto place = [&] { return 0.25 * random.index(5) + off_by_rounding(random); };
    const double width = degenerate_side(random), height = degenerate_side(random), x = place(), y = place();
    return box(width, height, Vector2d(x, y), pi / 4 * random.index(8) + off_by_rounding(random));
  };
  const auto matches_the_gap = [](const Solid<M>& first, const Solid<M>& second, const Manifold<M>& manifold) {
    double gap = -1e9;
    for (const auto& u :
         {Vector2d(1, 0), Vector2d(0, 1), Vector2d(1, 1).normalized().eval(), Vector2d(1, -1).normalized().eval()})
      gap = std::max({gap, gap_along<M>(first, second, u), gap_along<M>(first, second, -u)});
    // These are all the normals there are, to the noise.
    if (gap >= -1e-5) return;
    ASSERT_FALSE(manifold.empty());
    ASSERT_LE(std::abs(least_separation(manifold) - gap), hysteresis_of(first, second) + 1e-5);
  };
  const auto size = [](const Solid<M>& first, const Solid<M>& second) {
    return reach<M>(first, {1, 0}) + reach<M>(second, {1, 0}) + 1;
  };
  expect_sound_where_degenerate<M>(degenerate, 6, size, matches_the_gap);
}

}  // namespace collide_plane_test
