#include <cmath>

#include "lessons/cases/case.hpp"
#include "lessons/methods/xpbd.hpp"

namespace byhand::cases {
namespace {

using M = PlaneParticle;

/// ω after some time, with XPBD [rad/s].
double spin(const SceneFile& file, int substeps, double seconds) {
  Simulation<M, Xpbd> wheel{std::get<Scene<M>>(file.scene), Xpbd{.substeps = substeps}};
  const long steps = std::lround(seconds / file.step);
  for (long i = 0; i < steps; ++i) wheel.step(file.step);
  const Bodies<M>& bodies = wheel.scene.bodies();
  return bodies.velocity[1].norm() / bodies.pose[1].position.norm();
}
double predicted(const SceneFile& file, int substeps, double seconds) {
  const double first = std::get<Scene<M>>(file.scene).bodies().velocity[1].y();
  return first / std::sqrt(1 + 2 * first * first * file.step / substeps * seconds);
}

Case make() {
  return {
      .title = "Corrections of positions lose spin",
      .report =
          "A user of a position-based tutorial sees that bodies turning on joints lose their angular momentum.",
      .link = "https://github.com/matthias-research/pages/issues/5",
      .law = 3,
      .why =
          "XPBD moves freely, pulls the body back onto the circle, and takes the velocity from the line between "
          "the two places. That line is a chord, not a tangent: a body that turned by φ in one step turns by φ₁ "
          "in the next, tan φ₁ = sin φ/(2 − cos φ), which is about φ − φ³. The spin about the nail falls as "
          "ω₀/√(1 + 2ω₀²ht), without any damping.",
      .equation = {"ω(t) = ω₀/√(1 + 2ω₀²ht)", R"(\omega(t) = \frac{\omega_0}{\sqrt{1 + 2\omega_0^2 h t}})"},
      .numbers =
          [](const SceneFile& file) {
            return std::vector<Number>{{"spin after 1 s, one substep", "rad/s", predicted(file, 1, 1),
                                        spin(file, 1, 1), "chord instead of tangent", 0.02},
                                       {"spin after 1 s, 20 substeps", "rad/s", predicted(file, 20, 1),
                                        spin(file, 20, 1), "chord instead of tangent", 0.01}};
          },
      .cure =
          "Substeps: the loss is in proportion to h. Methods on velocities keep this angular momentum exactly, "
          "whatever the step, "
          "because an impulse along the rod has no torque about the nail.",
      .cured =
          [](SceneFile file) {
            file.method = {Direct{}, Baumgarte{.beta = 0.2}, 1};
            return file;
          },
      .numbers_cured =
          [](const SceneFile& file) {
            Simulation<M> wheel = after<M>(file, 1);
            return std::vector<Number>{{"angular momentum after 1 s", "kg m²/s", 3,
                                        angular_momentum(wheel.scene.bodies())[0], "the pull has no torque",
                                        1e-6}};
          },
      .takeaway =
          "Correcting positions is stable but lossy. Ask what a method conserves before you ask how stiff it is."};
}
const bool told = tell(__FILE__, make);

}  // namespace
}  // namespace byhand::cases
