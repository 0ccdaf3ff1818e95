#include "tests/solver/colliding.hpp"

// Laws that hold whatever touches whatever.
namespace collide_laws_test {

using namespace byhand;

/// Any shape; with `degenerate`, where and as large as makes surfaces, corners and centres meet.
template <class M>
Solid<M> any_solid(Random& random, bool degenerate) {
  Solid<M> solid{{}, random.pose<M>()};
  const auto quarter = [&] { return 0.25 * (1 + random.index(4)); };
  switch (random.index(M::angular > 0 ? 3 : 2)) {
    case 0: solid.shape = degenerate ? Shape<M>(Ball<M>{quarter()}) : random_ball<M>(random); break;
    case 1:
      solid.shape = degenerate ? Shape<M>(HalfSpace<M>{Linear<M>::Unit(random.index(M::linear))})
                               : random_half_space<M>(random);
      break;
    default:
      if constexpr (M::angular > 0)
        solid.shape = degenerate ? Shape<M>(Box<M>{Linear<M>::Constant(2 * quarter())}) : random_box<M>(random);
  }
  if (!degenerate) return solid;
  const double noise[] = {0, 0, 0, 1e-300, 1e-160, 1e-17, -1e-16, 1e-15, 1e-12, -1e-9};
  for (double& x : solid.pose.position) x = 0.25 * random.index(4) + noise[random.index(10)];
  if (random.index(2) == 0) {
    if constexpr (M::angular == 1) solid.pose.rotation = {};
    if constexpr (M::angular == 3) solid.pose.rotation.setIdentity();
  }
  return solid;
}

template <class F>
void in_random_pairs(F&& f, int draws) {
  in_all_models(
      [&]<class M>(Random& random) {
        const auto first = any_solid<M>(random, false), second = any_solid<M>(random, false);
        f.template operator()<M>(random, first, second);
      },
      draws);
}

TEST(CollideLaws, SwappedShapesGiveTheMirroredAnswer) {
  in_random_pairs(
      []<class M>(Random&, const Solid<M>& first, const Solid<M>& second) {
        expect_same(touch(first, second, 0.5), mirrored<M>(touch(second, first, 0.5)), rounding);
      },
      10'000);
}

TEST(CollideLaws, MovingBothMovesTheAnswer) {
  in_random_pairs(
      []<class M>(Random& random, const Solid<M>& first, const Solid<M>& second) {
        const auto by = random.pose<M>();
        auto expected = touch(first, second, 0.5);
        expected.normal = detail::turned<M>(by, expected.normal);
        for (auto& point : expected.points)
          point.p1 = to_world<M>(by, point.p1), point.p2 = to_world<M>(by, point.p2);
        expect_same(touch(Solid<M>{first.shape, carried<M>(by, first.pose)},
                          Solid<M>{second.shape, carried<M>(by, second.pose)}, 0.5),
                    expected, 100 * rounding);
      },
      10'000);
}

/// The same solid where the unit of length is `unit` [m].
template <class M>
Solid<M> scaled(Solid<M> solid, double unit) {
  solid.pose.position *= unit;
  if (auto* ball = std::get_if<Ball<M>>(&solid.shape)) ball->radius *= unit;
  if constexpr (M::angular > 0)
    if (auto* box = std::get_if<Box<M>>(&solid.shape)) box->sides *= unit;
  return solid;
}

TEST_IN_ALL_MODELS(CollideLaws, AnotherUnitOfLengthGivesTheSameAnswerBitForBit, 2000) {
  const bool degenerate = random.index(2) == 0;
  const auto first = any_solid<M>(random, degenerate), second = any_solid<M>(random, degenerate);
  const std::uint32_t hint = random.index(16);
  const auto plain = touch(first, second, 0.5, hint);
  for (const double unit : {0x1p-10, 0x1p10, 0x1p20}) {
    const auto other = touch(scaled(first, unit), scaled(second, unit), 0.5 * unit, hint);
    ASSERT_EQ(other.size, plain.size);
    EXPECT_EQ(other.reference, plain.reference);
    if (plain.size == 0) continue;
    EXPECT_EQ(other.normal, plain.normal);
    for (int i = 0; i < plain.size; ++i) {
      EXPECT_EQ(other.points[i].feature, plain.points[i].feature);
      EXPECT_EQ(other.points[i].separation, unit * plain.points[i].separation);
      EXPECT_EQ(other.points[i].p1, unit * plain.points[i].p1);
    }
  }
}

TEST(CollideLaws, PartingAlongTheNormalPartsByAsMuch) {
  in_random_pairs(
      []<class M>(Random& random, const Solid<M>& first, Solid<M> second) {
        // Between boxes in space a face goes before an edge that is a little better.
        const bool boxes_in_space = M::angular == 3 && first.shape.index() == 2 && second.shape.index() == 2;
        const double tolerance = boxes_in_space ? 4 * reference_hysteresis : rounding;  // sides are up to 2 m
        const auto before = touch(first, second, 0);
        if (before.empty()) return;
        const double by = random.uniform(0, -least_separation(before));
        second.pose.position += by * before.normal;
        EXPECT_NEAR(least_separation(touch(first, second, 1)), least_separation(before) + by, tolerance);
      },
      10'000);
}

TEST(CollideLaws, SeparationOfBoxesApartIsTheirDistanceToOnePerCent) {
  int apart = 0;
  in_both_bodies(
      [&]<class M>(Random& random) {
        const Solid<M> first{random_box<M>(random), random.pose<M>()};
        const Solid<M> second{random_box<M>(random), random.pose<M>()};
        const double margin = random.uniform(0, 2);
        const auto manifold = touch(first, second, margin);
        ASSERT_NO_FATAL_FAILURE(expect_sound(first, second, margin, manifold));
        if (manifold.empty()) {
          EXPECT_GT(largest_gap(first, second), margin - (M::angular == 1 ? 1e-4 : 1e-3));
          return;
        }
        const double nearest = least_separation(manifold);
        if (nearest <= 0) return;
        ++apart;
        // No direction shows a distance that is much less, and two points of theirs are that far apart.
        EXPECT_GE(largest_gap(first, second), 0.99 * nearest - 1e-6);
        const auto at = std::find_if(manifold.begin(), manifold.end(),
                                     [&](const auto& point) { return point.separation == nearest; });
        EXPECT_NEAR((at->p2 - at->p1).norm(), nearest, rounding);
      },
      4000);
  EXPECT_GT(apart, 800);
}

TEST(CollideLaws, DegenerateShapesGiveSoundAnswers) {
  int touching = 0;
  in_all_models(
      [&]<class M>(Random& random) {
        const auto first = any_solid<M>(random, true), second = any_solid<M>(random, true);
        const double margin = random.index(2) * 0.02;
        const auto manifold = touch(first, second, margin);
        expect_sound(first, second, margin, manifold);
        touching += !manifold.empty();
      },
      100'000);
  EXPECT_GT(touching, 200'000);
}

// The number was written down from g++ -O3.
TEST(CollideLaws, GiveTheSameBitsEverywhere) {
  std::uint64_t hash = 14695981039346656037u;  // FNV-1a
  const auto mix = [&](std::uint64_t bits) { hash = (hash ^ bits) * 1099511628211u; };
  in_random_pairs(
      [&]<class M>(Random&, const Solid<M>& first, const Solid<M>& second) {
        const auto manifold = touch(first, second, 0.1);
        for (const auto& point : manifold) {
          mix(point.feature);
          for (const Linear<M>& v : {manifold.normal, point.p1, point.p2})
            for (const double x : v) mix(std::bit_cast<std::uint64_t>(x));
        }
      },
      500);
  EXPECT_EQ(hash, 14914979778073157387u);
}

TEST(CollideLaws, TouchOnlyWithinTheMargin) {
  in_random_pairs(
      []<class M>(Random&, const Solid<M>& first, const Solid<M>& second) {
        const auto wide = touch(first, second, 2);
        if (wide.empty()) return;
        const double least = least_separation(wide);
        EXPECT_TRUE(touch(first, second, least - 1e-9).empty());
        EXPECT_FALSE(touch(first, second, least + 1e-9).empty());
      },
      2000);
}

TEST_IN_ALL_MODELS(CollideLaws, APointAtTheMarginCounts) {
  const double gap = 0.25;
  std::vector<Shape<M>> shapes{Ball<M>{0.5}};
  if constexpr (M::angular > 0) shapes.push_back(Box<M>{Linear<M>::Ones()});
  const Pose<M> above{(1 + gap) * Linear<M>::Unit(1)};
  for (const Shape<M>& second : shapes) {
    std::vector<Solid<M>> below{{HalfSpace<M>{Linear<M>::Unit(1)}, {0.5 * Linear<M>::Unit(1)}}};
    for (const Shape<M>& first : shapes) below.push_back({first, {}});
    for (const Solid<M>& first : below) {
      const auto manifold = touch(first, {second, above}, gap);
      const bool ball = std::holds_alternative<Ball<M>>(first.shape) || std::holds_alternative<Ball<M>>(second);
      EXPECT_EQ(manifold.size, ball ? 1 : Manifold<M>::capacity);
      EXPECT_EQ(touch({second, above}, first, gap).size, manifold.size);
      EXPECT_EQ(least_separation(manifold), gap);
    }
  }
}

TEST_IN_BOTH_BODIES(CollideLaws, BoxesThatTieTakeTheSameOnesFaceInEitherOrder) {
  const Solid<M> first{Box<M>{Linear<M>::Ones()}, {}};
  for (int axis = 0; axis < M::linear; ++axis)
    for (const double side : {-1.0, 1.0})
      for (int offset = 0; offset < std::pow(3, M::linear); ++offset) {
        Solid<M> second = first;
        for (int k = 0, rest = offset; k < M::linear; ++k, rest /= 3)
          second.pose.position[k] = k == axis ? side : 0.25 * (rest % 3 - 1);
        const bool of_first = touch(first, second, 0.02).reference <= M::linear,
                   of_first_swapped = touch(second, first, 0.02).reference > M::linear;
        EXPECT_EQ(of_first, of_first_swapped) << second.pose.position.transpose();
      }
}

}  // namespace collide_laws_test
