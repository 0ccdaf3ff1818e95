// Deeper: springs by hand.

#include <cmath>

#include "lessons/08_where_methods_fail/laws/soft.hpp"
#include "lessons/08_where_methods_fail/map.hpp"
#include "lessons/08_where_methods_fail/steps.hpp"

namespace byhand::failures {
namespace {

using namespace tutor;
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
      R"(Add −kx − cv to the forces before a step, as one adds gravity: that is a spring by hand. Swinging freely
      it is stable while ωh < @. Damping calms a swing, so a damped one should bear more.)",
      without);
  page.predict(
      {.ask = "Critically damped, ζ = 1: up to which ωh is an explicit spring stable?",
       .answer = measured(1),
       .unit = "1",
       .tolerance = 0.05,
       .wrong = {{2, "That is without damping. Damping is a force of last step's velocity, and overshoots too."},
                 {4,
                  R"(Damping is explicit as well: it pushes with last step's velocity, and too much of it turns the
                  mass round in one step.)"}},
       .hints = {"For a very stiff damper, what is the velocity after one step?"},
       .right = "2(√2 − 1): damping makes it worse."});
  page.formula(
      "ωh < 2(√(1 + ζ²) − ζ):   @ at ζ = 0, @ at ζ = 1",
      R"(\omega h < 2\left(\sqrt{1 + \zeta^2} - \zeta\right): \quad @ \text{ at } \zeta = 0, \; @ \text{ at } \zeta = 1)",
      without, Value(critical, 3));
  const Map map = map_of(page, knob("damping ratio ζ (1)", 0, 3, setting.resolution, renderer::Scale::linear),
                         knob("ωh (1)", 0.1, 4, setting.resolution),
                         [](double zeta, double omega_h) { return laws::explicit_spring(omega_h, zeta); });
  const double foreseen =
      share_foreseen(map, [](double zeta, double omega_h) { return omega_h < largest_omega_h(zeta); });
  page.figure("damping_and_frequency", "Each cell is a run of one mass on an explicit spring. Dashed: the law.",
              chart(map, "ωh = 2(√(1 + ζ²) − ζ)", largest_omega_h));
  page.text(
      R"(Written as a soft row, γ = 1/(h(c + hk)), the same spring is stable for every ωh and ζ (lesson 6). Of @
      runs the law foresees @ %.)",
      map.outcomes.size(), Value(100 * foreseen, 3));
  page.claim({.quantity = "share of runs that end as the law says",
              .unit = "1",
              .expected = 0.95,
              .source = "law B11",
              .measured = foreseen,
              .tolerance = at_least(),
              .claimed = setting.resolution >= 10,
              .range = "10 cells a side or more"});
  for (const double zeta : {0.0, 1.0, 2.0})
    page.claim({.quantity = say("largest ωh at ζ = @, by bisection", zeta),
                .unit = "1",
                .expected = largest_omega_h(zeta),
                .source = "law B11",
                .measured = measured(zeta),
                .tolerance = relative(0.01)});
}

}  // namespace byhand::failures
