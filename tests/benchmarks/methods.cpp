#include "lessons/methods/method.hpp"

#include <benchmark/benchmark.h>

#include "lessons/scenes/chain.hpp"
#include "solver/measure.hpp"

// What a step of each family costs on one scene: a chain of 50 rods with a bob of 100 times the others' mass,
// which swings gently, again and again for five seconds. Explicit Euler is not
// among them: it explodes, at a fourth of the cost of RK4. "400n" is 400 ns a joint and step.
namespace {

using namespace byhand;
using benchmark::Counter;

void step_chain(benchmark::State& state, const Method& method) {
  const auto scene = rod_chain<PlaneParticle>({.links = 50, .end_mass = 100, .angle = 0.1});
  std::visit(
      [&]<class Family>(const Family& family) {
        Simulation simulation{scene, family};
        simulation.step(1.0 / 60);
        const auto start = simulation;
        long long row_solves = 0;
        for (auto _ : state) {
          if (simulation.time > 5) {  // or what drifts would have drifted away
            row_solves += simulation.work.row_solves - start.work.row_solves;
            simulation = start;
          }
          simulation.step(1.0 / 60);
          benchmark::ClobberMemory();
        }
        row_solves += simulation.work.row_solves - start.work.row_solves;
        const double joints = scene.count();
        state.counters["per_joint"] = {joints, Counter::kIsIterationInvariantRate | Counter::kInvert};
        state.counters["row_solves"] = {static_cast<double>(row_solves) / joints, Counter::kAvgIterations};
        state.counters["drift"] = position_error(simulation.scene).max;  // [m²]: the run must still be one
      },
      method);
}

BENCHMARK_CAPTURE(step_chain, by_ten_sweeps, AnyStepping{});
BENCHMARK_CAPTURE(step_chain, directly, AnyStepping{Direct{}, Baumgarte{1}});
BENCHMARK_CAPTURE(step_chain, by_rk4, Accelerations{Scheme::rk4});
BENCHMARK_CAPTURE(step_chain, by_the_midpoint_rule, Accelerations{Scheme::implicit_midpoint});
BENCHMARK_CAPTURE(step_chain, by_rattle, Rattle{});
BENCHMARK_CAPTURE(step_chain, by_rattle_in_four_substeps, Rattle{4});
BENCHMARK_CAPTURE(step_chain, by_xpbd, Xpbd{});
BENCHMARK_CAPTURE(step_chain, by_avbd, Avbd{});

}  // namespace
