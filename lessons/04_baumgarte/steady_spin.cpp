// Deeper: what stays wrong when the error is fed in every step.

#include <algorithm>
#include <array>
#include <cmath>

#include "lessons/04_baumgarte/runs.hpp"
#include "lessons/04_baumgarte/steps.hpp"

namespace byhand::baumgarte {
namespace {

using namespace tutor;
using namespace renderer;

/// A bob that has gone round until its rod no longer changes.
struct Spin {
  double turn;     // ωh, angle of one step [1]
  double stretch;  // C/L [1]
};

Spin settled(const Setting& setting, double beta, double turn) {
  const int steps = 100 + static_cast<int>(30 / std::clamp(std::min(beta, 2 - beta), 0.01, 1.0));
  const double h = setting.h();
  const Track run = circling(setting, turn / h * setting.length(), Baumgarte{beta}, h, steps);
  const Vector before = run[run.size() - 2].position, after = run.back().position;
  return {std::atan2(before.x() * after.y() - before.y() * after.x(), before.dot(after)),
          after.norm() / setting.length() - 1};
}

double law(const Spin& spin, double beta) { return spin.turn * spin.turn / (2 * beta); }

}  // namespace

void steady_spin(const Setting& setting, Page& page) {
  const double length = setting.length(), beta = setting.beta(), turn = setting.speed() * setting.h() / length;
  const Spin spin = settled(setting, beta, turn);
  const bool settles = beta <= 1.95;
  const bool claimed = settles && turn <= 0.1;

  page.text(
      R"(β removes a share of what is wrong. Where every step puts a new error in, a share of it stays. Let the bob
      of step 1 go round again at @ m/s, now with β = @, until nothing changes any more.)",
      setting.speed(), setting.beta);
  const double answer = 1000 * spin.stretch * length, one_step = 500 * turn * turn * length;
  if (claimed)
    page.predict(
        {.ask =
             say(R"(In each step its tangent leaves the circle by ½(ωh)²L = @ mm. By how much is the rod too long
                 once it has settled?)",
                 one_step),
         .answer = answer,
         .unit = "mm",
         .tolerance = 0.03 * answer,
         .wrong = {{one_step, "That is what one step adds; the share β that is taken away must be as much."},
                   {0, "Then there would be nothing of which β could take a share."}},
         .hints = {"What comes in, ½(ωh)²L, must be what goes out, βC."},
         .right = "ω is the settled one: the rod is longer, so the bob goes round more slowly."});
  page.formula(
      "βC = ½(ωh)²L   ⟹   C/L = (ωh)²/(2β) = @",
      R"(\beta C = \tfrac12(\omega h)^2 L \quad\Rightarrow\quad \frac{C}{L} = \frac{(\omega h)^2}{2\beta} = @)",
      law(spin, beta));

  Chart chart{.x = {.label = "ωh, angle of one step (rad)", .scale = Scale::logarithmic},
              .y = {.label = "C/L (1)", .scale = Scale::logarithmic}};
  for (const double b : {0.1, 0.2, 0.5, 1.0}) {
    Curve measured{.label = say("β = @", b), .style = CurveStyle::markers},
        expected{.label = b == 1 ? "(ωh)²/2β" : "", .style = CurveStyle::theory};
    for (const double t : {0.01, 0.02, 0.04, 0.07, 0.1, 0.2, 0.4, 0.8}) {
      const Spin found = settled(setting, b, t);
      measured.x.push_back(found.turn);
      measured.y.push_back(found.stretch);
    }
    expected.x = {0.01, 0.8};
    for (const double t : expected.x) expected.y.push_back(t * t / (2 * b));
    chart.curves.push_back(measured);
    chart.curves.push_back(expected);
  }
  chart.references.push_back({Reference::Across::x, 0.1, "claimed up to here"});
  page.figure("steady_stretch",
              R"(How much too long a spinning rod stays, over the angle that it turns in one step. Dashed: the law,
              which is the first term of an expansion; to the right of the thin line the next ones show.)",
              chart);
  page.text(
      R"(Half the step, a quarter of the stretch; β can buy no more than a factor. If you keep h/β, as the time
      asks, the stretch goes with h.)");
  page.measure("settled stretch", 1000 * spin.stretch, "mm per m");

  // Next in the expansion are ½β(C/L)² and ⅓(ωh)⁴ beside (ωh)².
  page.claim({.quantity = "settled stretch, over L",
              .unit = "1",
              .expected = law(spin, beta),
              .source = "law B1: (ωh)²/(2β), ω settled",
              .measured = spin.stretch,
              .tolerance = relative(spin.turn * spin.turn * (0.5 + 1 / beta) + 2e-15 / (law(spin, beta) * beta)),
              .claimed = claimed,
              .range = "ωh ≤ 0.1, β ≤ 1.95"});
}

}  // namespace byhand::baumgarte
