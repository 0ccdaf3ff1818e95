#include <fmt/format.h>

#include "lessons/scenes/boxes.hpp"
#include "solver/measure.hpp"
#include "tests/published/figure.hpp"

namespace byhand::published {
namespace {

using M = SpaceBody;

constexpr double g = 9.81, mass = 49 * 10, fall = 5 - 0.1;  // [m/s²], [kg], [m]

struct Run {
  Entry stepped, timed;  // with the velocities of steps, and with those at the time of the places
};

/// 7 × 7 balls of 10 kg and 0.2 m that bounce without loss from 5 m for 20 s: mean square error of their energy
/// [J²]. The velocity after a step belongs to half a step before the place that it leads to, so that the energy of
/// both is off by ½ m g h v.
Run bounced(double h) {
  Scene<M> scene;
  const Surface surface{0, 1};
  add_ground(scene, surface);
  for (int i = 0; i < 7; ++i)
    for (int j = 0; j < 7; ++j) {
      const int body = scene.add_body(Linear<M>(2 * i, 5, 2 * j), ball<M>(10, 0.1));
      scene.set_shape(body, Ball<M>{0.1}, surface);
    }
  Simulation<M> balls{std::move(scene)};
  const double before = energy(balls.scene);
  const int steps = std::lround(20 / h);
  double stepped = 0, timed = 0, time = 0;
  for (int i = 0; i < steps; ++i) {
    const double error = energy(balls.scene) - before;
    const double shift = h / 2 * balls.scene.gravity.dot(linear_momentum(balls.scene.bodies()));
    stepped += error * error;
    timed += (error + shift) * (error + shift);
    time += seconds([&] { balls.step(h); });
  }
  // (½ m g h v)² with the mean of v² over a fall, 2 g H/3.
  const double by_steps = std::pow(mass * g * h / 2, 2) * 2 * g * fall / 3;
  const std::string how = fmt::format("default method, {:g} s", h);
  return {
      {"ours", stepped / steps, fmt::format("{}; steps alone make {:.4g}", how, by_steps), time, 1.02 * by_steps},
      {"ours", timed / steps, how, time, std::pow(1e-13 * before, 2)}};
}

}  // namespace

// Bounds: what steps of h make, and 2 % for bounces that do not fill the 20 s; then 1e-13 of the energy.
Figure bouncing() {
  const Run fine = bounced(0.001), coarse = bounced(0.01);
  return {
      "Bouncing (SimBenchmark)",
      "49 balls of 10 kg bounce on the ground, e = 1, from 5 m, for 20 s.",
      "github.com/leggedrobotics/SimBenchmark, data/bouncing/sample.csv: without error reduction.",
      {{"energy², 0.001 s [J²]",
        0,
        "mean square error",
        {fine.stepped,
         {"RaiSim", 0.0186204, "", 0.223834},
         {"ODE", 185.027, "quick", 1.88695},
         {"ODE", 185.027, "standard", 1.85601},
         {"Bullet", 75245.4, "multibody", 0.851648},
         {"DART", 72274.4, "Dantzig", 3.2084}}},
       {"energy², 0.01 s [J²]",
        0,
        "mean square error",
        {coarse.stepped,
         {"RaiSim", 185.953, "", 0.0252268},
         {"ODE", 18808.3, "quick", 0.189298},
         {"ODE", 18808.3, "standard", 0.188425},
         {"Bullet", 7.40664e+06, "multibody", 0.102335},
         {"DART", 7.37588e+06, "Dantzig", 0.338765}}},
       {"energy², at places [J²]", 0, "the same, with velocities half a step on", {fine.timed, coarse.timed}}}};
}

}  // namespace byhand::published
