#include "lessons/cases/case.hpp"
#include "lessons/laws/closed_forms.hpp"

namespace byhand::cases {
namespace {

using M = PlaneParticle;

double kept(const SceneFile& file) {
  const double before = kinetic_energy(begin<M>(file).scene.bodies());
  return kinetic_energy(after<M>(file, 1).scene.bodies()) / before;
}
double predicted(const SceneFile& file) {
  const double radius = laws::drifted_radius(1, 3, file.step / file.method.substeps, 1);
  return 1 / (radius * radius);
}

Case make() {
  return {
      .title = "A pendulum loses energy with all damping off",
      .report =
          "A teacher's first example is a pendulum. It comes to rest even with all friction and damping at zero.",
      .link = "https://github.com/liabru/matter-js/issues/1250 (and godot#6323, dart#846, bepu#368)",
      .law = 3,
      .why =
          "A step moves along a tangent, which leaves the circle outwards. The rod takes the outward speed away, "
          "and its work "
          "is gone. Without gravity and without a cure of drift the angular momentum is kept exactly and the "
          "radius grows as R(1 + 2v²ht/R²)^¼, so the energy falls as one over its square. At first the loss is "
          "linear in h: half the step, half the loss.",
      .equation = {"E/E₀ = (1 + 2v²ht/R²)^(−½)", R"(\frac{E}{E_0} = \left(1 + \frac{2v^2ht}{R^2}\right)^{-1/2})"},
      .numbers =
          [](const SceneFile& file) {
            return std::vector<Number>{{"energy kept after 1 s", "1", predicted(file), kept(file), "law 3", 0.02}};
          },
      .cure =
          "Substeps: the loss falls in proportion to h. Or a symmetric method: RATTLE keeps the energy of a "
          "pendulum for a "
          "thousand periods (./lessons/run scene lessons/cases/07_a_pendulum_that_loses_energy/scene.json "
          "--method rattle).",
      .cured =
          [](SceneFile file) {
            file.method.substeps = 16;
            return file;
          },
      .numbers_cured =
          [](const SceneFile& file) {
            return std::vector<Number>{
                {"energy kept after 1 s with 16 substeps", "1", predicted(file), kept(file), "law 3", 0.001}};
          },
      .takeaway = "An energy loss that halves with the step comes from the method, not from hidden damping."};
}
const bool told = tell(__FILE__, make);

}  // namespace
}  // namespace byhand::cases
