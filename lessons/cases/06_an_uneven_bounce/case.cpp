#include "lessons/cases/case.hpp"

namespace byhand::cases {
namespace {

using M = PlaneBody;

/// The spin of a box of 1 kg and side 1 m after it has met the ground flat at `speed` with a restitution e: one
/// sweep until nothing approaches, one more for the bounce, the left corner's row before the right one's. By (17),
/// with K = 1/m + s²/I of each row and c = 1/m − s²/I between them, s = ½.
double spin_by_hand(double speed, double e, bool left_first) {
  const double m = 1, s = 0.5, I = m / 6;
  double v = -speed, spin = 0;
  const double K = 1 / m + s * s / I;
  double lambda[2] = {0, 0};
  const auto row = [&](int corner, double target) {
    const double arm = corner == 0 ? -s : s, rate = v + arm * spin;
    const double before = lambda[corner];
    lambda[corner] = std::max(0.0, before - (rate - target) / K);
    v += (lambda[corner] - before) / m;
    spin += arm * (lambda[corner] - before) / I;
  };
  for (const double target : {0.0, e * speed})
    for (const int corner : {left_first ? 0 : 1, left_first ? 1 : 0}) row(corner, target);
  return spin;
}

double spin_of(const SceneFile& file) { return after<M>(file, file.step).scene.bodies().velocity[1][2]; }

Case make() {
  return {
      .title = "A symmetric box bounces to one side",
      .report = "A box dropped flat on a symmetric floor bounces up turning, always the same way.",
      .link = "https://github.com/dimforge/rapier/issues/668",
      .law = 4,
      .why =
          "The left corner's row is solved first and stops the whole box by itself, which makes it turn. The "
          "right corner then meets a box that is already turning. After one sweep the corners' impulses differ. "
          "Two rows and (17) give the spin by hand.",
      .equation = {"Δλ = −(JV − e v)/K,  K = 1/m + s²/I",
                   R"(\Delta\lambda = -\frac{JV - e\,v}{K}, \quad K = \frac{1}{m} + \frac{s^2}{I})"},
      .numbers =
          [](const SceneFile& file) {
            SceneFile reversed = file;
            std::get<GaussSeidel>(reversed.method.solver).order = SweepOrder::reverse;
            return std::vector<Number>{{"spin after the bounce", "rad/s", spin_by_hand(3, 0.5, true),
                                        spin_of(file), "(17), two rows", 1e-6},
                                       {"spin, the right corner first", "rad/s", spin_by_hand(3, 0.5, false),
                                        spin_of(reversed), "(17), two rows", 1e-6}};
          },
      .engines = Question{"spin after the bounce", "rad/s", 0.1,
                          [](const Scene<M>& scene) { return scene.bodies().velocity[1][2]; }},
      .cure = "Solve both corners as one block, or sweep until nothing changes: then the box bounces straight up.",
      .cured =
          [](SceneFile file) {
            std::get<Scene<M>>(file.scene).set_contact_rows(ContactRows::manifold);
            return file;
          },
      .numbers_cured =
          [](const SceneFile& file) {
            const Simulation<M> box = after<M>(file, file.step);
            return std::vector<Number>{
                {"spin after the bounce", "rad/s", 0, box.scene.bodies().velocity[1][2], "symmetry", 1e-12},
                {"speed upwards", "m/s", 1.5, box.scene.bodies().velocity[1][1], "e v", 1e-6}};
          },
      .takeaway = "Gauss–Seidel is not symmetric, even where the scene is. Blocks and convergence are."};
}
const bool told = tell(__FILE__, make);

}  // namespace
}  // namespace byhand::cases
