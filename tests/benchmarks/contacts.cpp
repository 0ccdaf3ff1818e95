#include <benchmark/benchmark.h>

#include "lessons/scenes/boxes.hpp"
#include "lessons/scenes/bridge.hpp"
#include "lessons/scenes/ragdoll.hpp"
#include "solver/direct/newton_work.hpp"
#include "solver/measure.hpp"
#include "solver/rows/operators.hpp"

// What a step with contacts costs, the whole of it and its parts, and what it leaves: a quick step that lets boxes
// sink or creep would be no step. What stands is kicked sideways to begin with, 0.02 m/s at the top.
namespace {

using namespace byhand;
using benchmark::Counter;

constexpr double h = 1.0 / 60;  // [s]
constexpr int steps = 300;      // 5 s

Counter time_per(double items) { return {items, Counter::kIsIterationInvariantRate | Counter::kInvert}; }

VelocityStepping method(const RowSolver& solver) {
  VelocityStepping method{solver};
  method.drift = Baumgarte{.beta = 0.2, .slop = 0.001, .speed_cap = 3};
  return method;
}

/// Five seconds from a kick: seconds a step in the mean, and what became of the topmost body.
template <class M>
void five_seconds(benchmark::State& state, const Scene<M>& scene, const RowSolver& solver) {
  Simulation simulation{scene, method(solver)};
  for (auto _ : state) {
    state.PauseTiming();
    simulation = {scene, method(solver)};
    if (!scene.colliders().shapes.empty()) kick(simulation.scene, 0.02);
    state.ResumeTiming();
    for (int i = 0; i < steps; ++i) simulation.step(h);
  }
  const auto shift = simulation.scene.bodies().pose.back().position - scene.bodies().pose.back().position;
  state.counters["per_step"] = time_per(steps);
  state.counters["bodies"] = scene.bodies().size() - 1;
  state.counters["contacts"] = simulation.work.contacts.constraints().count();
  state.counters["sideways"] = shift.x();
  state.counters["sunk"] = -shift.y();
  state.counters["penetration"] = position_error(simulation).max;
}

void stack_directly(benchmark::State& state) {
  five_seconds(state, stack(static_cast<int>(state.range(0)), static_cast<double>(state.range(1))), ByGraph{});
}
void pyramid_by_sweeps_until_done(benchmark::State& state) {
  five_seconds(state, pyramid(static_cast<int>(state.range(0))), ByGraph{});
}
void pyramid_by_ten_coloured_sweeps(benchmark::State& state) {
  five_seconds(state, pyramid(static_cast<int>(state.range(0))), GaussSeidel{.order = SweepOrder::coloured});
}
void pyramid_in_natural_order(benchmark::State& state) {
  five_seconds(state, pyramid(static_cast<int>(state.range(0))), GaussSeidel{});
}
void stack_in_space(benchmark::State& state) {
  five_seconds(state, stack<SpaceBody>(static_cast<int>(state.range(0))), ByGraph{});
}
void ragdolls(benchmark::State& state) {
  Scene<PlaneBody> scene;
  add_ground(scene);
  for (int i = 0; i < state.range(0); ++i) add_ragdoll(scene, Linear<PlaneBody>(2.5 * i, 1.5));
  five_seconds(state, scene, GaussSeidel{.sweeps = 20, .order = SweepOrder::coloured});
}
void bridge_directly(benchmark::State& state) {
  five_seconds(state, bridge({.planks = static_cast<int>(state.range(0))}), Direct{.regularisation = 1e-9});
}

BENCHMARK(stack_directly)->Args({10, 1})->Args({30, 1})->Args({30, 10})->Args({30, 100})->Args({300, 1});
BENCHMARK(pyramid_by_sweeps_until_done)->Arg(10)->Arg(20)->Unit(benchmark::kMillisecond);
BENCHMARK(pyramid_by_ten_coloured_sweeps)->Arg(20)->Unit(benchmark::kMillisecond);
BENCHMARK(pyramid_in_natural_order)->Arg(20)->Unit(benchmark::kMillisecond);
BENCHMARK(stack_in_space)->Arg(10)->Unit(benchmark::kMillisecond);
BENCHMARK(ragdolls)->Arg(1)->Arg(10)->Unit(benchmark::kMillisecond);
BENCHMARK(bridge_directly)->Arg(50)->Unit(benchmark::kMillisecond);

using Boxed = Simulation<PlaneBody>;
Prepared<PlaneBody>& prepared(Boxed& s) {
  return std::any_cast<ByGraphWork<PlaneBody>&>(s.work.solver).direct.prepared;
}

/// One part of a step of a scene at rest.
void part(benchmark::State& state, Scene<PlaneBody> scene, void (*run)(Boxed&)) {
  Boxed simulation{std::move(scene), method(ByGraph{})};
  for (int i = 0; i < steps; ++i) simulation.step(h);
  for (auto _ : state) {
    run(simulation);
    benchmark::ClobberMemory();
  }
  state.counters["per_contact"] = time_per(simulation.work.contacts.constraints().count());
}

void whole(Boxed& s) { s.step(h); }
void find_contacts(Boxed& s) { s.work.contacts.find(s.scene); }
void find_contacts_of_all_that_moves(Boxed& s) {
  ContactManager<PlaneBody> nothing_known;
  nothing_known.find(s.scene);
}
void write_rows(Boxed& s) { byhand::write_rows(s.scene, h, s.work); }
void prepare_rows(Boxed& s) { prepare(s.work.system, BlockSolve::whole, 1.0, prepared(s)); }
void sweep_once(Boxed& s) {
  sweep(s.work.system, prepared(s), s.work.system.lambda.data(), numbers<PlaneBody>(s.scene.state().velocity));
}
void solve_all_rows(Boxed& s) {
  const auto velocity = s.scene.bodies().velocity;
  add_gravity(s.scene.state(), s.scene.gravity, h);
  solve_rows(s.method.solver, s.scene.state(), s.work);
  s.scene.state().velocity = velocity;
}
void advance_all(Boxed& s) { advance_poses(s.scene.state(), 1e-9); }

#define PARTS_OF(name, scene)                                                            \
  BENCHMARK_CAPTURE(part, name##_whole_step, scene, whole);                              \
  BENCHMARK_CAPTURE(part, name##_find_contacts, scene, find_contacts);                   \
  BENCHMARK_CAPTURE(part, name##_find_all_anew, scene, find_contacts_of_all_that_moves); \
  BENCHMARK_CAPTURE(part, name##_write_rows, scene, write_rows);                         \
  BENCHMARK_CAPTURE(part, name##_solve_rows, scene, solve_all_rows);                     \
  BENCHMARK_CAPTURE(part, name##_advance, scene, advance_all)
PARTS_OF(stack_of_30, stack(30));
PARTS_OF(pyramid_of_210, pyramid(20));
BENCHMARK_CAPTURE(part, pyramid_of_210_prepare, pyramid(20), prepare_rows);
BENCHMARK_CAPTURE(part, pyramid_of_210_one_sweep, pyramid(20), sweep_once);

}  // namespace
