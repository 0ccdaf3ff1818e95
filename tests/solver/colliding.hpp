#pragma once

#include <array>

#include "solver/contact/manifold.hpp"
#include "tests/solver/random.hpp"

// What touches, judged without looking for it: by what a shape reaches in a direction, and by what it contains.
namespace byhand {

inline constexpr double rounding = 1e-12;  // [m], for shapes of a metre a few metres from the origin

template <class M>
struct Solid {
  Shape<M> shape;
  Pose<M> pose;
};

template <class M>
Manifold<M> touch(const Solid<M>& first, const Solid<M>& second, double margin, std::uint32_t hint = 0) {
  return collide<M>(first.shape, first.pose, second.shape, second.pose, margin, hint);
}

/// By how much a reference of two boxes has to be better than the last step's [m].
template <class M>
double hysteresis_of(const Solid<M>& first, const Solid<M>& second) {
  return hysteresis(std::get<Box<M>>(first.shape), std::get<Box<M>>(second.shape));
}

template <class M>
Shape<M> random_ball(Random& random) {
  return Ball<M>{random.uniform(0.1, 1)};
}
template <class M>
Shape<M> random_box(Random& random) {
  return Box<M>{2 * (Linear<M>::Constant(0.55) + random.vector<M::linear>(0.45))};
}
template <class M>
Shape<M> random_half_space(Random& random) {
  return HalfSpace<M>{random.direction<M>()};
}
/// A box or a ball; a particle is always a ball.
template <class M>
Solid<M> random_solid(Random& random) {
  if constexpr (M::angular > 0)
    if (random.index(2) == 0) return {random_box<M>(random), random.pose<M>()};
  return {random_ball<M>(random), random.pose<M>()};
}

template <class M>
Linear<M> to_body(const Pose<M>& pose, const Linear<M>& point) {
  if constexpr (M::angular == 0)
    return point - pose.position;
  else
    return rotate(inverse(pose.rotation), Linear<M>(point - pose.position));
}
template <class M>
Linear<M> to_world(const Pose<M>& pose, const Linear<M>& point) {
  return pose.position + detail::turned<M>(pose, point);
}

/// How far the solid reaches along the unit vector u: the largest u · x [m]; infinite where it does not end.
template <class M>
double reach(const Solid<M>& solid, const Linear<M>& u) {
  const Linear<M> own = to_body<M>(solid.pose, solid.pose.position + u);
  const double centre = u.dot(solid.pose.position);
  if (const auto* ball = std::get_if<Ball<M>>(&solid.shape)) return centre + ball->radius;
  if constexpr (M::angular > 0)
    if (const auto* box = std::get_if<Box<M>>(&solid.shape)) return centre + own.cwiseAbs().dot(box->half());
  const auto& half_space = std::get<HalfSpace<M>>(solid.shape);
  return (own - half_space.normal).norm() < 1e-9 ? centre : std::numeric_limits<double>::infinity();
}

/// How far apart the two are along u: no translation along u by less than minus this parts them.
template <class M>
double gap_along(const Solid<M>& first, const Solid<M>& second, const Linear<M>& u) {
  return -reach<M>(second, -u) - reach<M>(first, u);
}

/// How high a world point is over the solid's surface [m]: negative inside, and exact up to there.
template <class M>
double height_over(const Solid<M>& solid, const Linear<M>& point) {
  const Linear<M> p = to_body<M>(solid.pose, point);
  if (const auto* ball = std::get_if<Ball<M>>(&solid.shape)) return p.norm() - ball->radius;
  if constexpr (M::angular > 0)
    if (const auto* box = std::get_if<Box<M>>(&solid.shape)) return (p.cwiseAbs() - box->half()).maxCoeff();
  return std::get<HalfSpace<M>>(solid.shape).normal.dot(p);
}

/// The point of a ball or box that is nearest to a world point.
template <class M>
Linear<M> nearest_point(const Solid<M>& solid, const Linear<M>& point) {
  const Linear<M> p = to_body<M>(solid.pose, point);
  if constexpr (M::angular > 0)
    if (const auto* box = std::get_if<Box<M>>(&solid.shape))
      return to_world<M>(solid.pose, p.cwiseMin(box->half()).cwiseMax(-box->half()));
  const double radius = std::get<Ball<M>>(solid.shape).radius;
  return p.norm() <= radius ? point : to_world<M>(solid.pose, p.normalized() * radius);
}

/// `count` unit vectors that leave no large gap: evenly round the circle, or along a spiral over the sphere.
template <class M>
std::vector<Linear<M>> directions(int count) {
  std::vector<Linear<M>> result(count);
  for (int i = 0; i < count; ++i) {
    if constexpr (M::linear == 2) {
      const auto at = plane_rotation(2 * std::numbers::pi * i / count);
      result[i] = {at.cos, at.sin};
    } else {
      const double z = (2 * i + 1.0) / count - 1, r = std::sqrt(1 - z * z);
      const auto at = plane_rotation(i * std::numbers::pi * (3 - std::sqrt(5.0)));
      result[i] = {r * at.cos, r * at.sin, z};
    }
  }
  return result;
}

/// The largest gap over all directions: the distance of solids that are apart, minus the least translation that
/// parts those that overlap. A dense search, then a closer one about the best, and for those apart the line
/// between two points that go to each other (von Neumann's alternating projections); never too large.
template <class M>
double largest_gap(const Solid<M>& first, const Solid<M>& second) {
  static const auto all = directions<M>(M::linear == 2 ? 360 : 1000);
  double best = -std::numeric_limits<double>::infinity();
  Linear<M> at = all.front();
  const auto try_direction = [&](const Linear<M>& u) {
    const double gap = gap_along<M>(first, second, u);
    if (gap > best) best = gap, at = u;
  };
  for (const auto& u : all) try_direction(u);
  Linear<M> p = first.pose.position, q = second.pose.position;
  for (int i = 0; i < 1000 && (q - p).norm() > 1e-9; ++i)
    q = nearest_point(second, p), p = nearest_point(first, q);
  if ((q - p).norm() > 1e-9) try_direction((q - p).normalized());
  for (double step = 0.1; step > 1e-6; step *= 0.8) {
    const Linear<M> about = at;
    for (std::size_t i = 0; i < all.size(); i += all.size() / 40)
      try_direction((about + step * all[i]).normalized());
  }
  return best;
}

template <class M>
double least_separation(const Manifold<M>& manifold) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& point : manifold) least = std::min(least, point.separation);
  return least;
}

/// What every manifold keeps, whatever touches.
template <class M>
void expect_sound(const Solid<M>& first, const Solid<M>& second, double margin, const Manifold<M>& manifold) {
  if (manifold.empty()) return;
  ASSERT_LE(manifold.size, Manifold<M>::capacity);
  ASSERT_NEAR(manifold.normal.norm(), 1, rounding);
  for (const auto& point : manifold) {
    ASSERT_NEAR(point.separation, (point.p2 - point.p1).dot(manifold.normal), rounding);
    ASSERT_LE(point.separation, margin);
    ASSERT_NEAR(height_over(first, point.p1), 0, rounding);
    ASSERT_NEAR(height_over(second, point.p2), 0, rounding);
    for (const auto& other : manifold)
      ASSERT_TRUE(&point == &other || point.feature != other.feature) << "feature " << point.feature << " twice";
  }
}

/// Two manifolds of the same two solids, point by point.
template <class M>
void expect_same(const Manifold<M>& a, const Manifold<M>& b, double tolerance) {
  ASSERT_EQ(a.size, b.size);
  if (a.empty()) return;
  ASSERT_LE(difference(a.normal, b.normal), tolerance);
  for (int i = 0; i < a.size; ++i) {
    const auto& p = a.points[i];
    const auto same = std::find_if(b.begin(), b.end(), [&](const auto& q) {
      return difference(p.p1, q.p1) <= tolerance && difference(p.p2, q.p2) <= tolerance;
    });
    ASSERT_NE(same, b.end()) << "point " << i << " is not there";
    ASSERT_NEAR(p.separation, same->separation, tolerance);
  }
}

template <class M>
Pose<M> carried(const Pose<M>& by, const Pose<M>& pose) {
  Pose<M> result;
  result.position = to_world<M>(by, pose.position);
  if constexpr (M::angular > 0) result.rotation = by.rotation * pose.rotation;
  return result;
}

/// Calls f on pairs of random boxes, and says on failure which draw it was.
template <class M, class F>
void on_box_pairs(int draws, F&& f) {
  Random random;
  const auto any_box = [&] {
    Solid<M> box{random_box<M>(random), random.pose<M>()};
    if (M::linear == 3) box.pose.position /= 2;
    return box;
  };
  for (int draw = 0; draw < draws && !testing::Test::HasFatalFailure(); ++draw) {
    SCOPED_TRACE(testing::Message() << "draw " << draw << ", seed " << seed);
    const Solid<M> second = any_box(), first = any_box();
    f(random, first, second);
  }
}

template <class M>
bool has_feature(const Manifold<M>& manifold, std::uint32_t feature) {
  return std::any_of(manifold.begin(), manifold.end(),
                     [&](const auto& point) { return point.feature == feature; });
}

/// Features are the same after boxes have moved hardly at all.
template <class M>
void expect_lasting_features() {
  on_box_pairs<M>(3000, [](Random& random, const auto& first, Solid<M> second) {
    const auto before = touch(first, second, 0.5);
    move<M>(second.pose, Velocity<M>(random.vector<M::dof>(1)), 1e-7);
    const auto after = touch(first, second, 0.5, before.reference);
    ASSERT_EQ(before.size, after.size);
    for (const auto& point : before) EXPECT_TRUE(has_feature(after, point.feature));
  });
}

/// A side of a box, a place or a part of a turn, such that surfaces meet exactly or miss by a rounding error.
inline double degenerate_side(Random& random) { return std::array{0.5, 1.0, 2.0, 1e-6, 1e3}[random.index(5)]; }
inline double off_by_rounding(Random& random) {
  return std::array{0.0, 0.0, 0.0, 1e-300, 1e-17, -1e-16, 1e-15, 1e-12, -1e-9}[random.index(9)];
}

/// Sound answers for pairs of such boxes, with rounding in proportion to `size_of` them [m]; `look` sees each pair
/// with its manifold.
template <class M, class Make, class Size, class Look>
void expect_sound_where_degenerate(Make&& degenerate, int hints, Size&& size_of, Look&& look) {
  Random random;
  int touching = 0;
  for (int draw = 0; draw < 100'000 && !testing::Test::HasFatalFailure(); ++draw) {
    SCOPED_TRACE(testing::Message() << "draw " << draw << ", seed " << seed);
    const Solid<M> first = degenerate(random), second = degenerate(random);
    const double margin = random.index(2) * 0.02, size = size_of(first, second);
    const auto manifold = touch(first, second, margin, random.index(hints));
    ASSERT_TRUE(manifold.size == 0 || std::abs(manifold.normal.norm() - 1) < rounding);
    for (const auto& point : manifold) {
      ASSERT_LE(point.separation, margin);
      ASSERT_LE(std::abs(height_over(first, point.p1)), rounding * size);
      ASSERT_LE(std::abs(height_over(second, point.p2)), rounding * size);
      ASSERT_LE(std::abs(point.separation - (point.p2 - point.p1).dot(manifold.normal)), rounding * size);
    }
    look(first, second, manifold);
    touching += !manifold.empty();
  }
  EXPECT_GT(touching, 30'000);
}

}  // namespace byhand
