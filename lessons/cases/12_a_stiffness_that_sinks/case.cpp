#include <cmath>

#include "lessons/cases/case.hpp"

namespace byhand::cases {
namespace {

using M = PlaneParticle;
constexpr double k = 6000, c = 900;  // of the file's contact [N/m, N s/m]

/// The file with another stiffness and damping of its contact.
SceneFile with(SceneFile file, double stiffness, double damping) {
  const double h = file.step, both = damping + h * stiffness;
  std::get<Baumgarte>(file.method.drift).beta = h * stiffness / both;
  std::get<Scene<M>>(file.scene).change_all<Contact>([=](Contact<M>& row) { row.softness = 1 / (h * both); });
  return file;
}

double depth(const SceneFile& file, double seconds) {
  return -after<M>(file, seconds).scene.bodies().pose[1].position.y();
}

/// The depth by hand: a step of implicit Euler for m dv/dt = −mg + k·depth − cv.
double sunk(double m, double g, double h, int steps) {
  double v = 0, height = 0;
  for (int i = 0; i < steps; ++i) {
    v = (v - g * h - h * k / m * height) / (1 + h * c / m + h * h * k / m);
    height += h * v;
  }
  return -height;
}

Case make() {
  return {
      .title = "A contact that is told to be stiff sinks",
      .report =
          "A box rests on its pedestal as long as contact stiffness and damping are left alone; with large "
          "numbers for both it sinks in.",
      .link = "https://github.com/bulletphysics/bullet3/issues/4428",
      .law = 11,
      .why =
          "Left alone, a contact is a hard row, γ = 0: as stiff as a row can be. Any k and c, however large, make "
          "it "
          "a spring: γ = 1/(h(c + hk)) and β = hk/(c + hk). At rest JV = 0, so βC/h = −γλ; with λ = mgh that is C "
          "= −mg/k. The damping c is in both and drops out: it only decides how slowly the box gets there.",
      .equation = {"C = −γ m g h²/β = −mg/k", R"(C = -\frac{\gamma\,m g h^2}{\beta} = -\frac{m g}{k})"},
      .numbers =
          [](const SceneFile& file) {
            const auto& scene = std::get<Scene<M>>(file.scene);
            const double m = 1 / scene.bodies().inverse_mass[1].linear, g = scene.gravity.norm();
            return std::vector<Number>{
                {"depth after 5 s", "m", m * g / k, depth(file, 5), "mg/k", 1e-6},
                {"depth after 0.2 s", "m", sunk(m, g, file.step, 12), depth(file, 0.2), "implicit Euler", 1e-6},
                {"depth after 5 s with twice the damping", "m", m * g / k, depth(with(file, k, 2 * c), 5), "mg/k",
                 1e-6},
                {"depth after 5 s with four times the stiffness", "m", m * g / (4 * k),
                 depth(with(file, 4 * k, c), 5), "mg/k", 1e-6}};
          },
      .cure =
          "Leave the row hard. Where it has to be soft, start from the depth that may be seen and take k = "
          "mg/depth. k counts against the weight, so no number is stiff for every box.",
      .cured =
          [](SceneFile file) {
            std::get<Scene<M>>(file.scene).change_all<Contact>([](Contact<M>& row) { row.softness = 0; });
            return file;
          },
      .numbers_cured =
          [](const SceneFile& file) {
            return std::vector<Number>{{"depth after 5 s", "m", 0, depth(file, 5), "C = 0", 1e-9}};
          },
      .takeaway =
          "A stiffness makes a rigid row soft. The box sinks by weight over stiffness, whatever the damping, the "
          "sweeps and the substeps."};
}
const bool told = tell(__FILE__, make);

}  // namespace
}  // namespace byhand::cases
