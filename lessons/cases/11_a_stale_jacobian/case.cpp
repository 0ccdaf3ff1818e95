#include <cmath>

#include "lessons/cases/case.hpp"

namespace byhand::cases {
namespace {

using M = PlaneParticle;

double speed(const SceneFile& file, double seconds) {
  return after<M>(file, seconds).scene.bodies().velocity[1].norm();
}

Case make() {
  return {
      .title = "A joint that works with a stale Jacobian",
      .report =
          "A prismatic joint diverged because its effective mass was computed once and then used in every substep "
          "and in the "
          "relaxation, after the bodies had moved.",
      .link = "https://github.com/erincatto/box2d/pull/981",
      .law = 14,
      .why =
          "The relaxation asks for JV = 0 with the J from before the move. The body has turned by φ = vh/R since, "
          "so the velocity along the old tangent points partly along the rod. The next step takes that part away, "
          "and the speed falls by v(1 − cos φ), about vφ²/2 in each step: dv/dt = −hv³/(2R²).",
      .equation = {"v(t) = v₀/√(1 + h v₀² t/R²)", R"(v(t) = \frac{v_0}{\sqrt{1 + h v_0^2 t/R^2}})"},
      .numbers =
          [](const SceneFile& file) {
            const double h = file.step / file.method.substeps, t = 5;
            return std::vector<Number>{
                {"speed after 5 s", "m/s", 3 / std::sqrt(1 + h * 9 * t), speed(file, t), "law 14", 0.1}};
          },
      .cure = "Write the rows anew at the poses where they are used: arms, J and effective mass belong together.",
      .cured =
          [](SceneFile file) {
            std::get<SoftConstraints>(file.method.drift).refresh = true;
            return file;
          },
      .numbers_cured =
          [](const SceneFile& file) {
            return std::vector<Number>{
                {"speed after 5 s", "m/s", 3, speed(file, 5), "v stays along the tangent", 0.02}};
          },
      .takeaway =
          "A J is right at one pose. If you move the bodies, write it again, or know what the old one costs."};
}
const bool told = tell(__FILE__, make);

}  // namespace
}  // namespace byhand::cases
