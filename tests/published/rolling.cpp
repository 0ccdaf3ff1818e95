#include <fmt/format.h>

#include "lessons/scenes/boxes.hpp"
#include "solver/step.hpp"
#include "tests/published/figure.hpp"

namespace byhand::published {
namespace {

using M = SpaceBody;

constexpr double h = 0.001, force = 150;  // [s], [N]
constexpr int steps = 4000;
const Linear<M> direction(0.5, 0, std::sqrt(0.75));

// On the ground μ N = 137.3 N act on the box, which slides, and on each ball f, which rolls: 3.5 f = a.
constexpr double ground_friction = 0.4 * 35 * 9.81;                            // [N]
constexpr double ball_a = (force - ground_friction) / 10 / (3.5 + 25 / 10.0);  // [m/s²], of 1 kg
constexpr double box_a = 3.5 * ball_a;

/// Mean square of the errors of the velocities of the box and of the first ball, added [m²/s²]; `measured(i)` are
/// those after i steps.
template <class F>
double mean_square(F&& measured) {
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const auto [box, ball] = measured(i);
    sum += (box - box_a * i * h * direction).squaredNorm() + (ball - ball_a * i * h * direction).squaredNorm();
  }
  return sum / steps;
}
struct Velocities {
  Linear<M> box, ball;
};

/// A plate of 10 kg, 20 m wide and 1 m thick, on the ground with μ = 0.4, and on it 5 × 5 balls of 1 kg with
/// μ = 0.8; a pair has the friction √(μ1 μ2). Body 1 is the plate, body 2 the first ball.
Entry rolled() {
  Scene<M> scene;
  add_ground(scene, {0.2});
  add_box<M>(scene, {.position = {0, 0.5, 0}}, 10, {20, 1, 20}, {0.8});
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) {
      const int body = scene.add_body(Linear<M>(2 * i - 4, 1.5, 2 * j - 4), ball<M>(1, 0.5));
      scene.set_shape(body, Ball<M>{0.5}, {0.8});
    }
  Simulation<M> simulation{std::move(scene)};
  double error = 0;
  const double time = seconds([&] {
    error = mean_square([&](int i) {
      if (i > 0) {
        simulation.scene.add_force(1, force * direction);
        simulation.step(h);
      }
      const auto& V = simulation.scene.bodies().velocity;
      return Velocities{V[1].head<3>(), V[2].head<3>()};
    });
  });
  const double tolerance = ConjugateSweeps().tolerance;
  return {"ours", error, "default method", time, 2 * tolerance * tolerance};
}

}  // namespace

// Bound: two velocities with errors of the solver's tolerance, 1e-5 m/s.
Figure rolling() {
  const double still = mean_square([](int) { return Velocities{Linear<M>::Zero(), Linear<M>::Zero()}; });
  return {"Rolling (SimBenchmark)",
          "150 N push a plate of 10 kg with 25 rolling balls of 1 kg at 60° to the axes; 4 s, steps of 1 ms.",
          "github.com/leggedrobotics/SimBenchmark, data/rolling/sample.csv: without error reduction.",
          {{"velocities² [m²/s²]",
            0,
            "mean square error of plate and ball",
            {rolled(),
             {"RaiSim", 4.1244e-07, "", 0.242573},
             {"Bullet", 6.42665e-09, "multibody", 0.594155},
             {"MuJoCo", 0.00607996, "PGS", 1.43433},
             {"MuJoCo", 0.0079924, "CG", 0.767615},
             {"MuJoCo", 0.00705417, "Newton", 0.851418},
             {"ODE", 3.14497, "quick", 0.748831},
             {"DART", 3.14497, "Dantzig", 2.86101},
             {"DART", 3.14497, "PGS", 3.06796},
             {"who does not move", still,
              fmt::format("a pyramid holds 75 N and {:.1f} N by axis, below {:.1f} N", force * direction.z(),
                          ground_friction)}}}}};
}

}  // namespace byhand::published
