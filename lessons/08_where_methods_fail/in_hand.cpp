// What a reader holds: the stack of step 1 and the chain of step 3.

#include "lessons/08_where_methods_fail/steps.hpp"
#include "lessons/laws/transverse.hpp"
#include "lessons/pictures/held_scene.hpp"
#include "lessons/scenes/boxes.hpp"
#include "lessons/scenes/chain.hpp"

namespace byhand::failures {

course::Hold stack_in_hand(const Setting& setting) {
  return {
      "stack_in_hand",
      R"(The stack with few sweeps a step. Pull a box a little to one side and let it go: does the stack come back, or
          does it lean further until it falls?)",
      [setting] {
        const int top = setting.boxes;
        const double height = top;
        const auto lean = [top](const Simulation<PlaneBody>& run) {
          const double off = run.scene.bodies().pose[top].position.x();
          return say("The top box is off by @ mm.", Value(without_rounding(1000 * std::abs(off), 1000), 3));
        };
        return pictures::in_hand<PlaneBody>(
            {.start = {stack(setting.boxes), {GaussSeidel{setting.sweeps}, Baumgarte{.slop = 0.1}}},
             .h = step,
             .view = {-0.7 * height, -0.1 * height, 1.4 * height, 1.15 * height},
             .body = "box",
             .law = "A step must not carry a box through another.",
             .says = lean});
      }};
}

course::Hold chain_in_hand(const Setting& setting) {
  return {
      "chain_in_hand",
      R"(The chain with its end mass, solved exactly at 60 steps a second. Swing it: a light end swings; an end heavier
          than the limit tears the chain apart, sooner the further it is pulled aside.)",
      [setting] {
        const laws::TautChain chain{.end_mass = setting.end_mass};
        const double length = chain.links * chain.length, limit = laws::heaviest_end(chain);
        return pictures::in_hand<PlaneParticle>(
            {.start = {rod_chain<PlaneParticle, NormalisedDistance>({.links = chain.links,
                                                                     .length = chain.length,
                                                                     .mass = chain.mass,
                                                                     .end_mass = chain.end_mass,
                                                                     .angle = 0.25}),
                       {Direct{}, Baumgarte{chain.beta}}},
             .h = chain.step,
             .view = {-length, -1.3 * length, 2 * length, 1.5 * length},
             .body = "bob",
             .law = say("Law 7: at rest this chain bears @ kg at its end.", Value(limit, 3)),
             .reach = 0.5 * chain.length,
             .draw = [end_mass = chain.end_mass](Canvas& canvas, const Scene<PlaneParticle>& scene) {
               pictures::draw(canvas, pictures::rods_and_bobs(scene),
                              {.bob = std::min(12.0, 60 / std::cbrt(end_mass)), .rod = 5});
             }});
      }};
}

}  // namespace byhand::failures
