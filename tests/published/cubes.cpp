#include "lessons/scenes/boxes.hpp"
#include "solver/measure.hpp"
#include "tests/published/figure.hpp"

namespace byhand::published {
namespace {

using M = SpaceBody;

constexpr double a = 0.2, h = 0.001;  // side [m], time step [s]
constexpr int steps = 100;

}  // namespace

// Bounds: the solver's tolerance of 1e-5 m/s × 0.1 s.
Figure cubes() {
  Scene<M> scene;
  add_ground(scene, {0.9});
  add_box<M>(scene, {.position = {0, a / 2 + a / 50, 0}}, 1e-3, {a, a, a}, {0.9});
  add_box<M>(scene, {.position = {0, 3 * a / 2 + 3 * a / 50, 0}}, 1e3, {a, a, a}, {0.95 * 0.95 / 0.9});
  Simulation<M> cubes{std::move(scene)};
  double deepest = 0, worst = 0;
  const double time = seconds([&] {
    for (int i = 0; i < steps; ++i) {
      cubes.step(h);
      deepest = std::max(deepest, position_error(cubes).max);
      worst = std::max(worst, residual(cubes.work.system, cubes.scene.bodies().velocity));
    }
  });
  const double tolerance = ConjugateSweeps().tolerance, bound = tolerance * steps * h;
  const auto ours = [&](double value, double within) {
    return std::vector<Entry>{{"ours", value, "default method", time, within}};
  };
  const auto& pose = cubes.scene.bodies().pose;
  return {"Two cubes (ContactBench)",
          "1000 kg fall onto 1 g, which falls onto the ground; sides 0.2 m, 0.1 s, steps of 1 ms.",
          "github.com/Simple-Robotics/ContactBench, examples/2cubes.py; no numbers of its results were found.",
          {{"lower cube at 0.1 s [m]", a / 2, "at rest", ours(pose[1].position.y(), bound)},
           {"upper cube at 0.1 s [m]", 3 * a / 2, "at rest", ours(pose[2].position.y(), bound)},
           {"overlap [m]", 0, "largest of all steps", ours(deepest, bound)},
           {"residual [m/s]", 0, "of Signorini and Coulomb, largest of all steps", ours(worst, tolerance)}}};
}

}  // namespace byhand::published
