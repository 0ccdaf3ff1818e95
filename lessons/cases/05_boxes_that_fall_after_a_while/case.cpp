#include <cmath>

#include "lessons/cases/case.hpp"
#include "lessons/laws/closed_forms.hpp"
#include "lessons/laws/creep.hpp"
#include "lessons/laws/law.hpp"

namespace byhand::cases {
namespace {

using M = PlaneBody;
constexpr int boxes = 10;

/// Whether the file's column still stands after some time under another gravity [m/s²].
bool stands(const SceneFile& file, double gravity, double seconds) {
  Simulation<M> column = begin<M>(file);
  column.scene.gravity = {0, -gravity};
  const long steps = std::lround(seconds / file.step);
  for (long i = 0; i < steps; ++i) {
    column.step(file.step);
    if (!(std::abs(column.scene.bodies().pose.back().position.x()) < 1e-4)) return false;
  }
  return true;
}

Case make() {
  return {
      .title = "A stack falls after some seconds",
      .report =
          "A few boxes stand for some seconds and then topple, although nothing touches them and the solver makes "
          "many iterations.",
      .link = "https://github.com/RandyGaul/qu3e/issues/54",
      .law = 18,
      .why =
          "Gravity tips a leaning column over: a lean x grows as ẍ = σ²x, σ² = 1.571 g/Na. Sweeps undo its "
          "bending only slowly: with N square boxes one sweep leaves ρ = 1 − 2.06/N⁴ of it, k sweeps leave q = "
          "ρᵏ. The column stands while (σh)² < (1 − q)/q. Beyond that, a push too small to see grows by a "
          "constant factor in each step, which takes its time.",
      .equation = {"(σh)² = (1 − q)/q", R"((\sigma h)^2 = \frac{1-q}{q})"},
      .numbers =
          [](const SceneFile& file) {
            const int sweeps = std::get<GaussSeidel>(file.method.solver).sweeps;
            const double predicted = laws::gravity_that_sweeps_hold(boxes, sweeps, file.step);
            const double found = laws::bisect([&](double gravity) { return stands(file, gravity, 60); },
                                              0.4 * predicted, 2.5 * predicted, 0.01);
            return std::vector<Number>{
                {"gravity up to which one sweep holds ten boxes", "m/s²", predicted, found, "law 18", 0.1}};
          },
      .engines = Question{"how far the top box has gone aside after 20 s", "m", 20,
                          [](const Scene<M>& scene) { return std::abs(scene.bodies().pose[10].position.x()); }},
      .cure =
          "More sweeps: ¾gh²N³/a of them for squares of side a. Better, n substeps, which are worth n² sweeps. Or "
          "an exact solve, with which a stack of any height stands.",
      .cured =
          [](SceneFile file) {
            file.method.substeps = 2;
            return file;
          },
      .numbers_cured =
          [](const SceneFile& file) {
            return std::vector<Number>{{"whether they stand for 60 s with two substeps", "1", 1,
                                        stands(file, 9.81, 60) ? 1.0 : 0.0, "law 18", 0}};
          },
      .takeaway = "A stack that falls late was falling from the start: look at the logarithm of its lean."};
}
const bool told = tell(__FILE__, make);

}  // namespace
}  // namespace byhand::cases
