#include "lessons/03_iterations/knobs.hpp"
#include "lessons/laws/closed_forms.hpp"
#include "lessons/pictures/held_scene.hpp"

namespace byhand::iterations {

course::Hold in_hand(const Knobs& knobs) {
  return {
      "chain_in_hand", "The chain; it begins at the angle of its release.", [knobs] {
        ChainOptions chain = knobs.chain();
        chain.angle = knobs.angle() * M_PI / 180;
        const bool warm = knobs.warm() == 1;
        const double beta = knobs.beta, whole = chain.links * chain.length,
                     limit = laws::largest_beta(laws::left_by_sweeps(chain.links, knobs.sweeps()));
        return pictures::in_hand<PlaneParticle>(
            {.start = {rod_chain<PlaneParticle>(chain),
                       {GaussSeidel{.sweeps = knobs.sweeps, .warm_start = warm}, Baumgarte{beta}}},
             .h = knobs.h,
             .view = {-1.1 * whole, -1.1 * whole, 2.2 * whole, 1.4 * whole},
             .body = "bob",
             .unit_of_C = "m²",
             .law =
                 warm && beta > limit
                     ? course::say("With a warm start β may be min((1 − q)/q, 2) = @ at most; here it is @.",
                                   limit, beta)
                     : "A chain bears a time step of about the shortest period of its links; try a smaller h."});
      }};
}

}  // namespace byhand::iterations
