// Deeper: what stays wrong when the error is fed in every step.

#include "lessons/04_baumgarte/runs.hpp"
#include "lessons/04_baumgarte/steps.hpp"
#include "lessons/laws/closed_forms.hpp"

namespace byhand::baumgarte {
namespace {

/// A bob that has gone round until its rod no longer changes.
struct Spin {
  double turn;     // ωh, angle of one step [1]
  double stretch;  // C/L [1]
};

Spin settled(const Setting& setting, double beta, double turn) {
  const int steps = 100 + static_cast<int>(30 / std::clamp(std::min(beta, 2 - beta), 0.01, 1.0));
  const double h = setting.h();
  const Track run = circling(setting, turn / h * setting.length, Baumgarte{beta}, h, steps);
  const Vector before = run[run.size() - 2].position, after = run.back().position;
  return {std::atan2(before.x() * after.y() - before.y() * after.x(), before.dot(after)),
          after.norm() / setting.length - 1};
}

}  // namespace

void steady_spin(const Setting& setting, Page& page) {
  const bool settles = setting.beta() <= 1.95;
  // Beyond, the rod does not settle, or takes too long: what follows is then told for a usual β.
  const double length = setting.length, beta = settles ? setting.beta() : 0.2,
               turn = setting.speed() * setting.h() / length;
  const Spin spin = settled(setting, beta, turn);
  const double law = laws::stretch_of_a_spinning_rod(spin.turn, beta);
  const Condition small = Quantity("ωh", turn) <= 0.1;

  if (!settles)
    page.text(setting.beta() < 2
                  ? "With β = @ the rod takes very long to settle. This step therefore uses β = 0.2."
                  : "With β = @ the rod never settles. This step therefore uses β = 0.2.",
              setting.beta);
  page.text(
      R"(β removes a share of the error. If every step also adds a new error, some error stays. Let the bob of step 1 circle again at @ m/s, now with β = @, until its rod no longer changes.)",
      setting.speed(), beta);
  const double answer = 1000 * spin.stretch * length, one_step = 500 * turn * turn * length;
  if (small)
    page.predict(
        {.ask = say(R"(In each step the tangent leaves the circle by ½(ωh)²L = @ mm. How much too long
                             is the rod once it has settled?)",
                    Value(one_step, 4)),
         .answer = answer,
         .unit = "mm",
         .tolerance = 0.03 * answer,
         .wrong = {{one_step, say("Each step adds @ mm, so βC must be that much; C itself is @.",
                                  Value(one_step, 4), beta < 1 ? "larger" : "smaller")},
                   {0, "Each step adds drift; with C = 0 the correction would remove nothing to balance it."}},
         .hints = {"Once the rod has settled, a step adds as much error as it removes.",
                   "added: ½(ωh)²L; removed: βC.",
                   beta == 1
                       ? say("C = @ mm, since one step removes all of it.", Value(one_step, 4))
                       : say("@ · C = @ mm: @ mm/@ = …", beta, Value(one_step, 4), Value(one_step, 4), beta)},
         .hinted = one_step / beta,
         .right =
             say("@", Value(one_step / beta, 4)) == say("@", Value(answer, 4))
                 ? say("C = ½(ωh)²L/β = @ mm; the run settles there, to the digits shown.", Value(answer, 4))
                 : say(
                       R"(With the first ω, C = ½(ωh)²L/β = @ mm. On the longer rod the bob goes round more slowly: the run
                     settles at @ mm.)",
                       Value(one_step / beta, 4), Value(answer, 4))});
  page.formula(
      "βC = ½(ωh)²L   ⟹   C/L = (ωh)²/(2β) = @ for ωh = @",
      R"(\beta C = \tfrac12(\omega h)^2 L \quad\Rightarrow\quad \frac{C}{L} = \frac{(\omega h)^2}{2\beta} = @
                  \text{ for } \omega h = @)",
      law, spin.turn);
  const auto shown = [](double value) { return say("@", value); };
  if (!small)
    page.text(R"(The law is the first term of an expansion in ωh, and this ωh is too large for it: the rod in fact
              stays too long by C/L = @.)",
              spin.stretch);
  else
    page.text(shown(spin.stretch) == shown(law)
                  ? std::string("The run ends at the same C/L, to the digits shown.")
                  : say("The run ends@ at C/L = @, because a step's drift is really ½(ωh)²|d|, with |d| = L + C.",
                        spin.stretch > law ? " slightly higher," : "", spin.stretch));
  page.derivation(
      "The stretch of a spinning rod",
      {{"the step h·v is at right angles to d (step 1)", "|d′|² = |d|² + (h v)²", R"(|d'|^2 = |d|^2 + (hv)^2)"},
       {"square root, for small ωh = hv/L", "added to C: ½(ωh)²L", R"(\tfrac12(\omega h)^2 L)"},
       {"a step removes the share β (step 2)", "removed from C: βC", R"(\beta C)"},
       {"settled: added = removed", "C/L = (ωh)²/(2β)", R"(\frac{C}{L} = \frac{(\omega h)^2}{2\beta})"}});

  Chart chart{.x = {.label = "ωh, angle of one step (rad)", .scale = Scale::logarithmic},
              .y = {.label = "C/L", .scale = Scale::logarithmic}};
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
  chart.references.push_back({Reference::Across::x, 0.1, "ωh = 0.1"});
  page.figure(
      "steady_stretch",
      R"(Steady stretch of a spinning rod against the angle it turns in one step. Dashed: the law; beyond the dotted
              line the higher terms become visible.)",
      chart);
  page.text(
      R"(For small ωh, half the step leaves a quarter of the stretch, while the stretch only falls as 1/β. If you keep
      h/β, the stretch is proportional to h.)");
  page.measure("settled stretch", 1000 * spin.stretch, "mm per m");

  // Next in the expansion are ½β(C/L)² and ⅓(ωh)⁴ beside (ωh)².
  page.claim(
      "settled stretch, over L", spin.stretch, "1",
      is(law, "(ωh)²/(2β), ω settled", relative(spin.turn * spin.turn * (0.5 + 1 / beta) + 2e-15 / (law * beta))),
      small);
}

}  // namespace byhand::baumgarte
