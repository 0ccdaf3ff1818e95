#include <benchmark/benchmark.h>

#include "lessons/scenes/branches.hpp"
#include "lessons/scenes/chain.hpp"
#include "solver/measure.hpp"
#include "solver/rows/operators.hpp"
#include "solver/rows/prepared.hpp"

// What a row, a joint and a step cost. The counters are seconds per row or per joint: "4.7n" is 4.7 ns.
namespace {

using namespace byhand;
using benchmark::Counter;

constexpr double step = 1.0 / 600;  // [s]; short, so that a long run stays calm

Counter time_per(double items) { return {items, Counter::kIsIterationInvariantRate | Counter::kInvert}; }

template <class M>
Scene<M> links(int count) {
  const ChainOptions chain{.links = count, .angle = 1};
  if constexpr (M::angular == 0)
    return rod_chain<M>(chain);
  else
    return pinned_chain<M>(chain);
}

/// One Gauss–Seidel sweep over a chain: rods of particles, pins of bodies.
template <class M>
void sweep_chain(benchmark::State& state, SweepOrder order) {
  Simulation<M> simulation{links<M>(static_cast<int>(state.range(0))), {GaussSeidel{.sweeps = 1, .order = order}}};
  simulation.step(step);
  auto& system = simulation.work.system;
  auto& prepared = std::any_cast<Prepared<M>&>(simulation.work.solver);
  for (auto _ : state) {
    sweep(system, prepared, system.lambda.data(), numbers<M>(simulation.scene.state().velocity));
    benchmark::ClobberMemory();
  }
  state.counters["per_row"] = time_per(system.rows());
}

template <class M>
void sweep_chain_in_natural_order(benchmark::State& state) {
  sweep_chain<M>(state, SweepOrder::natural);
}
template <class M>
void sweep_chain_in_coloured_order(benchmark::State& state) {
  sweep_chain<M>(state, SweepOrder::coloured);
}

template <class M>
void whole_step(benchmark::State& state, Scene<M> scene, const RowSolver& solver) {
  Simulation simulation{std::move(scene), {solver}};
  simulation.step(step);
  for (auto _ : state) {
    simulation.step(step);
    benchmark::ClobberMemory();
  }
  state.counters["per_joint"] = time_per(simulation.scene.count());
  state.counters["drift"] = position_error(simulation.scene).max;  // [m]: the run must still be one
}

template <class M>
void step_chain_directly(benchmark::State& state) {
  whole_step(state, links<M>(static_cast<int>(state.range(0))), Direct{});
}

template <class M>
void step_chain_by_ten_sweeps(benchmark::State& state) {
  whole_step(state, links<M>(static_cast<int>(state.range(0))), GaussSeidel{});
}

void step_tree_directly(benchmark::State& state) {
  whole_step(state, pinned_tree<PlaneBody>(static_cast<int>(state.range(0))), Direct{});
}

void step_star_directly(benchmark::State& state) {
  whole_step(state, pinned_star<PlaneBody>(static_cast<int>(state.range(0))), Direct{});
}

/// The parts of a step with the structured direct solve, one after the other.
void part_of_step(benchmark::State& state, void (*part)(Simulation<PlaneBody>&)) {
  Simulation<PlaneBody> simulation{links<PlaneBody>(200), {Direct{}}};
  simulation.step(step);
  for (auto _ : state) {
    part(simulation);
    benchmark::ClobberMemory();
  }
  state.counters["per_joint"] = time_per(200);
}
void write_rows(Simulation<PlaneBody>& simulation) { simulation.scene.write_rows(simulation.work.system, step); }
void solve_rows_directly(Simulation<PlaneBody>& simulation) {
  solve_rows(simulation.method.solver, simulation.scene.state(), simulation.work);
}
void advance(Simulation<PlaneBody>& simulation) { advance_poses(simulation.scene.state(), 1e-9); }

void chain_lengths(benchmark::internal::Benchmark* benchmark) {
  for (const int links : {10, 50, 200, 2000}) benchmark->Arg(links);
}

BENCHMARK(sweep_chain_in_natural_order<PlaneParticle>)->Apply(chain_lengths);
BENCHMARK(sweep_chain_in_coloured_order<PlaneParticle>)->Apply(chain_lengths);
BENCHMARK(sweep_chain_in_natural_order<PlaneBody>)->Apply(chain_lengths);
BENCHMARK(sweep_chain_in_coloured_order<PlaneBody>)->Apply(chain_lengths);
BENCHMARK(sweep_chain_in_natural_order<SpaceParticle>)->Apply(chain_lengths);
BENCHMARK(sweep_chain_in_coloured_order<SpaceParticle>)->Apply(chain_lengths);
BENCHMARK(sweep_chain_in_natural_order<SpaceBody>)->Apply(chain_lengths);
BENCHMARK(sweep_chain_in_coloured_order<SpaceBody>)->Apply(chain_lengths);

BENCHMARK(step_chain_directly<PlaneParticle>)->Apply(chain_lengths);
BENCHMARK(step_chain_directly<PlaneBody>)->Apply(chain_lengths);
BENCHMARK(step_chain_directly<SpaceParticle>)->Apply(chain_lengths);
BENCHMARK(step_chain_directly<SpaceBody>)->Apply(chain_lengths);
BENCHMARK(step_chain_by_ten_sweeps<PlaneBody>)->Apply(chain_lengths);
BENCHMARK(step_tree_directly)->Arg(8);
BENCHMARK(step_star_directly)->Arg(200);

BENCHMARK_CAPTURE(part_of_step, write_rows, write_rows);
BENCHMARK_CAPTURE(part_of_step, solve, solve_rows_directly);
BENCHMARK_CAPTURE(part_of_step, advance, advance);

}  // namespace
