#include <fmt/format.h>

#include "lessons/exact/simple_pendulum.hpp"
#include "lessons/methods/method.hpp"
#include "lessons/scenes/pendulum.hpp"
#include "lessons/scenes/units.hpp"
#include "solver/measure.hpp"
#include "tests/published/figure.hpp"

namespace byhand::published {
namespace {

using M = PlaneParticle;

/// The largest change of energy of a pendulum of 1 kg and 1 m, let go from the horizontal, within 10 s [J].
template <class Method>
Entry drift(const Method& method, const char* name, double h, double bound) {
  Simulation<M, Method> pendulum{byhand::pendulum<M>(pi / 2, 1, 1), method};
  double largest = 0;
  const double time = seconds([&] {
    for (int i = std::lround(10 / h); i > 0; --i) {
      pendulum.step(h);
      largest = std::max(largest, std::abs(energy(pendulum.scene)));
    }
  });
  return {"ours", largest, fmt::format("{}, {:g} s", name, h), time, bound};
}

/// The largest distance of the bob from its exact place, at 4000 times within 2000 s [m].
Entry off(int steps, double bound) {
  const SimplePendulum exact(pi / 2, 1, 9.81);
  Simulation<M, Generalised> pendulum{byhand::pendulum<M>(pi / 2, 1, 1)};
  double largest = 0, time = 0;
  for (int i = 1; i <= 4000; ++i) {
    time += seconds([&] {
      for (int k = 0; k < steps; ++k) pendulum.step(0.5 / steps);
    });
    const Linear<M> place = from_straight_down<M>(exact.angle(0.5 * i));
    largest = std::max(largest, (pendulum.scene.bodies().pose[1].position - place).norm());
  }
  return {"ours", largest, fmt::format("generalised coordinates, RK4, {:g} s", 0.5 / steps), time, bound};
}

}  // namespace

// Bounds of the energy: the default method is of order 1, 14 J/s × h; RATTLE of order 2, 36 J/s² × h²; RK4 loses
// 1e-7 J in 10 s with h = 0.01 s and, of order 4 and more, a sixteenth at least with the half.
Figure pendulum() {
  return {
      "Simple pendulum (IFToMM benchmark A01)",
      "1 kg on a massless rod of 1 m, from rest in the horizontal.",
      "lim.ii.udc.es/mbsbenchmark/dist/A01/A01_specification.xml (2000 s, 4000 times, errors of at most 0.1 or\n"
      "  0.001, there relative); OpenSim 3.2: github.com/RehabEngGroup/MBSbenchmarksInOpenSim.",
      {{"energy, 10 s [J]",
        0,
        "largest change; nothing dissipates",
        {drift(VelocityStepping{}, "default method", 1e-3, 0.02),
         drift(Rattle{}, "RATTLE", 1e-3, 4e-5),
         drift(Generalised{}, "generalised coordinates, RK4", 5e-3, 1e-8),
         {"OpenSim", none, "i5-4570, 3.2 GHz", 0.637}}},
       {"place, 2000 s [m]", 0, "largest distance from elliptic functions", {off(50, 0.1), off(100, 0.001)}}}};
}

}  // namespace byhand::published
