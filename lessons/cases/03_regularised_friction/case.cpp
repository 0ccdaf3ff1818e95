#include "lessons/cases/case.hpp"

namespace byhand::cases {
namespace {

using M = PlaneParticle;

/// The speed along the slope after some time [m/s].
double creep(const SceneFile& file, double friction, double seconds = 1) {
  Simulation<M> block = begin<M>(file);
  block.scene.change_all<Friction>([=](Friction<M>& slip) { slip.coefficient = friction; });
  const long steps = std::lround(seconds / file.step);
  for (long i = 0; i < steps; ++i) block.step(file.step);
  return block.scene.bodies().velocity[1].x();
}

Case make() {
  return {
      .title = "No friction is large enough to hold a load",
      .report =
          "A body creeps although friction should hold it many times over, at the same speed for every μ; only "
          "another parameter of the solver changes that.",
      .link =
          "https://github.com/newton-physics/newton/issues/3943 and "
          "https://github.com/google-deepmind/mujoco/issues/3328",
      .law = 10,
      .why =
          "A regularised friction row has a softness γ: it asks for JV + γλ = 0, not for JV = 0. While it sticks, "
          "λ = Wh holds the load W, so the body moves at γWh. μ appears only in the bound |λ| ≤ μλ_n, which is "
          "not reached.",
      .equation = {"v = γ·W·h", R"(v = \gamma W h)"},
      .numbers =
          [](const SceneFile& file) {
            const auto& scene = std::get<Scene<M>>(file.scene);
            const double load = scene.gravity.x() / scene.bodies().inverse_mass[1].linear,
                         expected = scene.all<Friction>()[0].softness * load * file.step;
            return std::vector<Number>{
                {"creep with μ = 1", "m/s", expected, creep(file, 1), "(17) with γ", 1e-6},
                {"creep with μ = 1000", "m/s", expected, creep(file, 1000), "(17) with γ", 1e-6}};
          },
      .cure =
          "A hard friction row, γ = 0, with its bound. Where a solver needs regularisation, make it small beside "
          "JM⁻¹Jᵀ: the creep is in proportion to it.",
      .cured =
          [](SceneFile file) {
            std::get<Scene<M>>(file.scene).change_all<Friction>([](Friction<M>& slip) { slip.softness = 0; });
            return file;
          },
      .numbers_cured =
          [](const SceneFile& file) {
            return std::vector<Number>{{"creep with μ = 1", "m/s", 0, creep(file, 1), "JV = 0", 1e-12}};
          },
      .takeaway =
          "μ says how strong friction may be, γ how soft it is. A creep that does not depend on μ is softness."};
}
const bool told = tell(__FILE__, make);

}  // namespace
}  // namespace byhand::cases
