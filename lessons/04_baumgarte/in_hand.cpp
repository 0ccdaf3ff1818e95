#include "lessons/04_baumgarte/steps.hpp"
#include "lessons/pictures/held_scene.hpp"
#include "lessons/scenes/pendulum.hpp"

namespace byhand::baumgarte {

course::Hold in_hand(const Setting& setting) {
  return {
      "rod_in_hand", "A bob on a rod that is corrected by β; it begins at rest, 30° from straight down.",
      [setting] {
        const double length = setting.length, beta = setting.beta();
        // One cold sweep, the hand's rows last: the rod answers the hand only in the next step, so that a pull of
        // the force F stretches it, by Fh²/(mβ).
        return pictures::in_hand<PlaneParticle>(
            {.start = {pendulum<PlaneParticle, NormalisedDistance>(radians(30), length, setting.mass),
                       {GaussSeidel{.sweeps = 1, .warm_start = false}, Baumgarte{beta}}},
             .h = setting.h(),
             .view = {-1.3 * length, -1.5 * length, 2.6 * length, 2.6 * length},
             .body = "bob",
             .law = beta > 2
                        ? course::say("With β = @ a step multiplies the error by 1 − β = @: it grows.", beta,
                                      1 - beta)
                        : "Below β = 2 the error of a rod at rest shrinks; this bob moves too far in one step, "
                          "so try a smaller h."});
      }};
}

}  // namespace byhand::baumgarte
