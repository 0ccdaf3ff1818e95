// Deeper: explicit springs.

#include "lessons/08_where_methods_fail/growing_mode.hpp"
#include "lessons/08_where_methods_fail/map.hpp"
#include "lessons/08_where_methods_fail/steps.hpp"
#include "lessons/laws/soft.hpp"

namespace byhand::failures {
namespace {

using laws::Outcome;

/// The largest ωh of an explicit spring.
double largest_omega_h(double damping_ratio) {
  return 2 * (std::sqrt(1 + damping_ratio * damping_ratio) - damping_ratio);
}

double measured(double damping_ratio) {
  const double law = largest_omega_h(damping_ratio);
  return laws::bisect(
      [=](double omega_h) { return laws::explicit_spring(omega_h, damping_ratio) == Outcome::settles; }, 0.5 * law,
      2 * law, 0.001);
}

}  // namespace

void springs(const Setting& setting, Page& page) {
  const double without = largest_omega_h(0), critical = largest_omega_h(1);

  page.text(
      R"(Add −kx − cẋ to the forces before a step, as gravity is added: that is an *explicit spring* (a
      penalty force).
      Undamped, it is stable while ωh < @. Damping removes energy, so a damped spring should bear a longer step. Does
      it?)",
      without);
  page.predict(
      {.ask = "Critically damped, ζ = 1: what is the largest ωh at which an explicit spring is stable?",
       .answer = critical,
       .unit = "1",
       .tolerance = 0.05,
       .wrong = {{2, "That is without damping. The damping force is explicit too, and it too overshoots."},
                 {4,
                  R"(Damping is explicit too: it acts on the velocity of the last step, and too much of it reverses
                     that velocity within one step.)"}},
       .hints = {"At the limit, what does the oscillation do from one step to the next?",
                 "z² − (2 − 2ζs − s²) z + (1 − 2ζs) = 0 with s = ωh, and z = −1 at the limit.",
                 "z = −1: s² + 4ζs = 4, so for ζ = 1: √8 − 2 = …"},
       .right = say("2(√2 − 1); bisection between runs gives @. Damping makes it worse.", Value(measured(1), 4))});
  growing_mode(page);
  page.formula(
      "ωh < 2(√(1 + ζ²) − ζ):   @ at ζ = 0, @ at ζ = 1",
      R"(\omega h < 2\left(\sqrt{1 + \zeta^2} - \zeta\right): \quad @ \text{ at } \zeta = 0, \; @ \text{ at } \zeta = 1)",
      without, Value(critical, 3));
  page.derivation(
      "Why ωh < 2(√(1 + ζ²) − ζ)",
      {{"symplectic Euler with k = mω², c = 2ζmω", "v' = v − h(ω²x + 2ζωv),   x' = x + hv'",
        R"(v' = v - h(\omega^2x + 2\zeta\omega v), \quad x' = x + hv')"},
       {"insert zⁿ, with s = ωh", "z² − (2 − 2ζs − s²) z + (1 − 2ζs) = 0",
        R"(z^2 - (2 - 2\zeta s - s^2)\,z + (1 - 2\zeta s) = 0)"},
       {"a root reaches z = −1 where", "4 − 4ζs − s² = 0", R"(4 - 4\zeta s - s^2 = 0)"},
       {"the positive root", "s = 2(√(1 + ζ²) − ζ)", R"(s = 2\left(\sqrt{1 + \zeta^2} - \zeta\right))"}});
  const Map map = map_of(page, knob("damping ratio ζ", 0, 3, setting.resolution, renderer::Scale::linear),
                         knob("ωh", 0.1, 4, setting.resolution),
                         [](double zeta, double omega_h) { return laws::explicit_spring(omega_h, zeta); });
  const Agreement agreed = agreement(map, largest_omega_h, Settles::below);
  page.figure(
      "damping_and_frequency", "Each cell is one run of a mass on an explicit spring. Dashed: the law.",
      chart(map, "ωh = 2(√(1 + ζ²) − ζ)", [](double zeta) { return zeta < 0 ? NAN : largest_omega_h(zeta); }));
  page.text("@ Written as a soft row, γ = 1/(h(c + hk)), the same spring is stable for every ωh and ζ (lesson 6).",
            agreed.sentence());
  claim_agreement(page, agreed, 0.15, "law of explicit springs", setting.resolution);
  for (const double zeta : {0.0, 1.0, 2.0})
    page.claim(say("largest ωh at ζ = @, by bisection", zeta), measured(zeta), "1",
               is(largest_omega_h(zeta), "law of explicit springs", relative(0.01)));
}

}  // namespace byhand::failures
