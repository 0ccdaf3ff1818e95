#include "lessons/cases/case.hpp"

namespace byhand::cases {
namespace {

using M = PlaneBody;

double speed_after_a_step(const SceneFile& file) {
  return after<M>(file, file.step).scene.bodies().velocity[1].y();
}

Case make() {
  return {.title = "The correction feeds energy",
          .report =
              "A Baumgarte bias fed energy into the scene: boxes that overlapped were thrown, stacks crawled, "
              "bounces gained speed; soft rows cured all three.",
          .link = "https://github.com/w0rm/elm-physics/pull/126",
          .law = 2,
          .why =
              "(22) asks for the velocity −(β/h)C. The row has no other way to move a body than to give it that "
              "velocity, and the velocity stays when the overlap is gone. A box that starts at a depth d leaves "
              "the ground at βd/h.",
          .equation = {"v = β·d/h", R"(v = \frac{\beta d}{h})"},
          .numbers =
              [](const SceneFile& file) {
                const double depth = 0.5 - std::get<Scene<M>>(file.scene).bodies().pose[1].position.y(),
                             beta = std::get<Baumgarte>(file.method.drift).beta;
                return std::vector<Number>{{"speed after the first step", "m/s", beta * depth / file.step,
                                            speed_after_a_step(file), "(22)", 1e-6}};
              },
          .engines = Question{"height of the box's middle after 0.25 s", "m", 0.25,
                              [](const Scene<M>& scene) { return scene.bodies().pose[1].position.y(); }},
          .cure =
              "Split impulse: the correction moves the poses with a velocity of its own, which is then forgotten. "
              "A cap on the bias lowers the jump; soft rows relax it away in the same step.",
          .cured =
              [](SceneFile file) {
                file.method.drift = SplitImpulse{.beta = 0.2};
                return file;
              },
          .numbers_cured =
              [](const SceneFile& file) {
                return std::vector<Number>{
                    {"speed after the first step", "m/s", 0, speed_after_a_step(file), "JV = 0", 1e-9}};
              },
          .takeaway = "A bias is a velocity. Whatever it corrects, it also throws."};
}
const bool told = tell(__FILE__, make);

}  // namespace
}  // namespace byhand::cases
