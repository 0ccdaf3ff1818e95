#include "lessons/03_iterations/knobs.hpp"
#include "lessons/laws/closed_forms.hpp"
#include "lessons/pictures/held_scene.hpp"

namespace byhand::iterations {
namespace {

/// How much too long, or too short, the link is that is stretched most.
std::string stretch_in_words(const Simulation<PlaneParticle>& chain) {
  double most = 0;
  const auto& pose = chain.scene.bodies().pose;
  for (const auto& rod : chain.scene.all<Distance>()) {
    const double off = rod.at.separation(pose[rod.at.body1], pose[rod.at.body2]).norm() - rod.length;
    if (std::abs(off) > std::abs(most)) most = off;
  }
  const double size = chain.scene.all<Distance>()[0].length, off = 100 * course::without_rounding(most, size);
  if (off == 0) return "Every link has its length.";
  return course::say("The worst link is @ cm too @.", course::Value(std::abs(off), 3), off > 0 ? "long" : "short");
}

}  // namespace

course::Hold in_hand(const Knobs& knobs) {
  return {
      "chain_in_hand", "The chain; it begins at the angle of its release.", [knobs] {
        ChainOptions chain = knobs.chain();
        chain.angle = knobs.angle * M_PI / 180;
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
             .law = warm && beta > limit
                        ? course::say("With a warm start β may be min((1 − q)/q, 2) = @ at most; here it is @.",
                                      limit, beta)
                        : "A chain bears a time step of about the shortest period of its links; try a smaller h.",
             .says = stretch_in_words});
      }};
}

}  // namespace byhand::iterations
