#include <benchmark/benchmark.h>

#include "solver/contact/manifold.hpp"
#include "solver/contact/sweep_and_prune.hpp"

// What it costs to find contacts. The counters are seconds per pair of shapes or per body: "33n" is 33 ns.
namespace {

using namespace byhand;
using benchmark::Counter;

Counter time_per(double items) { return {items, Counter::kIsIterationInvariantRate | Counter::kInvert}; }

template <class M>
struct Solid {
  Shape<M> shape;
  Pose<M> pose;
};

/// As bodies in a pile: each turned a little, `overlap` [m] into the next.
template <class M>
std::vector<Solid<M>> column(const Shape<M>& even, const Shape<M>& odd, double height) {
  constexpr double overlap = 0.001;
  std::vector<Solid<M>> solids;
  for (int i = 0; i < 256; ++i) {
    Solid<M> solid{i % 2 == 0 ? even : odd, {}};
    solid.pose.position[0] = 0.01 * (i * 7 % 10);
    solid.pose.position[M::linear - 1] = i * (height - overlap);
    const double turn = 0.001 * (i * 3 % 7 - 3);
    if constexpr (M::angular == 1) solid.pose.rotation = plane_rotation(turn);
    if constexpr (M::angular == 3) solid.pose.rotation = space_rotation<double>({turn, 0.5 * turn, 20 * turn});
    solids.push_back(solid);
  }
  return solids;
}

template <class M>
void touch_neighbours(benchmark::State& state, const Shape<M>& even, const Shape<M>& odd, double height) {
  const auto solids = column<M>(even, odd, height);
  std::vector<std::uint32_t> references(solids.size());
  int points = 0;
  for (auto _ : state) {
    points = 0;
    for (std::size_t i = 0; i + 1 < solids.size(); ++i) {
      const auto &a = solids[i], &b = solids[i + 1];
      const auto manifold = collide<M>(a.shape, a.pose, b.shape, b.pose, 0.02, references[i]);
      references[i] = manifold.reference;
      points += manifold.size;
      benchmark::DoNotOptimize(manifold);
    }
  }
  const double pairs = static_cast<double>(solids.size()) - 1;
  state.counters["per_pair"] = time_per(pairs);
  state.counters["points"] = points / pairs;
}

template <class M>
Shape<M> unit_box() {
  return Box<M>{Linear<M>::Ones()};
}

template <class M>
void ball_and_ball(benchmark::State& state) {
  touch_neighbours<M>(state, Ball<M>{0.5}, Ball<M>{0.5}, 1);
}
template <class M>
void ball_and_box(benchmark::State& state) {
  touch_neighbours<M>(state, Ball<M>{0.5}, unit_box<M>(), 1);
}
template <class M>
void ball_and_half_space(benchmark::State& state) {
  touch_neighbours<M>(state, HalfSpace<M>{}, Ball<M>{0.5}, 0.25);
}
template <class M>
void box_and_half_space(benchmark::State& state) {
  touch_neighbours<M>(state, HalfSpace<M>{}, unit_box<M>(), 0.25);
}
template <class M>
void box_and_box(benchmark::State& state) {
  touch_neighbours<M>(state, unit_box<M>(), unit_box<M>(), 1);
}
/// Beyond the margin, as most pairs of a pile are whose bounds overlap.
template <class M>
void boxes_apart(benchmark::State& state) {
  touch_neighbours<M>(state, unit_box<M>(), unit_box<M>(), 1.03);
}
BENCHMARK(ball_and_ball<PlaneParticle>);
BENCHMARK(ball_and_ball<PlaneBody>);
BENCHMARK(ball_and_box<PlaneBody>);
BENCHMARK(ball_and_half_space<PlaneBody>);
BENCHMARK(box_and_half_space<PlaneBody>);
BENCHMARK(box_and_box<PlaneBody>);
BENCHMARK(boxes_apart<PlaneBody>);
BENCHMARK(ball_and_ball<SpaceParticle>);
BENCHMARK(ball_and_ball<SpaceBody>);
BENCHMARK(ball_and_box<SpaceBody>);
BENCHMARK(ball_and_half_space<SpaceBody>);
BENCHMARK(box_and_half_space<SpaceBody>);
BENCHMARK(box_and_box<SpaceBody>);
BENCHMARK(boxes_apart<SpaceBody>);

/// Unit boxes in a row ten high, which sway a little from call to call.
/// Columns of `height` boxes, a third of which sways.
template <int dim>
void sweep_and_prune(benchmark::State& state) {
  using Vector = Eigen::Matrix<double, dim, 1>;
  const int bodies = static_cast<int>(state.range(0)), height = static_cast<int>(state.range(1));
  std::vector<Eigen::AlignedBox<double, dim>> bounds;
  for (int i = 0; i < bodies; ++i) {
    Vector at = Vector::Zero();
    at[0] = 1.05 * (i / height) + 0.003 * (i % 10);
    at[1] = i % height;
    bounds.emplace_back(Vector(at - Vector::Constant(0.51)), Vector(at + Vector::Constant(0.51)));
  }
  SweepAndPrune<dim> sweep;
  std::size_t pairs = 0;
  double sway = 1e-3;
  for (auto _ : state) {
    for (int i = 0; i < bodies; i += 3) bounds[i].translate(sway * Vector::Unit(0));
    sway = -sway;
    pairs = sweep.overlapping(bounds).size();
    benchmark::ClobberMemory();
  }
  state.counters["per_body"] = time_per(bodies);
  state.counters["pairs_per_body"] = static_cast<double>(pairs) / bodies;
  state.SetComplexityN(bodies);
}
BENCHMARK(sweep_and_prune<2>)->ArgsProduct({{64, 256, 1024, 4096, 16384}, {10}})->Complexity(benchmark::oN);
BENCHMARK(sweep_and_prune<3>)->ArgsProduct({{64, 256, 1024, 4096, 16384}, {10}})->Complexity(benchmark::oN);
BENCHMARK(sweep_and_prune<2>)->Name("column")->Args({500, 500})->Args({2000, 2000})->Args({8000, 8000});

}  // namespace
