// The pyramid of 210 boxes beside the engines, by hand: benchmark_peers [ROUNDS].

#include <cstdio>
#include <cstdlib>

#include "lessons/engines/contest.hpp"
#include "lessons/scenes/boxes.hpp"
#include "lessons/scenes/chain.hpp"
#include "solver/measure.hpp"

namespace {

using namespace byhand;
using namespace byhand::engines;

VelocityStepping method() {
  ByGraph solver;
  solver.loops.tolerance = 1e-6;
  return {solver, Baumgarte{.beta = 0.2, .slop = 0.001, .speed_cap = 3}};
}

template <class M>
void compare(const char* name, const Scene<M>& scene, const std::vector<Contestant<M>>& contestants, int rounds) {
  constexpr int frames = 300;
  const std::vector<Seconds> times = seconds_a_frame(contestants, scene, frames, rounds);
  std::printf("%s\n", name);
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    double farthest = 0, error = 0;
    run<M>(contestants[i], scene, frames, [&](const Scene<M>& seen, double) {
      for (int body = 0; body < seen.bodies().size(); ++body)
        farthest =
            std::max(farthest, (seen.bodies().pose[body].position - scene.bodies().pose[body].position).norm());
      error = std::max(error, position_error(seen).max);
    });
    std::printf("  %-24s %8.2f us  %.2f of ours  moved %.2e m  error %.1e m\n", contestants[i].name.c_str(),
                1e6 * times[i].least, times[0].least / times[i].least, farthest, error);
  }
}

template <class M>
std::vector<Contestant<M>> all() {
  std::vector<Contestant<M>> contestants{ours<M>("ours", method())};
  for (const Engine& engine : all_engines())
    if (M::linear == 3 ? engine.in_space != nullptr : engine.name != "ODE direct")
      contestants.push_back(theirs<M>(engine, engine.usual));
  return contestants;
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 3;
  const bool only = argc > 2;
  Scene<PlaneBody> kicked = pyramid(20);
  kick(kicked, 0.02);
  auto two = all<PlaneBody>();
  if (only) two.resize(2);
  compare("pyramid of 210, from rest", pyramid(20), two, rounds);
  compare("pyramid of 210, kicked", kicked, two, rounds);
  if (only) return 0;
  auto few = all<PlaneBody>();
  compare("stack of 30", stack(30), few, rounds);
  auto space = all<SpaceBody>();
  std::erase_if(space, [](const auto& contestant) { return contestant.name == "ODE direct"; });
  compare("wall of 210 in space", pyramid<SpaceBody>(20), space, 1);
}
