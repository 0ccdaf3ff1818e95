#include "solver/contact/sweep_and_prune.hpp"

#include <algorithm>

#include "tests/solver/random.hpp"

namespace collide_pairs_test {

using namespace byhand;

constexpr double infinity = std::numeric_limits<double>::infinity();

template <int dim>
using Boxes = std::vector<Eigen::AlignedBox<double, dim>>;

/// Boxes of all sizes, some of them points, some without limits, some empty.
template <int dim>
Boxes<dim> random_boxes(Random& random, int count) {
  using Vector = Eigen::Matrix<double, dim, 1>;
  Boxes<dim> result(count);
  for (auto& box : result) {
    const Vector at = random.vector<dim>(10), half = random.vector<dim>(1).cwiseAbs();
    switch (random.index(20)) {
      case 0: break;
      case 1: box = {Vector::Constant(-infinity), Vector::Constant(infinity)}; break;
      case 2: box = {at, at}; break;
      default: box = {Vector(at - half), Vector(at + half)};
    }
  }
  return result;
}

template <int dim>
std::vector<BodyPair> all_pairs(const Boxes<dim>& boxes) {
  std::vector<BodyPair> result;
  for (int i = 0; i < static_cast<int>(boxes.size()); ++i)
    for (int j = i + 1; j < static_cast<int>(boxes.size()); ++j) {
      if (!boxes[i].isEmpty() && !boxes[j].isEmpty() && boxes[i].intersects(boxes[j])) result.push_back({i, j});
    }
  return result;
}

template <class F>
void in_plane_and_space(F&& f) {
  f.template operator()<2>(Random());
  f.template operator()<3>(Random());
}

TEST(SweepAndPrune, FindsThePairsThatComparingAllFindsInOrder) {
  in_plane_and_space([]<int dim>(Random random) {
    for (int draw = 0; draw < 150; ++draw) {
      const auto boxes = random_boxes<dim>(random, random.index(200));
      EXPECT_EQ(SweepAndPrune<dim>().overlapping(boxes), all_pairs<dim>(boxes));
    }
  });
}

TEST(SweepAndPrune, FindsThemWhateverItSawBefore) {
  in_plane_and_space([]<int dim>(Random random) {
    SweepAndPrune<dim> sweep;
    for (int draw = 0; draw < 20; ++draw) {
      auto boxes = random_boxes<dim>(random, 60 + draw / 10);
      for (int step = 0; step < 20; ++step) {
        EXPECT_EQ(sweep.overlapping(boxes), all_pairs<dim>(boxes));
        for (auto& box : boxes) box.translate(random.vector<dim>(0.2));
      }
    }
  });
}

TEST(SweepAndPrune, FollowsTheAxisOnWhichTheBoundsSpread) {
  in_plane_and_space([]<int dim>(Random random) {
    SweepAndPrune<dim> sweep;
    const auto boxes = random_boxes<dim>(random, 60);
    for (int axis : {0, 1, dim - 1, 0, dim - 1, 1}) {
      auto spread = boxes;
      for (auto& box : spread)
        if (!box.isEmpty()) box.min()[axis] *= 5, box.max()[axis] *= 5;
      for (int call = 0; call < 64; ++call) ASSERT_EQ(sweep.overlapping(spread), all_pairs<dim>(spread));
      EXPECT_EQ(sweep.axis(), axis);
    }
  });
}

TEST(SweepAndPrune, SortsARowAlongItselfAtOnce) {
  in_plane_and_space([]<int dim>(Random) {
    using Vector = Eigen::Matrix<double, dim, 1>;
    for (int axis = 0; axis < dim; ++axis) {
      SweepAndPrune<dim> sweep;
      Boxes<dim> boxes = {{Vector::Constant(-infinity), Vector::Constant(infinity)}};  // the ground
      for (int i = 0; i < 2000; ++i)
        boxes.emplace_back(Vector(i * Vector::Unit(axis)), Vector(i * Vector::Unit(axis) + Vector::Ones()));
      EXPECT_EQ(sweep.overlapping(boxes).size(), 1999U + 2000U);
      EXPECT_EQ(sweep.axis(), axis);
    }
  });
}

TEST(SweepAndPrune, NumbersThePairsOfBodiesAddedInAnotherOrderAnotherWayAndNoMore) {
  in_plane_and_space([]<int dim>(Random random) {
    const auto boxes = random_boxes<dim>(random, 200);
    std::vector<int> order(boxes.size());
    for (int i = 0; i < static_cast<int>(order.size()); ++i) order[i] = (i * 77) % static_cast<int>(order.size());
    Boxes<dim> shuffled;
    for (const int i : order) shuffled.push_back(boxes[i]);
    std::vector<BodyPair> renamed = SweepAndPrune<dim>().overlapping(shuffled);
    for (auto& pair : renamed) {
      const auto [first, second] = std::minmax(order[pair.first], order[pair.second]);
      pair = {first, second};
    }
    std::sort(renamed.begin(), renamed.end());
    EXPECT_EQ(renamed, SweepAndPrune<dim>().overlapping(boxes));
  });
}

TEST(SweepAndPrune, CountsBoundsThatOnlyTouch) {
  const Eigen::AlignedBox2d left(Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 1)),
      right(Eigen::Vector2d(1, 1), Eigen::Vector2d(2, 2));
  EXPECT_EQ(SweepAndPrune<2>().overlapping({left, right}), (std::vector<BodyPair>{{0, 1}}));
}

TEST(SweepAndPrune, PairsNothingWithBoundsThatAreNotNumbers) {
  Random random;
  auto boxes = random_boxes<2>(random, 50);
  boxes[7] = {Eigen::Vector2d::Constant(std::nan("")), Eigen::Vector2d::Constant(std::nan(""))};
  SweepAndPrune<2> broad_phase;
  for (const auto& pair : broad_phase.overlapping(boxes)) EXPECT_TRUE(pair.first != 7 && pair.second != 7);
}

TEST(SweepAndPrune, KeepsItsMemory) {
  Random random;
  auto boxes = random_boxes<2>(random, 200);
  SweepAndPrune<2> sweep;
  const auto* memory = sweep.overlapping(boxes).data();
  for (auto& box : boxes) box.translate(Eigen::Vector2d(1e-9, 0));
  EXPECT_EQ(sweep.overlapping(boxes).data(), memory);
}

}  // namespace collide_pairs_test
